// SPDX-License-Identifier: GPL-2.0-or-later
// Membranes above and below obstacles, with the diagonal and with multigrid:
// the solutions have to agree, the iterations must not.
#include "small_systems.h"

#include <solvers/active_set.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr unsigned int n          = 32;  // nodes along each side
  constexpr double       diagonally = 1e9; // patience beyond all solves
  constexpr double       at_once    = 0.;

  // five-point differences, fixed just outside
  Rows
  membrane(const double diagonal = 4.)
  {
    Rows rows(n * n, std::vector<double>(n * n, 0.));
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        const unsigned int k = n * i + j;
        rows[k][k]           = diagonal;
        if (i > 0)
          rows[k][k - n] = rows[k - n][k] = -1.;
        if (j > 0)
          rows[k][k - 1] = rows[k - 1][k] = -1.;
      }
    return rows;
  }

  struct Membrane
  {
    Rows                rows      = membrane();
    std::vector<double> lower     = std::vector<double>(n * n, 0.);
    std::vector<double> upper     = std::vector<double>(n * n, 1.);
    std::vector<double> load      = std::vector<double>(n * n, 0.02);
    double              concavity = 0.;
  };

  struct Found
  {
    ActiveSetOutcome    outcome;
    std::vector<double> x;
  };

  Found
  solve(const Membrane &membrane, ActiveSetSolver &solver)
  {
    LinearAlgebra::SparseMatrix matrix;
    make_matrix(membrane.rows, matrix);
    const auto lower = distributed(membrane.lower);
    const auto upper = distributed(membrane.upper);
    const auto scale = distributed(std::vector<double>(n * n, 1.));
    const std::vector<double> start(n * n, 0.5);
    std::vector<double>       gradient = times(membrane.rows, start);
    for (unsigned int k = 0; k < n * n; ++k)
      gradient[k] -= membrane.load[k];
    auto                    x        = distributed(start);
    auto                    residual = distributed(gradient);
    const std::vector<bool> constrained(owned_part(n * n).n_elements(), false);
    const auto              outcome = solver.solve(
      {matrix, lower, upper, scale, constrained, membrane.concavity},
      x,
      residual);
    return {outcome, gathered(x)};
  }

  Found
  solve(const Membrane &membrane, const double patience)
  {
    ActiveSetOptions options;
    options.tolerance = 1e-10;
    options.patience  = patience;
    ActiveSetSolver solver(options);
    return solve(membrane, solver);
  }

  void
  expect_same(const Found &found, const Found &expected)
  {
    ASSERT_TRUE(found.outcome.converged) << found.outcome.reason;
    ASSERT_TRUE(expected.outcome.converged) << expected.outcome.reason;
    for (unsigned int k = 0; k < n * n; ++k)
      EXPECT_NEAR(found.x[k], expected.x[k], 1e-7) << "node " << k;
  }

  // within the bounds, and the gradient pushes against them or vanishes
  void
  expect_optimal(const Found &found, const Membrane &membrane)
  {
    ASSERT_TRUE(found.outcome.converged) << found.outcome.reason;
    const std::vector<double> image = times(membrane.rows, found.x);
    for (unsigned int k = 0; k < n * n; ++k)
    {
      const double gradient = image[k] - membrane.load[k];
      EXPECT_GE(found.x[k], membrane.lower[k]);
      EXPECT_LE(found.x[k], membrane.upper[k]);
      EXPECT_TRUE(gradient < 1e-9 || found.x[k] == membrane.lower[k]) << k;
      EXPECT_TRUE(gradient > -1e-9 || found.x[k] == membrane.upper[k]) << k;
    }
  }
} // namespace



TEST(FreeBlockPreconditioner, MultigridNeedsFewerIterationsForTheSame)
{
  const Membrane membrane;
  const Found    plain = solve(membrane, diagonally);
  const Found    quick = solve(membrane, at_once);
  expect_same(quick, plain);
  EXPECT_GT(plain.outcome.n_active, n);
  EXPECT_LT(2 * quick.outcome.linear_iterations,
            plain.outcome.linear_iterations);
}



TEST(FreeBlockPreconditioner, AHierarchyServesOtherFreeNodesToo)
{
  ActiveSetOptions options;
  options.tolerance = 1e-10;
  options.patience  = at_once;
  ActiveSetSolver solver(options);
  Membrane        membrane;
  expect_same(solve(membrane, solver), solve(membrane, diagonally));
  // a pole in the middle, and a quarter that is free now
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      if (i < n / 2 && j < n / 2)
        membrane.upper[n * i + j] = 2.;
  membrane.upper[n * n / 2 + n / 2] = membrane.lower[n * n / 2 + n / 2] = 0.3;
  expect_same(solve(membrane, solver), solve(membrane, diagonally));
}



TEST(FreeBlockPreconditioner, SomeRanksMayHaveNoFreeNodes)
{
  Membrane membrane;
  for (unsigned int k = 0; k < n * n / 2; ++k)
    membrane.lower[k] = membrane.upper[k];
  expect_same(solve(membrane, at_once), solve(membrane, diagonally));
}



TEST(FreeBlockPreconditioner, IndefiniteOperatorsLeadToBounds)
{
  // the smallest eigenvalue of the membrane is 4 - 4 cos(pi/(n + 1))
  Membrane     membrane;
  const double shift = 3. * (4. - 4. * std::cos(dealii::numbers::PI / (n + 1)));
  membrane.rows      = ::membrane(4. - shift);
  membrane.load.assign(n * n, 0.);
  // with the concavity and, as a user of the class could have it, without
  for (const double concavity : {shift, 0.})
    for (const double patience : {diagonally, at_once})
    {
      SCOPED_TRACE("concavity " + std::to_string(concavity) + ", patience " +
                   std::to_string(patience));
      membrane.concavity = concavity;
      const Found found  = solve(membrane, patience);
      expect_optimal(found, membrane);
      EXPECT_GT(found.outcome.n_active, n);
    }
}
