// SPDX-License-Identifier: GPL-2.0-or-later
// Products without a matrix against those with it, and the solver that is
// built on them against the direct one.
#include "elastic_system.h"

#include <base/log.h>

#include <solvers/assembled_product.h>
#include <solvers/direct_solver.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  using Vector = SaddlePointProduct::Vector;

  Vector
  some_vector(const Vector &like, const int seed)
  {
    Vector     result(like);
    const auto owned = like.locally_owned_elements();
    for (const auto i : owned)
      result(i) = std::sin(1. + 3. * i + seed) + 0.3 * std::cos(0.01 * i);
    result.compress(dealii::VectorOperation::insert);
    return result;
  }

  // Of all rows but constrained ones, relative to the largest.
  template <int dim, typename AnyVector>
  double
  difference(const ElasticSystem<dim> &system,
             const AnyVector          &a,
             const AnyVector          &b)
  {
    AnyVector rest(a), size(b);
    rest -= b;
    system.constraints.elastic_corrections().set_zero(rest);
    system.constraints.elastic_corrections().set_zero(size);
    return rest.linfty_norm() / size.linfty_norm();
  }

  // The product with work before and after it: once for each row, and what is
  // seen after it is the product.
  void
  expect_same_by_ranges(const SaddlePointProduct &product,
                        const Vector             &source,
                        const Vector             &expected,
                        const LinearSystem       &described)
  {
    Vector                    result(expected), seen(expected);
    std::vector<unsigned int> n_before(result.locally_owned_size());
    std::vector<unsigned int> n_after(result.locally_owned_size());
    product.vmult(
      result,
      source,
      [&](const unsigned int first, const unsigned int second) {
        for (unsigned int i = first; i < second; ++i)
        {
          result.local_element(i) = 0.;
          ++n_before[i];
        }
      },
      [&](const unsigned int first, const unsigned int second) {
        for (unsigned int i = first; i < second; ++i)
        {
          seen.local_element(i) = result.local_element(i);
          ++n_after[i];
        }
      });
    for (unsigned int i = 0; i < n_before.size(); ++i)
    {
      EXPECT_EQ(n_before[i], 1u);
      EXPECT_EQ(n_after[i], 1u);
      if (!described.is_constrained[i])
      {
        EXPECT_NEAR(seen.local_element(i), expected.local_element(i), 1e-12);
      }
    }
  }

  // K x, B^T p and the diagonal
  template <int dim>
  void
  expect_products_of_matrix(ElasticSystemOptions options)
  {
    options.matrix_free = true;
    ElasticSystem<dim>     system(options);
    const LinearSystem     described = system.system();
    const AssembledProduct assembled(system.matrix, described.is_pressure);
    Vector                 expected, found;
    system.matrix_free.reinit(expected);
    found.reinit(expected);
    for (const int seed : {0, 1})
    {
      const Vector source = some_vector(expected, seed);
      assembled.vmult(expected, source);
      system.matrix_free.vmult(found, source);
      EXPECT_LT(difference(system, found, expected), 1e-13);
      expect_same_by_ranges(system.matrix_free, source, found, described);
    }
    Vector pressures = some_vector(expected, 2);
    for (std::size_t i = 0; i < described.is_pressure.size(); ++i)
      if (described.is_pressure[i] && described.is_constrained[i])
        pressures.local_element(i) = 0.;
    assembled.pressure_forces(expected, pressures);
    system.matrix_free.pressure_forces(found, pressures);
    for (std::size_t i = 0; i < described.is_pressure.size(); ++i)
      if (!described.is_pressure[i] && !described.is_constrained[i])
      {
        EXPECT_NEAR(found.local_element(i), expected.local_element(i), 1e-13);
      }
    assembled.diagonal(expected);
    system.matrix_free.diagonal(found);
    for (std::size_t i = 0; i < described.is_pressure.size(); ++i)
      if (!described.is_pressure[i] && !described.is_constrained[i])
      {
        // beside hanging nodes what is linear in the weights
        const double ratio = found.begin()[i] / expected.begin()[i];
        EXPECT_GT(ratio, options.adaptive_levels == 0 ? 1. - 1e-12 : 0.5);
        EXPECT_LT(ratio, options.adaptive_levels == 0 ? 1. + 1e-12 : 2.5);
      }
  }
} // namespace



TEST(MatrixFree, IsTheMatrixOnUniformMeshes)
{
  for (const double kappa : {1e-2, 1e-6})
  {
    ElasticSystemOptions options;
    options.kappa = kappa;
    expect_products_of_matrix<2>(options);
    options.refinements = 2;
    expect_products_of_matrix<3>(options);
  }
}



TEST(MatrixFree, IsTheMatrixWithHangingNodes)
{
  ElasticSystemOptions options;
  options.refinements     = 2;
  options.adaptive_levels = 2;
  expect_products_of_matrix<2>(options);
  options.refinements = 1;
  expect_products_of_matrix<3>(options);
}



TEST(MatrixFree, IsTheMatrixOfEverySplitAndLaw)
{
  for (const std::string &split : all_energy_splits<3>().names())
    for (const std::string &law : all_pressure_laws().names())
    {
      SCOPED_TRACE(split + ", " + law);
      ElasticSystemOptions options;
      options.refinements = 2;
      options.split       = split;
      options.law         = law;
      options.pressure    = [](const double x) { return x - 0.3; };
      expect_products_of_matrix<2>(options);
      options.refinements     = 1;
      options.adaptive_levels = 1;
      expect_products_of_matrix<3>(options);
    }
}



TEST(MatrixFree, IsTheMatrixAtFiniteStrain)
{
  for (const std::string &split : all_finite_splits().names())
    for (const std::string &law : all_finite_pressure_laws().names())
    {
      SCOPED_TRACE(split + ", " + law);
      ElasticSystemOptions options;
      options.refinements     = 1;
      options.adaptive_levels = 1;
      options.split           = split;
      options.law             = law;
      options.strains         = Strains::finite;
      options.kappa           = 1e-3;
      expect_products_of_matrix<2>(options);
      expect_products_of_matrix<3>(options);
    }
}



TEST(MatrixFree, SolvesWhatTheDirectSolverSolves)
{
  for (const unsigned int adaptive_levels : {0, 1})
  {
    ElasticSystemOptions options;
    options.refinements     = 2;
    options.adaptive_levels = adaptive_levels;
    options.lambda          = 1e3;
    options.kappa           = 1e-4;
    options.matrix_free     = true;
    ElasticSystem<3>      system(options);
    DirectSolver          direct;
    LinearAlgebra::Vector expected(system.right_hand_side), found(expected);
    ASSERT_TRUE(direct.initialize(system.system()).success);
    ASSERT_TRUE(direct.factorize().success);
    ASSERT_TRUE(direct.solve(expected, system.right_hand_side).success);
    const auto   solver  = all_linear_solvers().make("matrix-free", {});
    LinearSystem without = system.system();
    without.matrix       = nullptr;
    ASSERT_TRUE(solver->initialize(without).success);
    ASSERT_TRUE(solver->factorize().success);
    const LinearOutcome outcome =
      solver->solve(found, system.right_hand_side, 1e-10);
    EXPECT_TRUE(outcome.success) << outcome.reason;
    EXPECT_LE(outcome.iterations, 40u);
    EXPECT_LT(difference(system, found, expected), 1e-6);
  }
}



// one set of numbers per cell in place of those of 27 points
TEST(MatrixFree, NeedsLessMemoryWhereCellsAreIntact)
{
  ElasticSystemOptions options;
  options.matrix_free = true;
  options.with_matrix = false;
  const ElasticSystem<3> damaged(options);
  options.damage = Damage::none;
  const ElasticSystem<3> intact(options);
  EXPECT_LT(intact.matrix_free.memory_consumption(),
            0.85 * damaged.matrix_free.memory_consumption());
}
