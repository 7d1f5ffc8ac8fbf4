// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <discretization/refinement.h>

#include <problem/mesh_parameters.h>

#include <gtest/gtest.h>

using namespace MixedCracks;

namespace
{
  RefinementBox<2>
  box(const double       left,
      const double       bottom,
      const double       right,
      const double       top,
      const unsigned int levels)
  {
    return {dealii::BoundingBox<2>(
              {dealii::Point<2>(left, bottom), dealii::Point<2>(right, top)}),
            levels};
  }

  std::string
  problem(const std::string &boxes, const unsigned int adaptive_levels = 0)
  {
    MeshParameters<2> mesh;
    mesh.regions.boxes   = boxes;
    mesh.adaptive_levels = adaptive_levels;
    try
    {
      mesh.check({}, {});
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }

  void
  expect_refused(const std::string &boxes, const std::string &part)
  {
    const std::string message = problem(boxes);
    EXPECT_NE(message.find(part), std::string::npos)
      << "'" << part << "' is not in: " << message;
    EXPECT_EQ(message.find("Mesh/Refined boxes"), 0u) << message;
  }
} // namespace



TEST(Refinement, BoxesOnGridLinesCatchNoMoreCells)
{
  dealii::Triangulation<2> triangulation;
  dealii::GridGenerator::subdivided_hyper_cube(triangulation, 4);
  refine_globally_and_in_regions<2>(
    triangulation, 1, {{box(0.25, 0.25, 0.75, 0.75, 1)}, {}});
  // 64 cells, 16 of them halved once more
  EXPECT_EQ(triangulation.n_active_cells(), 48u + 64u);
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    const dealii::Point<2> center = cell->center();
    const bool             inside =
      std::abs(center[0] - 0.5) < 0.25 && std::abs(center[1] - 0.5) < 0.25;
    EXPECT_EQ(cell->level(), inside ? 2 : 1);
  }
}



TEST(Refinement, FinestOfOverlappingBoxes)
{
  dealii::Triangulation<2> triangulation;
  dealii::GridGenerator::subdivided_hyper_cube(triangulation, 4);
  refine_globally_and_in_regions<2>(
    triangulation,
    0,
    {{box(0.1, 0.1, 0.9, 0.9, 1), box(0.4, 0.4, 0.6, 0.6, 3)}, {}});
  EXPECT_EQ(triangulation.n_levels(), 4u);
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    EXPECT_GE(cell->level(), 1);
    if (cell->point_inside({0.45, 0.45}))
    {
      EXPECT_EQ(cell->level(), 3);
    }
  }
}



TEST(Refinement, SurroundingsOfPointsAndPieces)
{
  dealii::Triangulation<2> triangulation;
  dealii::GridGenerator::subdivided_hyper_cube(triangulation, 8);
  const dealii::Point<2> center(0.5, 0.5);
  const auto             top = FlatPiece<2>::segment({0., 1.}, {1., 1.});
  refine_globally_and_in_regions<2>(
    triangulation,
    0,
    {{}, {{{FlatPiece<2>::point(center)}, 0.15, 2}, {{top}, 0.1, 1}}});
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    const double from_center = cell->center().distance(center);
    const double from_top    = 1. - cell->center()[1];
    // half the diagonal of the coarse cells, and one ring of balanced cells
    constexpr double size = 0.125;
    if (from_center < 0.15)
    {
      EXPECT_EQ(cell->level(), 2) << cell->center();
    }
    else if (from_top < 0.1)
    {
      EXPECT_EQ(cell->level(), 1) << cell->center();
    }
    else if (from_center > 0.15 + 2. * size && from_top > 0.1 + 2. * size)
    {
      EXPECT_EQ(cell->level(), 0) << cell->center();
    }
  }
}



TEST(Refinement, SameCellsOnEveryNumberOfRanks)
{
  const RefinementRegions<2> regions = {{box(0., 0.3, 0.6, 0.7, 2)}, {}};
  dealii::Triangulation<2>   serial;
  dealii::parallel::distributed::Triangulation<2> distributed(MPI_COMM_WORLD);
  dealii::GridGenerator::subdivided_hyper_cube(serial, 4);
  dealii::GridGenerator::subdivided_hyper_cube(distributed, 4);
  refine_globally_and_in_regions<2>(distributed, 1, regions);
  refine_globally_and_in_regions<2>(serial, 1, regions);
  EXPECT_EQ(distributed.n_global_levels(), 4u);
  // p4est also balances across corners, so it may have a few cells more
  EXPECT_GE(distributed.n_global_active_cells(), serial.n_active_cells());
  EXPECT_LE(distributed.n_global_active_cells(), serial.n_active_cells() + 30);
}



TEST(MeshParameters, ReadsBoxes)
{
  MeshParameters<2>        mesh;
  dealii::ParameterHandler prm;
  mesh.add_parameters(prm);
  prm.parse_input_from_string(
    "subsection Mesh\n set Global refinements = 2\n"
    " set Refined boxes = 0,10 : 20,22 : 1 ; 1, 2 : 3.5, 4 : 3\n"
    " set Adaptation = none\n set Adaptive levels = 0\n"
    " set Phase-field threshold = 0.7\nend\n");
  mesh.check({}, {});
  const auto boxes = mesh.regions.refined_boxes();
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_EQ(mesh.global_refinements, 2u);
  EXPECT_EQ(boxes[0].lower, dealii::Point<2>(0., 10.));
  EXPECT_EQ(boxes[0].upper, dealii::Point<2>(20., 22.));
  EXPECT_EQ(boxes[0].levels, 1u);
  EXPECT_EQ(boxes[1].upper[0], 3.5);
  EXPECT_EQ(boxes[1].levels, 3u);
}



TEST(MeshParameters, Refusals)
{
  EXPECT_EQ(problem(""), "");
  EXPECT_EQ(problem("0,0 : 1,1 : 2"), "");
  expect_refused("0,0 : 1,1", "lower corner : upper corner : levels");
  expect_refused("0,0 : 1 : 2", "point of 2 numbers");
  expect_refused("0,0 : 1,0 : 2", "must be greater");
  expect_refused("0,0 : 1,1 : 1.5", "must be an integer");
  expect_refused("0,0 : 1,1 : -1", "must be an integer");
  expect_refused("0,0 : 1,1 : 13", "no more than 12");
  expect_refused("0,0 : 1,x : 1", "x");
  EXPECT_NE(problem("", 2).find("Mesh/Adaptive levels is 2"),
            std::string::npos);
}



TEST(RefinedRegions, ReadsDiscsAndSurroundings)
{
  RefinedRegions<2> regions;
  regions.discs        = "12, 18 : 5.5 : 1";
  regions.surroundings = "notch tip : 1.5 : 3 ; hole:1:2";
  regions.check(1, {}, {"hole", "notch tip"});
  const auto discs = regions.refined_discs();
  ASSERT_EQ(discs.size(), 1u);
  EXPECT_EQ(discs[0].center, dealii::Point<2>(12., 18.));
  EXPECT_EQ(discs[0].radius, 5.5);
  EXPECT_EQ(discs[0].levels, 1u);
  const auto surroundings = regions.refined_surroundings();
  ASSERT_EQ(surroundings.size(), 2u);
  EXPECT_EQ(surroundings[0].name, "notch tip");
  EXPECT_EQ(surroundings[0].distance, 1.5);
  EXPECT_EQ(surroundings[0].levels, 3u);
  EXPECT_EQ(surroundings[1].name, "hole");
}
