// SPDX-License-Identifier: GPL-2.0-or-later
// The meshes in 3-d, against measures known exactly and those of the plane.
#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometries.h"

using namespace GeometryTests;
using dealii::Point;
using dealii::Triangulation;

namespace
{
  constexpr double thickness = 2.5;

  std::unique_ptr<Geometry<3>>
  body(const std::string &name, const Entries &entries = {})
  {
    auto                     result = all_geometries<3>().make(name);
    dealii::ParameterHandler prm;
    result->add_parameters(prm);
    result->take_thickness_from(thickness);
    for (const auto &[entry, value] : entries)
      prm.set(entry, value);
    return result;
  }

  std::string
  problem_of_body(const std::string &name, const Entries &entries)
  {
    try
    {
      body(name, entries)->check();
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }

  double
  area(const Triangulation<3> &triangulation,
       const Geometry<3>      &geometry,
       const std::string      &boundary)
  {
    const BoundaryIds ids    = geometry.boundary_ids().at(boundary);
    double            result = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && ids.contains(face->boundary_id()))
          result += face->measure();
    return result;
  }

  // to be found whatever the rounding
  std::array<long, 2>
  rounded(const double x, const double y)
  {
    return {{std::lround(1e8 * x), std::lround(1e8 * y)}};
  }
} // namespace



TEST(Geometry3d, EveryNameBuildsAMesh)
{
  for (const std::string &name : all_geometries<3>().names())
  {
    SCOPED_TRACE(name);
    if (name == "mesh file") // see test_mesh_file_3d.cc
      continue;
    const auto each = body(name);
    each->check();
    Triangulation<3> triangulation;
    each->create(triangulation);
    EXPECT_GT(triangulation.n_active_cells(), 50u);
    EXPECT_LT(triangulation.n_active_cells(), 500u);
    BoundaryIds named;
    for (const auto &entry : each->boundary_ids())
      named.insert(entry.second.begin(), entry.second.end());
    const auto present = triangulation.get_boundary_ids();
    EXPECT_EQ(named, BoundaryIds(present.begin(), present.end()));
    const auto box = dealii::GridTools::compute_bounding_box(triangulation);
    for (unsigned int d = 0; d < 3; ++d)
    {
      EXPECT_NEAR(box.lower_bound(d), each->extent()->lower_bound(d), 1e-12);
      EXPECT_NEAR(box.upper_bound(d), each->extent()->upper_bound(d), 1e-12);
    }
  }
}



TEST(Geometry3d, Box)
{
  const auto box = body("box",
                        {{"Lower corner", "-1, 0, 1"},
                         {"Upper corner", "1, 3, 5"},
                         {"Cells", "2, 3, 5"}});
  box->check();
  Triangulation<3> triangulation;
  box->create(triangulation);
  EXPECT_EQ(triangulation.n_active_cells(), 30u);
  EXPECT_NEAR(dealii::GridTools::volume(triangulation), 24., 1e-12);
  EXPECT_NEAR(area(triangulation, *box, "left"), 12., 1e-12);
  EXPECT_NEAR(area(triangulation, *box, "right"), 12., 1e-12);
  EXPECT_NEAR(area(triangulation, *box, "bottom"), 8., 1e-12);
  EXPECT_NEAR(area(triangulation, *box, "top"), 8., 1e-12);
  EXPECT_NEAR(area(triangulation, *box, "back"), 6., 1e-12);
  EXPECT_NEAR(area(triangulation, *box, "front"), 6., 1e-12);
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() &&
        box->boundary_ids().at("back").contains(face->boundary_id()))
    {
      EXPECT_EQ(face->center()[2], 1.);
    }
}



TEST(Geometry3d, SlitCube)
{
  const auto cube = body("slit cube",
                         {{"Size", "2"},
                          {"Slit height", "0.5"},
                          {"Slit length", "1.25"},
                          {"Cell size", "0.25"}});
  cube->check();
  Triangulation<3> triangulation;
  cube->create(triangulation);
  EXPECT_EQ(triangulation.n_active_cells(), 512u);
  // five of six nodes in x are doubled, for nine in z: the tip is not
  EXPECT_EQ(triangulation.n_used_vertices(), 9u * 9u * 9u + 5u * 9u);
  triangulation.refine_global(1);
  EXPECT_EQ(triangulation.n_used_vertices(), 17u * 17u * 17u + 10u * 17u);
  EXPECT_NEAR(dealii::GridTools::volume(triangulation), 8., 1e-12);
  // both faces of it
  EXPECT_NEAR(area(triangulation, *cube, "slit"), 2. * 1.25 * 2., 1e-12);
  for (const char *side : {"left", "right", "bottom", "top", "back", "front"})
    EXPECT_NEAR(area(triangulation, *cube, side), 4., 1e-12) << side;

  ASSERT_EQ(cube->slits().size(), 1u);
  const FlatPiece<3> tip = cube->named_places().at("slit tip");
  for (const Point<3> &vertex : triangulation.get_vertices())
  {
    const bool on_slit = vertex[1] == 0.5 && vertex[0] <= 1.25;
    const bool on_tip  = vertex[1] == 0.5 && vertex[0] == 1.25;
    EXPECT_EQ(distance(vertex, cube->slits()[0]) < 1e-12, on_slit) << vertex;
    EXPECT_EQ(distance(vertex, tip) < 1e-12, on_tip) << vertex;
  }
}



TEST(Geometry3d, LShape)
{
  const auto panel = body(
    "L-shape", {{"Size", "10"}, {"Cell size", "1"}, {"Thickness cells", "2"}});
  Triangulation<3> triangulation;
  panel->create(triangulation);
  EXPECT_EQ(triangulation.n_active_cells(), 150u);
  EXPECT_NEAR(dealii::GridTools::volume(triangulation), 75. * thickness, 1e-10);
  for (const auto &[name, length] :
       std::map<std::string, double>{{"left", 10.},
                                     {"top", 10.},
                                     {"right", 5.},
                                     {"bottom", 5.},
                                     {"reentrant horizontal", 5.},
                                     {"reentrant vertical", 5.}})
    EXPECT_NEAR(area(triangulation, *panel, name), length * thickness, 1e-11);
  EXPECT_NEAR(area(triangulation, *panel, "front"), 75., 1e-11);
  EXPECT_NEAR(area(triangulation, *panel, "back"), 75., 1e-11);
}



TEST(Geometry3d, Quadrilateral)
{
  const auto       membrane = body("quadrilateral",
                             {{"Corners", "1,2 ; 49,46 ; 49,62 ; 1,46"},
                                    {"Cells", "3, 4"},
                                    {"Thickness cells", "2"}});
  Triangulation<3> triangulation;
  membrane->create(triangulation);
  EXPECT_EQ(triangulation.n_active_cells(), 24u);
  EXPECT_NEAR(
    dealii::GridTools::volume(triangulation), 1440. * thickness, 1e-9);
  EXPECT_NEAR(area(triangulation, *membrane, "right"), 16. * thickness, 1e-10);
  EXPECT_NEAR(area(triangulation, *membrane, "front"), 1440., 1e-9);
}



// also its hole and the cells around it, however often it is refined
TEST(Geometry3d, StripIsThatOfThePlaneAtEveryHeight)
{
  const auto       strip = body("punctured strip", {{"Thickness cells", "2"}});
  const auto       flat  = geometry("punctured strip");
  Triangulation<3> triangulation;
  Triangulation<2> plane;
  strip->create(triangulation);
  flat->create(plane);
  EXPECT_EQ(triangulation.n_active_cells(), 2 * plane.n_active_cells());
  for (unsigned int level = 0; level <= 2; ++level)
  {
    SCOPED_TRACE(level);
    if (level > 0)
    {
      triangulation.refine_global(1);
      plane.refine_global(1);
    }
    std::set<std::array<long, 2>> expected, found;
    for (const Point<2> &vertex : plane.get_vertices())
      expected.insert(rounded(vertex[0], vertex[1]));
    for (const Point<3> &vertex : triangulation.get_vertices())
      found.insert(rounded(vertex[0], vertex[1]));
    EXPECT_EQ(found, expected);
    const double n_layers = 2. * std::pow(2., level);
    EXPECT_EQ(triangulation.n_used_vertices(),
              plane.n_used_vertices() * (n_layers + 1.));
    EXPECT_NEAR(dealii::GridTools::volume(triangulation),
                dealii::GridTools::volume(plane) * thickness,
                1e-8);
    for (const auto &[name, id] : flat->boundary_ids())
      EXPECT_NEAR(area(triangulation, *strip, name),
                  boundary_length(plane, id) * thickness,
                  1e-9)
        << name;
    EXPECT_NEAR(area(triangulation, *strip, "front"),
                dealii::GridTools::volume(plane),
                1e-9);
  }
}



TEST(Geometry3d, HoleIsAnExactCylinder)
{
  const auto       strip = body("punctured strip");
  const auto       hole  = strip->boundary_ids().at("hole");
  Triangulation<3> triangulation;
  strip->create(triangulation);
  double error = 2. * dealii::numbers::PI * 4. * thickness -
                 area(triangulation, *strip, "hole");
  for (unsigned int level = 1; level <= 2; ++level)
  {
    triangulation.refine_global(1);
    const double finer = 2. * dealii::numbers::PI * 4. * thickness -
                         area(triangulation, *strip, "hole");
    EXPECT_GT(finer, 0.);
    EXPECT_LT(finer, 0.26 * error);
    error = finer;
  }
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() && hole.contains(face->boundary_id()))
      for (const unsigned int v : face->vertex_indices())
      {
        const Point<2> seen(face->vertex(v)[0], face->vertex(v)[1]);
        EXPECT_NEAR(seen.distance({12., 18.}), 4., 1e-12);
      }
}



TEST(Geometry3d, IsTheSameOnEveryNumberOfRanks)
{
  for (const std::string name : {"punctured strip", "slit cube"})
  {
    dealii::parallel::distributed::Triangulation<3> triangulation(
      MPI_COMM_WORLD);
    Triangulation<3> serial;
    const auto       each = body(name);
    each->create(triangulation);
    each->create(serial);
    triangulation.refine_global(1);
    serial.refine_global(1);
    EXPECT_EQ(triangulation.n_global_active_cells(), serial.n_active_cells());
    double volume = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        volume += cell->measure();
    EXPECT_NEAR(dealii::Utilities::MPI::sum(volume, MPI_COMM_WORLD),
                dealii::GridTools::volume(serial),
                1e-9);
  }
}



TEST(Geometry3d, Refusals)
{
  const auto refuse =
    [](const std::string &name, const Entries &entries, const char *part) {
      const std::string message = problem_of_body(name, entries);
      EXPECT_NE(message.find(part), std::string::npos) << message;
    };
  refuse("box", {{"Upper corner", "1, 1, 0"}}, "Box/Upper corner is (1, 1, 0)");
  refuse("box", {{"Cell size", "2"}}, "Geometry/Box/Cell size is 2");
  refuse("box", {{"Cells", "2, 2"}}, "Geometry/Box/Cells: found '2, 2'");
  refuse("box", {{"Cells", "2, 2, 0"}}, "found 0, allowed are integers");
  refuse("box", {{"Cells", "2, 2, 1.5"}}, "found 1.5, allowed are integers");
  refuse("box", {{"Cells", "1e3, 1e3, 1e3"}}, "at most 1e+06 coarse cells");
  refuse("slit cube", {{"Slit height", "1"}}, "Slit cube/Slit height is 1");
  refuse("slit cube", {{"Cell size", "1e-3"}}, "1e+09 coarse cells");
  refuse("punctured strip",
         {{"Thickness cells", "100000"}},
         "Punctured strip/Thickness cells is 100000");
  refuse("L-shape",
         {{"Thickness cells", "100000"}},
         "L-shape/Thickness cells is 100000");
}
