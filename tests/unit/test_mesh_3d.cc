// SPDX-License-Identifier: GPL-2.0-or-later
// Refined meshes in 3-d: where they are fine, what becomes of the fields, and
// which nodes cannot break.
#include <deal.II/base/function_lib.h>
#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <discretization/adaptation.h>

#include <input/dimension.h>
#include <input/parameter_file.h>

#include <simulation/simulation_setup.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;
using dealii::Point;
using Mesh = dealii::parallel::distributed::Triangulation<3>;

namespace
{
  struct Case : Parameters<3>
  {
    explicit Case(std::vector<std::string> settings)
    {
      dealii::ParameterHandler prm;
      add_parameters(prm);
      settings.insert(settings.end(),
                      {"Geometry/Dimension=3",
                       "Material/Lame lambda=1",
                       "Material/Shear modulus=1"});
      read_parameters(std::vector<SourceLine>(), settings, prm);
      check();
    }
  };

  // of the cells whose centre lies within @p distance of @p piece, and of those
  // beyond; over all ranks
  struct Levels
  {
    int least_near  = 100;
    int largest_far = 0;
  };

  Levels
  levels(const Mesh         &mesh,
         const FlatPiece<3> &piece,
         const double        near,
         const double        far)
  {
    Levels result;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        const double away = distance(cell->center(), piece);
        if (away < near)
          result.least_near = std::min(result.least_near, cell->level());
        if (away > far)
          result.largest_far = std::max(result.largest_far, cell->level());
      }
    result.least_near =
      dealii::Utilities::MPI::min(result.least_near, MPI_COMM_WORLD);
    result.largest_far =
      dealii::Utilities::MPI::max(result.largest_far, MPI_COMM_WORLD);
    return result;
  }

  const std::string clamped =
    "Boundary conditions/Displacement=bottom : all : 0 ; top : y : t";
} // namespace



TEST(Mesh3d, IsFineAlongTheTipOfASlit)
{
  const Case parameters({"Geometry/Name=slit cube",
                         clamped,
                         "Mesh/Refined surroundings=slit tip : 0.1 : 2"});
  Mesh       mesh(MPI_COMM_WORLD);
  make_mesh(parameters, mesh);
  // the line through the whole depth, which the corner at its ends is part of
  const auto found = levels(
    mesh, FlatPiece<3>::segment({0.5, 0.5, 0.}, {0.5, 0.5, 1.}), 0.1, 0.6);
  EXPECT_EQ(found.least_near, 2);
  EXPECT_EQ(found.largest_far, 0);
}



TEST(Mesh3d, IsFineAllOverABoundary)
{
  // one coarse cell: the surroundings are those of a face, not of its diagonals
  const Case parameters({"Geometry/Name=box",
                         "Geometry/Box/Cells=1, 1, 1",
                         clamped,
                         "Mesh/Global refinements=2",
                         "Mesh/Refined surroundings=top : 0.01 : 2"});
  Mesh       mesh(MPI_COMM_WORLD);
  make_mesh(parameters, mesh);
  const auto found = levels(mesh,
                            {{{Point<3>(0., 1., 0.),
                               Point<3>(1., 1., 0.),
                               Point<3>(0., 1., 1.),
                               Point<3>(1., 1., 1.)}}},
                            0.05,
                            0.5);
  EXPECT_EQ(found.least_near, 4);
  EXPECT_EQ(found.largest_far, 2);
}



TEST(Mesh3d, IsFineInBoxesAndBalls)
{
  const Case parameters({"Geometry/Name=box",
                         "Geometry/Box/Cells=4, 4, 4",
                         clamped,
                         "Mesh/Refined boxes=0,0,0 : 0.25,0.25,0.25 : 1",
                         "Mesh/Refined discs=1,1,1 : 0.1 : 2"});
  Mesh       mesh(MPI_COMM_WORLD);
  make_mesh(parameters, mesh);
  EXPECT_EQ(
    levels(mesh, FlatPiece<3>::point({1., 1., 1.}), 0.15, 9.).least_near, 2);
  EXPECT_EQ(
    levels(mesh, FlatPiece<3>::point({0.1, 0.1, 0.1}), 0.1, 9.).least_near, 1);
  // 64, of which one in the box; one at the corner, of its children one more,
  // and for balance (over edges and corners) no others
  EXPECT_EQ(mesh.n_global_active_cells(), 64u + 7u + 7u + 7u);
}



TEST(Mesh3d, MarginIsMeasuredFromTheWholeFace)
{
  const Case parameters({"Geometry/Name=box",
                         "Geometry/Box/Cells=1, 1, 1",
                         clamped,
                         "Boundary conditions/Unbreakable margin=0.25",
                         "Mesh/Global refinements=3"});
  Mesh       mesh(MPI_COMM_WORLD);
  make_mesh(parameters, mesh);
  Fields<3> fields(mesh, {true, 2});
  fields.distribute();
  // three layers of nodes at the top and three at the bottom
  EXPECT_EQ(
    dealii::Utilities::MPI::sum(
      unbreakable_nodes(parameters, fields).n_elements(), MPI_COMM_WORLD),
    2u * 3u * 81u);
}



TEST(Mesh3d, SlitIsBrokenAndNothingElse)
{
  const Case parameters({"Geometry/Name=slit cube", clamped});
  Mesh       mesh(MPI_COMM_WORLD);
  make_mesh(parameters, mesh);
  Fields<3> fields(mesh, {true, 2});
  fields.distribute();
  Constraints<3> constraints(fields, {});
  constraints.reinit();
  const auto phase_field = initial_phase_field(parameters, fields, constraints);
  double     broken      = 0.;
  for (const auto dof : fields.phase_field_dofs.owned)
    broken += 1. - phase_field(dof);
  // two nodes doubled and the tip, for five in z
  EXPECT_EQ(dealii::Utilities::MPI::sum(broken, MPI_COMM_WORLD), 5. * 5.);
}



namespace
{
  // polynomials that the elements hold exactly
  const dealii::FunctionFromFunctionObjects<3>
    quadratic({[](const Point<3> &p) { return p[0] * p[0] - p[1] * p[2]; },
               [](const Point<3> &p) { return 3. * p[1] * p[1] + p[0] * p[2]; },
               [](const Point<3> &p) { return p[2] * p[2] - p[0]; },
               [](const Point<3> &p) { return 2. - p[0] + p[1] * p[2]; }});

  // a crack across half of the unit cube, with a front that is not straight
  double
  cracked(const Point<3> &p)
  {
    const double end = 0.4 + 0.3 * p[2];
    return std::min(1., 4. * std::hypot(p[1] - 0.5, std::max(0., p[0] - end)));
  }

  class AdaptiveCube : public ::testing::Test
  {
  protected:
    AdaptiveCube()
      : mesh(MPI_COMM_WORLD)
      , fields(mesh, {true, 2})
      , constraints(fields, clamps())
    {
      dealii::GridGenerator::subdivided_hyper_cube(mesh, 4, 0., 1., true);
      fields.distribute();
      constraints.reinit();
      rule.threshold    = 0.7;
      rule.finest_level = 2;
    }

    // all components on the faces x = 0, y = 0 and y = 1
    static std::vector<PrescribedComponent<3>>
    clamps()
    {
      std::vector<PrescribedComponent<3>> result;
      for (const dealii::types::boundary_id boundary : {0, 2, 3})
        for (unsigned int d = 0; d < 3; ++d)
          result.push_back(
            {boundary,
             d,
             std::make_shared<dealii::Functions::ZeroFunction<3>>(4)});
      return result;
    }

    LinearAlgebra::Vector
    interpolated(const dealii::DoFHandler<3> &handler,
                 const DofSets               &dofs,
                 const dealii::Function<3>   &function) const
    {
      LinearAlgebra::Vector owned = fields.owned_vector(dofs);
      dealii::VectorTools::interpolate(
        fields.mapping, handler, function, owned);
      LinearAlgebra::Vector result = fields.ghosted_vector(dofs);
      result                       = owned;
      return result;
    }

    LinearAlgebra::Vector
    crack() const
    {
      return interpolated(fields.phase_field,
                          fields.phase_field_dofs,
                          dealii::ScalarFunctionFromFunctionObject<3>(cracked));
    }

    void
    refine_around_the_crack(
      const std::vector<LinearAlgebra::Vector *> &elastic,
      const std::vector<LinearAlgebra::Vector *> &phase_field)
    {
      for (unsigned int round = 0; round < 2; ++round)
        for (auto places = places_to_refine(fields, crack(), rule);
             flag_cells_near(places, rule, mesh);)
          refine_and_transfer(mesh, fields, constraints, elastic, phase_field);
    }

    Mesh           mesh;
    Fields<3>      fields;
    Constraints<3> constraints;
    AdaptationRule rule;
  };
} // namespace



TEST_F(AdaptiveCube, RefinesAroundTheCrack)
{
  refine_around_the_crack({}, {});
  const LinearAlgebra::Vector phi = crack();
  for (const auto &cell : fields.phase_field.active_cell_iterators())
    if (cell->is_locally_owned())
      for (const unsigned int v : cell->vertex_indices())
      {
        const bool damaged = phi(cell->vertex_dof_index(v, 0)) < rule.threshold;
        EXPECT_FALSE(damaged && cell->level() < 2) << cell->center();
      }
  EXPECT_LT(mesh.n_global_active_cells(), 16u * 16u * 16u / 2u);
}



TEST_F(AdaptiveCube, CarriesTheFieldsOverExactly)
{
  LinearAlgebra::Vector elastic =
    interpolated(fields.elastic, fields.elastic_dofs, quadratic);
  LinearAlgebra::Vector phi = crack();
  refine_around_the_crack({&elastic}, {&phi});
  EXPECT_GT(mesh.n_global_active_cells(), 64u);
  const LinearAlgebra::Vector expected =
    interpolated(fields.elastic, fields.elastic_dofs, quadratic);
  for (const auto dof : fields.elastic_dofs.relevant)
    EXPECT_NEAR(elastic(dof), expected(dof), 1e-13);
  for (const auto dof : fields.phase_field_dofs.relevant)
  {
    EXPECT_GE(phi(dof), 0.);
    EXPECT_LE(phi(dof), 1.);
  }
}



// in 3-d nodes may hang on the boundary, and belong to another rank
TEST_F(AdaptiveCube, HasTheSameConstraintsOnAllRanks)
{
  refine_around_the_crack({}, {});
  const dealii::IndexSet active =
    dealii::DoFTools::extract_locally_active_dofs(fields.elastic);
  const auto owned = dealii::Utilities::MPI::all_gather(
    MPI_COMM_WORLD, fields.elastic_dofs.owned);
  for (const auto *each : {&constraints.elastic_hanging_nodes(),
                           &constraints.elastic_corrections()})
  {
    EXPECT_GT(
      dealii::Utilities::MPI::sum(each->n_constraints(), MPI_COMM_WORLD), 100u);
    EXPECT_TRUE(
      each->is_consistent_in_parallel(owned, active, MPI_COMM_WORLD, true));
  }
}
