// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometries.h"

using namespace GeometryTests;

namespace
{
  struct Quality
  {
    double scaled_jacobian = 1.; ///< least over all corners
    double aspect_ratio    = 1.; ///< longest by shortest edge, largest
    double share_above_two = 0.; ///< of the cells, aspect ratio > 2
  };

  Quality
  quality(const dealii::Triangulation<2> &triangulation)
  {
    const std::array<unsigned int, 4> around = {{0, 1, 3, 2}};
    Quality                           result;
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      double shortest = 1e300, longest = 0.;
      for (unsigned int i = 0; i < 4; ++i)
      {
        const dealii::Point<2> corner = cell->vertex(around[i]);
        const auto next = cell->vertex(around[(i + 1) % 4]) - corner;
        const auto last = cell->vertex(around[(i + 3) % 4]) - corner;
        shortest        = std::min(shortest, next.norm());
        longest         = std::max(longest, next.norm());
        result.scaled_jacobian =
          std::min(result.scaled_jacobian,
                   (next[0] * last[1] - next[1] * last[0]) /
                     (next.norm() * last.norm()));
      }
      result.aspect_ratio = std::max(result.aspect_ratio, longest / shortest);
      if (longest > 2. * shortest)
        result.share_above_two += 1. / triangulation.n_active_cells();
    }
    return result;
  }

  struct StripVariant
  {
    const char *what;
    Entries     entries;
    double      aspect_ratio; ///< not to be exceeded
  };

  // The paper's strips, and what else people do to strips
  const std::vector<StripVariant> strips = {
    {"notch at 6", {{"Notch height", "6"}}, 1.8},
    {"notch at 10", {{"Notch height", "10"}}, 1.8},
    {"notch at 12", {}, 1.8},
    {"notch at 14", {{"Notch height", "14"}}, 1.8},
    {"notch at 18", {{"Notch height", "18"}}, 1.8},
    {"no hole", {{"Hole radius", "0"}}, 1.3},
    {"no notch", {{"Notch length", "0"}}, 1.8},
    {"neither", {{"Hole radius", "0"}, {"Notch length", "0"}}, 1.1},
    {"long notch", {{"Notch height", "6"}, {"Notch length", "10"}}, 1.8},
    {"below", {{"Notch height", "13"}, {"Notch length", "10"}}, 3.2},
    {"passing", {{"Notch height", "13"}, {"Notch length", "19"}}, 3.2},
    {"above", {{"Notch height", "23"}, {"Notch length", "12"}}, 3.2},
    {"at the hole", {{"Notch height", "18"}, {"Notch length", "7"}}, 3.2},
    {"hole left", {{"Hole center", "5.5, 20"}}, 3.2},
    {"hole low", {{"Hole center", "10, 5"}}, 3.2},
    {"big hole", {{"Hole center", "10, 20"}, {"Hole radius", "7"}}, 4.5},
    {"small hole", {{"Hole radius", "1"}}, 2.3},
    {"tiny hole", {{"Hole radius", "0.1"}}, 2.6},
    {"fine", {{"Cell size", "0.5"}}, 2.1}};
} // namespace



TEST(PuncturedStrip, Quality)
{
  for (const StripVariant &strip : strips)
  {
    SCOPED_TRACE(strip.what);
    const auto each = geometry("punctured strip", strip.entries);
    each->check();
    dealii::Triangulation<2> triangulation;
    each->create(triangulation);
    for (const unsigned int n_refinements : {0, 2})
    {
      triangulation.refine_global(n_refinements);
      const Quality found = quality(triangulation);
      EXPECT_GT(found.scaled_jacobian, 0.55);
      EXPECT_LT(found.aspect_ratio, strip.aspect_ratio);
      EXPECT_LT(found.share_above_two, 0.15);
    }
  }
}


TEST(PuncturedStrip, IsOfModestSize)
{
  for (const char *height : {"6", "10", "12", "14", "18"})
  {
    dealii::Triangulation<2> triangulation;
    geometry("punctured strip", {{"Notch height", height}})
      ->create(triangulation);
    EXPECT_GT(triangulation.n_active_cells(), 300u);
    EXPECT_LT(triangulation.n_active_cells(), 500u);
  }
}


TEST(PuncturedStrip, AreaConverges)
{
  const auto               strip = geometry("punctured strip");
  dealii::Triangulation<2> triangulation;
  strip->create(triangulation);
  const double exact = 20. * 28. - dealii::numbers::PI * 16.;
  double error = std::abs(dealii::GridTools::volume(triangulation) - exact);
  for (unsigned int level = 1; level <= 3; ++level)
  {
    triangulation.refine_global(1);
    const double finer =
      std::abs(dealii::GridTools::volume(triangulation) - exact);
    EXPECT_LT(finer, 0.26 * error);
    error = finer;
  }
}


TEST(PuncturedStrip, Boundaries)
{
  const auto               strip = geometry("punctured strip");
  const auto               ids   = strip->boundary_ids();
  dealii::Triangulation<2> triangulation;
  strip->create(triangulation);
  triangulation.refine_global(2);
  EXPECT_NEAR(boundary_length(triangulation, ids.at("bottom")), 20., 1e-10);
  EXPECT_NEAR(boundary_length(triangulation, ids.at("top")), 20., 1e-10);
  EXPECT_NEAR(boundary_length(triangulation, ids.at("left")), 28., 1e-10);
  EXPECT_NEAR(boundary_length(triangulation, ids.at("right")), 28., 1e-10);
  // both faces of the slit, and each
  EXPECT_NEAR(boundary_length(triangulation, ids.at("notch")), 2., 1e-10);
  EXPECT_NEAR(boundary_length(triangulation, ids.at("notch lower")), 1., 1e-10);
  EXPECT_NEAR(boundary_length(triangulation, ids.at("notch upper")), 1., 1e-10);
  // equal chords of the circle
  double n_chords = 0.;
  for (const auto &face : triangulation.active_face_iterators())
    n_chords +=
      face->at_boundary() && ids.at("hole").contains(face->boundary_id());
  EXPECT_GE(n_chords, 128.);
  EXPECT_NEAR(boundary_length(triangulation, ids.at("hole")),
              8. * n_chords * std::sin(dealii::numbers::PI / n_chords),
              1e-3);

  EXPECT_EQ(geometry("punctured strip", {{"Hole radius", "0"}})
              ->boundary_ids()
              .count("hole"),
            0u);
  const auto whole = geometry("punctured strip", {{"Notch length", "0"}});
  EXPECT_EQ(whole->boundary_ids().count("notch"), 0u);
  EXPECT_TRUE(whole->slits().empty());
}


TEST(PuncturedStrip, SlitNodesAreDoubled)
{
  // length 1: one edge on the slit; length 6: five; the tip is not doubled
  for (const auto &[length, n_doubled] :
       std::map<std::string, unsigned int>{{"1", 1}, {"6", 5}})
  {
    const auto strip = geometry("punctured strip", {{"Notch length", length}});
    dealii::Triangulation<2> triangulation;
    strip->create(triangulation);
    unsigned int n_on_slit = 0;
    for (const dealii::Point<2> &vertex : triangulation.get_vertices())
      n_on_slit += std::abs(vertex[1] - 12.) < 1e-9 &&
                   vertex[0] < std::stod(length) + 1e-9;
    EXPECT_EQ(n_on_slit, 2 * n_doubled + 1);
    ASSERT_EQ(strip->slits().size(), 1u);
    EXPECT_EQ(strip->slits()[0].corners[1][0], std::stod(length));
    EXPECT_EQ(strip->slits()[0].corners[1][1], 12.);
  }
}


TEST(PuncturedStrip, HoleIsAnExactCircle)
{
  const dealii::Point<2>   center(12., 18.);
  const auto               strip = geometry("punctured strip");
  const auto               hole  = strip->boundary_ids().at("hole");
  dealii::Triangulation<2> triangulation;
  strip->create(triangulation);
  triangulation.refine_global(3);
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() &&
          hole.contains(cell->face(f)->boundary_id()))
      {
        EXPECT_NEAR(cell->face(f)->vertex(0).distance(center), 4., 1e-12);
      }
}


TEST(PuncturedStrip, IsTheSameOnEveryNumberOfRanks)
{
  dealii::parallel::distributed::Triangulation<2> triangulation(MPI_COMM_WORLD);
  dealii::Triangulation<2>                        serial;
  const auto strip = geometry("punctured strip");
  strip->create(triangulation);
  strip->create(serial);
  triangulation.refine_global(2);
  serial.refine_global(2);
  EXPECT_EQ(triangulation.n_global_active_cells(),
            serial.n_global_active_cells());
  double area = 0.;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      area += cell->measure();
  EXPECT_NEAR(dealii::Utilities::MPI::sum(area, MPI_COMM_WORLD),
              dealii::GridTools::volume(serial),
              1e-9);
}


TEST(PuncturedStrip, Refusals)
{
  const std::string strip  = "punctured strip";
  const auto        refuse = [&](const Entries &entries, const char *part) {
    expect_refused(strip, entries, part);
  };
  refuse({{"Width", "0"}}, "Geometry/Punctured strip/Width is 0");
  refuse({{"Height", "0"}}, "Geometry/Punctured strip/Height is 0");
  refuse({{"Cell size", "0"}}, "Geometry/Punctured strip/Cell size is 0");
  refuse({{"Cell size", "1e-3"}}, "at most 1e+06");
  refuse({{"Cell size", "21"}}, "shortest side of 20");
  refuse({{"Hole center", "16, 18"}}, "Hole center is (16, 18)");
  refuse({{"Hole center", "3, 18"}}, "it leaves -1 mm");
  refuse({{"Hole center", "40, 18"}}, "must lie inside the strip of 20 x 28");
  refuse({{"Hole radius", "1e-9"}}, "Hole radius is 1e-09");
  refuse({{"Notch height", "0"}}, "Notch height is 0");
  refuse({{"Notch height", "-3"}}, "Notch height is -3");
  refuse({{"Notch height", "28"}}, "the height of 28");
  refuse({{"Notch length", "20"}}, "less than the width of 20");
  refuse({{"Notch length", "1e-9"}}, "Notch length is 1e-09");
  refuse({{"Notch height", "18"}, {"Notch length", "9"}}, "runs into");
  refuse({{"Notch height", "17"}, {"Notch length", "19"}}, "runs into");
  refuse({{"Notch height", "14"}, {"Notch length", "12"}}, "runs into");
  refuse({{"Notch height", "14.5"}, {"Notch length", "9"}},
         "it must end at x <= 7.92 or run at y <= 13.92");
  EXPECT_EQ(problem(strip, {{"Notch height", "0"}, {"Notch length", "0"}}), "");
  for (const StripVariant &variant : strips)
    EXPECT_EQ(problem(strip, variant.entries), "") << variant.what;
}
