// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometries.h"

using namespace GeometryTests;



TEST(Geometry, EveryNameBuildsAMesh)
{
  for (const std::string &name : all_geometries<2>().names())
  {
    SCOPED_TRACE(name);
    if (name == "mesh file")
      continue;
    const auto each = geometry(name);
    each->check();
    dealii::Triangulation<2> triangulation;
    each->create(triangulation);
    EXPECT_GT(triangulation.n_active_cells(), 50u);
    EXPECT_LT(triangulation.n_active_cells(), 500u);
    BoundaryIds named;
    for (const auto &entry : each->boundary_ids())
      named.insert(entry.second.begin(), entry.second.end());
    const auto present = triangulation.get_boundary_ids();
    EXPECT_EQ(named, BoundaryIds(present.begin(), present.end()));
  }
}


// n_coarse_cells() within a third of what is there, and the same names and
// boundaries with a quarter of the cells
TEST(Geometry, CoarserCellsLeaveTheDomainAsItIs)
{
  for (const std::string &name : all_geometries<2>().names())
  {
    SCOPED_TRACE(name);
    const auto each = geometry(name);
    if (name == "mesh file")
    {
      EXPECT_FALSE(each->n_coarse_cells());
      EXPECT_EQ(each->coarser(2.), nullptr);
      continue;
    }
    dealii::Triangulation<2> fine, coarse;
    each->create(fine);
    each->coarser(2.)->create(coarse);
    EXPECT_NEAR(*each->n_coarse_cells() / fine.n_active_cells(), 1., 1. / 3.);
    EXPECT_NEAR(4. * coarse.n_active_cells() / fine.n_active_cells(), 1., 0.5);
    EXPECT_EQ(coarse.get_boundary_ids(), fine.get_boundary_ids());
    for (const auto id : fine.get_boundary_ids())
      EXPECT_NEAR(
        boundary_length(coarse, id) / boundary_length(fine, id), 1., 0.03);
  }
}


TEST(Geometry, ParametersHaveASubsectionForEachName)
{
  GeometryParameters<2>    parameters;
  dealii::ParameterHandler prm;
  parameters.add_parameters(prm);
  prm.parse_input_from_string(
    "subsection Geometry\n set Name = rectangle\n"
    " subsection Rectangle\n set Upper corner = 3, 2\n"
    " set Cell size = 1\n end\n"
    " subsection Punctured strip\n"
    " set Width = 0\n end\nend\n");
  parameters.check();
  dealii::Triangulation<2> triangulation;
  parameters.chosen().create(triangulation);
  EXPECT_EQ(triangulation.n_active_cells(), 6u);
}


TEST(Geometry, SlitSquareAndLShape)
{
  const auto               square = geometry("slit square");
  dealii::Triangulation<2> triangulation;
  square->create(triangulation);
  EXPECT_EQ(triangulation.n_active_cells(), 400u);
  EXPECT_EQ(triangulation.n_used_vertices(), 21u * 21u + 10u);
  EXPECT_NEAR(boundary_length(triangulation, square->boundary_ids().at("slit")),
              1.,
              1e-12);

  const auto panel = geometry("L-shape", {{"Size", "10"}, {"Cell size", "1"}});
  dealii::Triangulation<2> l;
  panel->create(l);
  EXPECT_EQ(l.n_active_cells(), 75u);
  for (const auto &[name, length] :
       std::map<std::string, double>{{"left", 10.},
                                     {"top", 10.},
                                     {"right", 5.},
                                     {"bottom", 5.},
                                     {"reentrant horizontal", 5.},
                                     {"reentrant vertical", 5.}})
    EXPECT_NEAR(
      boundary_length(l, panel->boundary_ids().at(name)), length, 1e-12);
}


TEST(Geometry, QuadrilateralHasStraightSidesBetweenItsCorners)
{
  const auto membrane =
    geometry("quadrilateral",
             {{"Corners", "0,0 ; 48,44 ; 48,60 ; 0,44"}, {"Cells", "3, 4"}});
  membrane->check();
  dealii::Triangulation<2> triangulation;
  membrane->create(triangulation);
  EXPECT_EQ(triangulation.n_active_cells(), 12u);
  triangulation.refine_global(1);
  double area = 0.;
  for (const auto &cell : triangulation.active_cell_iterators())
    area += cell->measure();
  EXPECT_NEAR(area, 48. * (44. + 16.) / 2., 1e-10);
  for (const auto &[name, length] :
       std::map<std::string, double>{{"left", 44.},
                                     {"right", 16.},
                                     {"bottom", std::hypot(48., 44.)},
                                     {"top", std::hypot(48., 16.)}})
    EXPECT_NEAR(
      boundary_length(triangulation, membrane->boundary_ids().at(name)),
      length,
      1e-10)
      << name;
}


TEST(Geometry, RefusalsOfTheQuadrilateral)
{
  const auto refused = [](const Entries &entries, const std::string &part) {
    expect_refused("quadrilateral", entries, part);
  };
  refused({{"Corners", "0,0 ; 1,0 ; 1,1"}}, "4 points");
  refused({{"Corners", "0,0 ; 1,0 ; 1,1,2 ; 0,1"}}, "2 numbers");
  // clockwise, a corner that points inwards, three on a line, a corner twice
  refused({{"Corners", "0,0 ; 0,1 ; 1,1 ; 1,0"}}, "turn left");
  refused({{"Corners", "0,0 ; 4,0 ; 1,1 ; 0,4"}}, "at (1, 1)");
  refused({{"Corners", "0,0 ; 1,0 ; 2,0 ; 0,1"}}, "at (1, 0)");
  refused({{"Corners", "0,0 ; 0,0 ; 1,1 ; 0,1"}}, "turn left");
  refused({{"Cells", "4"}}, "2 numbers");
  refused({{"Cells", "0, 4"}}, "integers from 1");
}


TEST(Geometry, RefusalsOfTheOthers)
{
  expect_refused("slit square", {{"Size", "0"}}, "Slit square/Size is 0");
  expect_refused("slit square", {{"Slit height", "1"}}, "Slit height is 1");
  expect_refused("slit square", {{"Slit length", "0"}}, "Slit length is 0");
  expect_refused("slit square", {{"Cell size", "2"}}, "Cell size is 2");
  expect_refused("rectangle",
                 {{"Upper corner", "1, 0"}},
                 "Rectangle/Upper corner is (1, 0)");
  expect_refused("rectangle", {{"Cell size", "0"}}, "Cell size is 0");
  expect_refused("L-shape", {{"Size", "0"}}, "L-shape/Size is 0");
  expect_refused("L-shape", {{"Cell size", "0.1"}}, "2.5e+07 coarse cells");
}
