// SPDX-License-Identifier: GPL-2.0-or-later
// The direct solver on systems with known solutions, and the order of calls
// that the program uses.
#include "small_systems.h"

#include <solvers/direct_solver.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  // solve for a right hand side whose solution is known
  void
  expect_solves(const DirectSolver &solver, const Rows &rows)
  {
    for (const double factor : {1., -3., 0.})
    {
      std::vector<double> expected;
      for (unsigned int i = 0; i < rows.size(); ++i)
        expected.push_back(factor * (1. + i * i));
      const auto right_hand_side  = distributed(times(rows, expected));
      auto       solution         = distributed(expected);
      solution                    = 17.;
      const LinearOutcome outcome = solver.solve(solution, right_hand_side);
      ASSERT_TRUE(outcome.success) << outcome.reason;
      const std::vector<double> found = gathered(solution);
      for (unsigned int i = 0; i < rows.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-11) << "unknown " << i;
    }
  }

  void
  expect_success(const LinearOutcome &outcome)
  {
    EXPECT_TRUE(outcome.success) << outcome.reason;
  }

  // saddle point: needs pivoting
  const Rows saddle = {{2., 0., 1.}, {0., 3., 1.}, {1., 1., 0.}};
} // namespace



TEST(DirectSolver, NamesAPackageThatIsThere)
{
  const auto packages = DirectSolver::available_packages();
  ASSERT_FALSE(packages.empty());
  EXPECT_EQ(DirectSolver().package(), packages.front());
}



TEST(DirectSolver, SolvesForSeveralRightHandSides)
{
  LinearAlgebra::SparseMatrix matrix;
  make_matrix(string_rows(7), matrix);
  DirectSolver solver;
  expect_success(solver.initialize(matrix));
  expect_success(solver.factorize());
  expect_solves(solver, string_rows(7));
}



TEST(DirectSolver, TakesNewValuesWithTheSamePattern)
{
  LinearAlgebra::SparseMatrix matrix;
  make_matrix(string_rows(7), matrix);
  DirectSolver solver;
  expect_success(solver.initialize(matrix));
  for (const double diagonal : {2., 5., 0.3})
  {
    const Rows rows = string_rows(7, diagonal);
    set_rows(rows, matrix);
    expect_success(solver.factorize());
    expect_solves(solver, rows);
  }
}



TEST(DirectSolver, KeepsItsFactorsWhenValuesChange)
{
  LinearAlgebra::SparseMatrix matrix;
  make_matrix(string_rows(7), matrix);
  DirectSolver solver;
  expect_success(solver.initialize(matrix));
  expect_success(solver.factorize());
  set_rows(string_rows(7, 5.), matrix);
  expect_solves(solver, string_rows(7));
}



TEST(DirectSolver, CanBeInitializedAgain)
{
  LinearAlgebra::SparseMatrix first, second;
  make_matrix(string_rows(7), first);
  make_matrix(saddle, second);
  DirectSolver solver;
  expect_success(solver.initialize(first));
  expect_success(solver.factorize());
  expect_solves(solver, string_rows(7));
  expect_success(solver.initialize(second));
  expect_success(solver.factorize());
  expect_solves(solver, saddle);
  // and the same object with a new pattern, as after refinement
  make_matrix(string_rows(11), second);
  expect_success(solver.initialize(second));
  expect_success(solver.factorize());
  expect_solves(solver, string_rows(11));
}



TEST(DirectSolver, ReportsASingularMatrix)
{
  LinearAlgebra::SparseMatrix matrix;
  make_matrix({{1., 1., 0.}, {1., 1., 0.}, {0., 0., 0.}}, matrix);
  DirectSolver solver;
  expect_success(solver.initialize(matrix));
  const LinearOutcome outcome = solver.factorize();
  EXPECT_FALSE(outcome.success);
  EXPECT_FALSE(outcome.reason.empty());
}
