// SPDX-License-Identifier: GPL-2.0-or-later
// The iterative solver against the direct one, and its iterations: on meshes
// with hanging nodes, nearly incompressible, with bands of broken cells.
#include "elastic_system.h"

#include <base/log.h>

#include <solvers/block_amg.h>
#include <solvers/direct_solver.h>
#include <solvers/matrix_block.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  using Vector = LinearAlgebra::Vector;

  constexpr double tolerance = 1e-10;

  template <int dim>
  Vector
  exact_solution(ElasticSystem<dim> &system)
  {
    DirectSolver solver;
    Vector       result(system.right_hand_side);
    EXPECT_TRUE(solver.initialize(system.system()).success);
    EXPECT_TRUE(solver.factorize().success);
    EXPECT_TRUE(solver.solve(result, system.right_hand_side).success);
    system.constraints.elastic_corrections().set_zero(result);
    return result;
  }

  // The difference over the value, of displacements or pressures, each
  // weighted with the stiffness: what is nearly free to move is hardly known.
  template <int dim>
  double
  error(ElasticSystem<dim> &system,
        const Vector       &found,
        const Vector       &expected,
        const bool          of_pressure)
  {
    const std::vector<bool> is_pressure = system.system().is_pressure;
    const dealii::IndexSet  owned       = found.locally_owned_elements();
    std::vector<double>     sums(2, 0.);
    for (std::size_t i = 0; i < is_pressure.size(); ++i)
      if (is_pressure[i] == of_pressure)
      {
        const double weight =
          std::abs(system.matrix.diag_element(owned.nth_index_in_set(i)));
        const double difference = found.begin()[i] - expected.begin()[i];
        sums[0] += weight * difference * difference;
        sums[1] += weight * expected.begin()[i] * expected.begin()[i];
      }
    dealii::Utilities::MPI::sum(sums, MPI_COMM_WORLD, sums);
    return std::sqrt(sums[0] / sums[1]);
  }

  // Solve by both, compare, and return the iterations.
  template <int dim>
  unsigned int
  expect_direct_solution(ElasticSystem<dim> &system,
                         LinearSolver       &solver,
                         const double        allowed_error = 1e-6)
  {
    const Vector        expected = exact_solution(system);
    Vector              found(system.right_hand_side);
    const LinearOutcome outcome =
      solver.solve(found, system.right_hand_side, tolerance);
    EXPECT_TRUE(outcome.success) << outcome.reason;
    system.constraints.elastic_corrections().set_zero(found);
    EXPECT_LT(error(system, found, expected, false), allowed_error);
    if (system.options.mixed)
    {
      EXPECT_LT(error(system, found, expected, true), allowed_error);
    }
    return outcome.iterations;
  }

  template <int dim>
  unsigned int
  expect_direct_solution(const ElasticSystemOptions &options,
                         const double                allowed_error = 1e-6)
  {
    ElasticSystem<dim> system(options);
    BlockAmgSolver     solver({});
    EXPECT_TRUE(solver.initialize(system.system()).success);
    EXPECT_TRUE(solver.factorize().success);
    return expect_direct_solution(system, solver, allowed_error);
  }

  ElasticSystemOptions
  mixed(const unsigned int refinements,
        const unsigned int adaptive_levels,
        const double       lambda,
        const double       kappa,
        const Damage       damage)
  {
    ElasticSystemOptions options;
    options.refinements     = refinements;
    options.adaptive_levels = adaptive_levels;
    options.lambda          = lambda;
    options.kappa           = kappa;
    options.damage          = damage;
    return options;
  }
} // namespace



// the bars are for a relative tolerance of 1e-8: 10 digits may take 10/8 times
// as many iterations
TEST(BlockAmg, SolvesTheIntactSystemWhateverTheIncompressibility)
{
  for (const double lambda : {1., 1e3, 1e6})
  {
    SCOPED_TRACE("lambda/mu = " + std::to_string(lambda));
    EXPECT_LE(
      expect_direct_solution<2>(mixed(5, 0, lambda, 1e-6, Damage::none)), 30u);
  }
}



TEST(BlockAmg, NeedsLittleMoreWhereIncompressible)
{
  // smoothed aggregation straight from the nodes of the quadratic elements
  // needs 16 and 23 here
  std::vector<unsigned int> iterations;
  for (const double lambda : {1., 1e6})
  {
    ElasticSystem<2> system(mixed(6, 0, lambda, 1e-4, Damage::half));
    BlockAmgSolver   solver({});
    ASSERT_TRUE(solver.initialize(system.system()).success);
    ASSERT_TRUE(solver.factorize().success);
    Vector found(system.right_hand_side);
    iterations.push_back(
      solver.solve(found, system.right_hand_side, 1e-8).iterations);
  }
  EXPECT_LE(iterations[0], 16u);
  EXPECT_LE(iterations[1], 21u);
}



TEST(BlockAmg, SolvesWithABandOfBrokenCells)
{
  for (const Damage damage : {Damage::half, Damage::through})
    for (const double kappa : {1e-2, 1e-6})
      for (const double lambda : {1., 1e6})
      {
        SCOPED_TRACE(format("kappa = %g, lambda/mu = %g", kappa, lambda));
        EXPECT_LE(
          expect_direct_solution<2>(mixed(4, 0, lambda, kappa, damage), 1e-5),
          45u);
      }
}



TEST(BlockAmg, SolvesOnAMeshWithHangingNodes)
{
  for (const double kappa : {1e-2, 1e-6})
  {
    SCOPED_TRACE(format("kappa = %g", kappa));
    EXPECT_LE(
      expect_direct_solution<2>(mixed(3, 2, 1e3, kappa, Damage::half), 1e-5),
      45u);
  }
}



TEST(BlockAmg, SolvesInThreeDimensions)
{
  EXPECT_LE(expect_direct_solution<3>(mixed(2, 0, 1e3, 1e-4, Damage::none)),
            50u);
  EXPECT_LE(
    expect_direct_solution<3>(mixed(1, 1, 1e3, 1e-6, Damage::half), 1e-5), 50u);
}



TEST(BlockAmg, SolvesWithTensionAndCompressionAndEveryLaw)
{
  for (const std::string &law : all_pressure_laws().names())
  {
    SCOPED_TRACE(law);
    ElasticSystemOptions options = mixed(4, 1, 50., 1e-3, Damage::half);
    options.law                  = law;
    options.pressure             = [](const double x) { return x - 0.3; };
    EXPECT_LE(expect_direct_solution<2>(options, 1e-4), 60u);
  }
}



// Amor's split leaves them the part of their bulk modulus that is not the
// pressure's, and kappa of their shear modulus: multigrid alone gives up
TEST(BlockAmg, SolvesWhereBrokenCellsAreCompressed)
{
  for (const double kappa : {1e-2, 1e-4, 1e-6})
    for (const double lambda : {1., 1e3})
    {
      SCOPED_TRACE(format("kappa = %g, lambda/mu = %g", kappa, lambda));
      ElasticSystemOptions options = mixed(4, 1, lambda, kappa, Damage::half);
      options.pressure             = [](double) { return -1.; };
      options.stretch              = -1.;
      EXPECT_LE(expect_direct_solution<2>(options, 1e-4), 40u);
      options.refinements = 2;
      EXPECT_LE(expect_direct_solution<3>(options, 1e-4), 60u);
    }
}



TEST(BlockAmg, SolvesTheDisplacementFormulation)
{
  for (const unsigned int degree : {1, 2})
    for (const double kappa : {1e-2, 1e-6})
    {
      SCOPED_TRACE(format("degree %u, kappa = %g", degree, kappa));
      ElasticSystemOptions options = mixed(4, 1, 1.5, kappa, Damage::half);
      options.mixed                = false;
      options.degree               = degree;
      EXPECT_LE(expect_direct_solution<2>(options, 1e-5), 40u);
    }
  ElasticSystemOptions options = mixed(3, 0, 1.5, 1e-6, Damage::half);
  options.mixed                = false;
  options.degree               = 1;
  EXPECT_LE(expect_direct_solution<3>(options, 1e-5), 40u);
}



TEST(BlockAmg, KeepsAHierarchyThatIsStillGoodAndReplacesOneThatIsNot)
{
  ElasticSystem<2> system(mixed(4, 0, 1e3, 1e-6, Damage::through));
  system.assemble(1.); // intact
  BlockAmgSolver solver({});
  ASSERT_TRUE(solver.initialize(system.system()).success);
  ASSERT_TRUE(solver.factorize().success);
  expect_direct_solution(system, solver);
  EXPECT_EQ(solver.n_setups(), 1u);
  // hardly another matrix
  system.assemble(0.99);
  ASSERT_TRUE(solver.factorize().success);
  expect_direct_solution(system, solver);
  EXPECT_EQ(solver.n_setups(), 1u);
  // another one
  system.assemble(0.);
  ASSERT_TRUE(solver.factorize().success);
  expect_direct_solution(system, solver, 1e-5);
  EXPECT_EQ(solver.n_setups(), 2u);
  // after one that was given up the next is not tried, but the one after that
  // is
  for (unsigned int i = 0; i < 3; ++i)
  {
    ASSERT_TRUE(solver.factorize().success);
    expect_direct_solution(system, solver, 1e-5);
    EXPECT_EQ(solver.n_setups(), 3u);
  }
}



TEST(BlockAmg, SaysWhenItGivesUp)
{
  ElasticSystem<2>    system(mixed(3, 0, 1e3, 1e-2, Damage::none));
  LinearSolverOptions options;
  options.max_iterations = 3;
  BlockAmgSolver solver(options);
  ASSERT_TRUE(solver.initialize(system.system()).success);
  ASSERT_TRUE(solver.factorize().success);
  Vector              found(system.right_hand_side);
  const LinearOutcome outcome =
    solver.solve(found, system.right_hand_side, tolerance);
  EXPECT_FALSE(outcome.success);
  EXPECT_EQ(outcome.iterations, 3u);
  EXPECT_NE(outcome.reason.find("3 iterations"), std::string::npos)
    << outcome.reason;
}



TEST(BlockAmg, HasNothingToDoWithoutARightHandSide)
{
  ElasticSystem<2> system(mixed(2, 0, 1e3, 1e-2, Damage::none));
  BlockAmgSolver   solver({});
  ASSERT_TRUE(solver.initialize(system.system()).success);
  Vector zero(system.right_hand_side), found(zero);
  zero                        = 0.;
  found                       = 17.;
  const LinearOutcome outcome = solver.solve(found, zero, tolerance);
  EXPECT_TRUE(outcome.success);
  EXPECT_EQ(outcome.iterations, 0u);
  EXPECT_EQ(found.linfty_norm(), 0.);
}



namespace
{
  template <int dim>
  void
  expect_no_energy(const unsigned int degree, const bool mixed_fields)
  {
    ElasticSystemOptions options = mixed(2, 1, 3., 1e-2, Damage::half);
    options.mixed                = mixed_fields;
    options.degree               = degree;
    ElasticSystem<dim> system(options);
    const auto         is_pressure = system.system().is_pressure;
    auto               chosen      = is_pressure;
    chosen.flip();
    const auto modes = rigid_body_modes(system.fields, chosen);
    ASSERT_EQ(modes.size(), dim * (dim + 1u) / 2);
    // without clamps
    const auto &hanging = system.constraints.elastic_hanging_nodes();
    for (const auto &mode : modes)
    {
      Vector owned     = system.fields.owned_vector(system.fields.elastic_dofs);
      std::size_t next = 0;
      for (std::size_t i = 0; i < is_pressure.size(); ++i)
        if (!is_pressure[i])
          owned.begin()[i] = mode[next++];
      EXPECT_EQ(next, mode.size());
      EXPECT_NEAR(owned.linfty_norm(), 1., 1e-12);
      Vector elastic = system.fields.ghosted_vector(system.fields.elastic_dofs);
      elastic        = owned;
      // hanging nodes move with the others
      hanging.distribute(owned);
      Vector difference =
        system.fields.owned_vector(system.fields.elastic_dofs);
      difference = elastic;
      difference.add(-1., owned);
      EXPECT_LT(difference.linfty_norm(), 1e-12);
      Vector intact =
        system.fields.ghosted_vector(system.fields.phase_field_dofs);
      Vector ones = system.fields.owned_vector(system.fields.phase_field_dofs);
      ones        = 1.;
      intact      = ones;
      system.assembler->elastic_residual(elastic, intact, hanging, owned);
      EXPECT_LT(owned.linfty_norm(), 1e-12);
    }
  }
} // namespace



TEST(RigidBodyModes, CostNoEnergy)
{
  expect_no_energy<2>(2, true);
  expect_no_energy<2>(1, false);
  expect_no_energy<3>(2, true);
  expect_no_energy<3>(1, false);
}



namespace
{
  // The coarse operator must be I^T A I, and the interpolation must have the
  // values of linear functions at nodes that are free.
  template <int dim>
  void
  expect_coarse_operator_of(const ElasticSystemOptions &options)
  {
    ElasticSystem<dim> system(options);
    system.assemble_auxiliaries();
    const auto  &coarse = system.auxiliaries.coarse();
    Vector       values = system.fields.owned_vector(coarse.dofs());
    const auto   owned  = values.locally_owned_elements();
    unsigned int n_free = 0;
    for (std::size_t i = 0; i < owned.n_elements(); ++i)
      if (!coarse.constraints().is_constrained(owned.nth_index_in_set(i)))
      {
        values.begin()[i] = std::sin(1. + owned.nth_index_in_set(i));
        ++n_free;
      }
    EXPECT_GT(n_free, 10u);
    Vector fine = system.fields.owned_vector(system.fields.elastic_dofs);
    Vector image(fine), expected(values), found(values);
    multiply(coarse.interpolation(), fine.begin(), values.begin());
    // constrained nodes follow in the matrix itself
    system.matrix.vmult(image, fine);
    multiply(coarse.interpolation(),
             expected.begin(),
             image.begin(),
             /*transposed=*/true);
    system.auxiliaries.displacement().vmult(found, values);
    coarse.constraints().set_zero(found);
    const double size = expected.linfty_norm();
    EXPECT_GT(size, 0.1);
    found.add(-1., expected);
    EXPECT_LT(found.linfty_norm(), 1e-12 * size);
  }
} // namespace



TEST(AuxiliaryMatrices, AreTheElasticOperatorOnLinearDisplacements)
{
  expect_coarse_operator_of<2>(mixed(3, 0, 3., 1e-2, Damage::half));
  expect_coarse_operator_of<2>(mixed(3, 2, 3., 1e-6, Damage::half));
  expect_coarse_operator_of<3>(mixed(1, 2, 3., 1e-4, Damage::half));
  ElasticSystemOptions options = mixed(3, 1, 3., 1e-2, Damage::through);
  options.mixed                = false;
  expect_coarse_operator_of<2>(options);
}



namespace
{
  void
  expect_small_difference(LinearAlgebra::SparseMatrix       &one,
                          const LinearAlgebra::SparseMatrix &other)
  {
    const double size = other.frobenius_norm();
    EXPECT_GT(size, 0.1);
    one.add(-1., other);
    EXPECT_LT(one.frobenius_norm(), 1e-13 * size);
  }



  // From the tangents that products keep, and from those that the assembler
  // evaluates again.
  template <int dim>
  void
  expect_same_from_kept_tangents(ElasticSystemOptions options)
  {
    options.matrix_free = true;
    ElasticSystem<dim> system(options);
    system.assemble_auxiliaries();
    LinearAlgebra::SparseMatrix displacement, pressure;
    displacement.copy_from(system.auxiliaries.displacement());
    pressure.copy_from(system.auxiliaries.pressure());
    system.auxiliaries.assemble(*system.assembler);
    expect_small_difference(displacement, system.auxiliaries.displacement());
    expect_small_difference(pressure, system.auxiliaries.pressure());
  }
} // namespace



TEST(AuxiliaryMatrices, AreThoseOfTheTangentsThatProductsKeep)
{
  ElasticSystemOptions options = mixed(2, 1, 3., 1e-2, Damage::half);
  expect_same_from_kept_tangents<2>(options);
  expect_same_from_kept_tangents<3>(options);
  // half of the cells isotropic, the others not
  options.split = "spectral";
  expect_same_from_kept_tangents<2>(options);
  expect_same_from_kept_tangents<3>(options);
}



TEST(AuxiliaryMatrices, InterpolateLinearDisplacementsExactly)
{
  ElasticSystem<2> system(mixed(3, 2, 3., 1e-2, Damage::half));
  system.assemble_auxiliaries();
  const auto &coarse = system.auxiliaries.coarse();
  Vector      exact  = system.fields.owned_vector(system.fields.elastic_dofs);
  // continuous, linear on each cell, 0 at the clamps
  dealii::VectorTools::interpolate(
    system.fields.mapping,
    system.fields.elastic,
    dealii::FunctionFromFunctionObjects<2>(
      {[](const dealii::Point<2> &p) { return 0.5 - std::abs(p[1] - 0.5); },
       [](const dealii::Point<2> &p) {
         return (0.5 - std::abs(p[1] - 0.5)) * (1. + p[0]);
       },
       [](const dealii::Point<2> &) { return 0.; }}),
    exact);
  Vector              found(exact);
  std::vector<double> vertices;
  for (std::size_t i = 0; i < coarse.at_vertices().size(); ++i)
    if (coarse.at_vertices()[i])
      vertices.push_back(exact.begin()[i]);
  multiply(coarse.interpolation(), found.begin(), vertices.data());
  system.constraints.elastic_corrections().set_zero(exact);
  EXPECT_GT(exact.linfty_norm(), 0.5);
  found.add(-1., exact);
  EXPECT_LT(found.linfty_norm(), 1e-12);
}



// With hanging nodes: K x, x not 0 in rows of the block only.
TEST(AuxiliaryMatrices, HaveTheBlockOfCompressedBrokenCells)
{
  ElasticSystemOptions options = mixed(2, 1, 10., 1e-4, Damage::half);
  options.stretch              = -1.;
  ElasticSystem<3> system(options);
  system.assemble_auxiliaries();
  const FluidLikeCells<3> &cells = system.auxiliaries.fluid_like();
  ASSERT_TRUE(cells.has_block());
  Vector x(system.right_hand_side), product(x), of_block, found;
  of_block.reinit(cells.block().locally_owned_range_indices(), MPI_COMM_WORLD);
  found.reinit(of_block);
  x = 0.;
  for (std::size_t k = 0; k < cells.rows().size(); ++k)
  {
    of_block.begin()[k]        = std::sin(1. + k);
    x.begin()[cells.rows()[k]] = of_block.begin()[k];
  }
  cells.block().vmult(found, of_block);
  system.matrix.vmult(product, x);
  for (std::size_t k = 0; k < cells.rows().size(); ++k)
    EXPECT_NEAR(found.begin()[k], product.begin()[cells.rows()[k]], 1e-13);
  // where it is opened the displacements keep nothing of their bulk modulus
  options.stretch = 1.;
  ElasticSystem<3> opened(options);
  opened.assemble_auxiliaries();
  EXPECT_FALSE(opened.auxiliaries.fluid_like().has_block());
}



TEST(AuxiliaryMatrices, WeighThePressureWithBothCompliances)
{
  // the sum of all entries is the integral of 1/(2 mu) + 1/lambda
  ElasticSystem<2> system(mixed(2, 1, 3., 1e-2, Damage::none));
  system.assemble_auxiliaries();
  const auto is_pressure = system.system().is_pressure;
  Vector     ones = system.fields.owned_vector(system.fields.elastic_dofs);
  for (std::size_t i = 0; i < is_pressure.size(); ++i)
    ones.begin()[i] = is_pressure[i] ? 1. : 0.;
  system.constraints.elastic_corrections().set_zero(ones);
  Vector image(ones);
  system.auxiliaries.pressure().vmult(image, ones);
  EXPECT_NEAR(image * ones, 0.5 + 1. / 3., 1e-12);
}



TEST(LinearSolverChoice, IsThatOfTheUserOrByTheNumberOfUnknowns)
{
  for (const std::string &name : all_linear_solvers().names())
  {
    const LinearSolverChoice choice =
      choose_linear_solver(name, 2, 1000000000, true);
    EXPECT_EQ(choice.name, name);
    EXPECT_EQ(choice.reason, "");
  }
  for (const int dim : {2, 3})
  {
    const LinearSolverChoice small =
      choose_linear_solver("auto", dim, 1000, true);
    EXPECT_EQ(small.name, "direct");
    EXPECT_NE(small.reason.find("1000 unknowns"), std::string::npos);
    EXPECT_EQ(choose_linear_solver("auto", dim, 50000000, false).name,
              "block AMG");
    EXPECT_EQ(choose_linear_solver("auto", dim, 50000000, true).name,
              "matrix-free");
  }
}
