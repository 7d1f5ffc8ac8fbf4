// SPDX-License-Identifier: GPL-2.0-or-later
// The same body on other cells of the same size.
#include <deal.II/grid/grid_tools.h>

#include <problem/geometries/mirrored_mesh.h>
#include <problem/geometries/quad_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "geometries.h"

using namespace GeometryTests;

namespace
{
  using Lines = std::vector<double>;

  std::set<std::pair<double, double>>
  positions(const dealii::Triangulation<2> &mesh)
  {
    std::set<std::pair<double, double>> result;
    for (const dealii::Point<2> &vertex : mesh.get_vertices())
      result.emplace(vertex[0], vertex[1]);
    return result;
  }

  void
  expect_near(const Lines &found, const Lines &expected)
  {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-12);
  }

  double
  shortest_edge(const dealii::Triangulation<2> &mesh)
  {
    double result = 1e300;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        result = std::min(result, cell->face(f)->measure());
    return result;
  }
} // namespace



TEST(MirroredMesh, LinesInBetweenAreMirroredNeededOnesStay)
{
  const Lines fixed = {0., 8., 3.5};
  expect_near(mirrored_lines(grid_lines(fixed, 1.), fixed, 1.),
              {0., 0.9, 1.8, 2.7, 3.5, 4.5, 5.375, 6.25, 7.125, 8.});
  // nothing to mirror: as it was
  const Lines symmetric = {0., 3., 6.};
  expect_near(mirrored_lines(grid_lines(symmetric, 1.), symmetric, 1.),
              grid_lines(symmetric, 1.));
}



TEST(MirroredMesh, CellsKeepThreeQuartersOfTheSizeAndAreNoLongerThanUsual)
{
  for (double position = 0.6; position < 9.5; position += 0.07)
  {
    const Lines fixed = {0., position, 10.};
    const Lines lines = mirrored_lines(grid_lines(fixed, 1.), fixed, 1.);
    for (const double needed : fixed)
      EXPECT_NE(std::find(lines.begin(), lines.end(), needed), lines.end());
    for (std::size_t i = 1; i < lines.size(); ++i)
    {
      const bool are_needed = lines[i - 1] == 0. && lines[i] == position;
      const bool are_last   = lines[i - 1] == position && lines[i] == 10.;
      if (!are_needed && !are_last)
      {
        EXPECT_GT(lines[i] - lines[i - 1], 0.75 - 1e-9) << position;
      }
      EXPECT_LT(lines[i] - lines[i - 1], 1.5 + 1e-9) << position;
    }
  }
}



TEST(MirroredMesh, TheStripIsTheSameOnOtherCells)
{
  for (const char *const height : {"6", "10", "12", "14", "18"})
    for (const char *const axes : {"x", "y", "x, y"})
    {
      SCOPED_TRACE(std::string(height) + " mirrored in " + axes);
      const auto usual =
        geometry("punctured strip", {{"Notch height", height}});
      const auto other = geometry(
        "punctured strip", {{"Notch height", height}, {"Mirrored mesh", axes}});
      other->check();
      dealii::Triangulation<2> mesh, mirrored;
      usual->create(mesh);
      other->create(mirrored);
      // of the boundary, but for how many edges the circle has
      for (const auto &[name, id] : usual->boundary_ids())
        EXPECT_NEAR(boundary_length(mirrored, id),
                    boundary_length(mesh, id),
                    name == "hole" ? 0.1 : 1e-9)
          << name;
      EXPECT_EQ(other->slits().size(), usual->slits().size());
      EXPECT_NEAR(dealii::GridTools::volume(mirrored),
                  dealii::GridTools::volume(mesh),
                  0.1);
      const double n_cells = mesh.n_active_cells();
      EXPECT_NEAR(mirrored.n_active_cells(), n_cells, 0.15 * n_cells);
      EXPECT_GT(shortest_edge(mirrored), 0.3);
      const auto   before = positions(mesh), now = positions(mirrored);
      unsigned int n_moved = 0;
      for (const auto &position : now)
        n_moved += before.count(position) == 0 ? 1 : 0;
      EXPECT_GT(n_moved, now.size() / 4);
    }
}



TEST(MirroredMesh, IsRefusedWhereNothingWouldChange)
{
  expect_refused("slit square",
                 {{"Mirrored mesh", "y"}},
                 "Slit square/Mirrored mesh: found 'y', but the grid lines of "
                 "constant y are their own mirror image");
  expect_refused("slit square",
                 {{"Slit height", "0.3"}, {"Mirrored mesh", "x, y"}},
                 "constant x");
  EXPECT_EQ(problem("slit square",
                    {{"Slit height", "0.4375"},
                     {"Cell size", "0.125"},
                     {"Mirrored mesh", "y"}}),
            "");
  expect_refused(
    "punctured strip", {{"Mirrored mesh", "none, x"}}, "'none' alone");
}
