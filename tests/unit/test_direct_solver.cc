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
  expect_solves(DirectSolver &solver, const Rows &rows)
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



// every package, for matrices it is told are symmetric or not
class EveryDirectSolver
  : public ::testing::TestWithParam<std::tuple<std::string, MatrixSymmetry>>
{
protected:
  EveryDirectSolver()
    : solver(std::get<0>(GetParam()))
  {}

  void
  initialize(const LinearAlgebra::SparseMatrix &matrix)
  {
    expect_success(solver.initialize(matrix, std::get<1>(GetParam())));
  }

  // it must outlive the solver
  LinearAlgebra::SparseMatrix matrix, second;
  DirectSolver                solver;
};

INSTANTIATE_TEST_SUITE_P(
  Packages,
  EveryDirectSolver,
  ::testing::Combine(::testing::ValuesIn(DirectSolver::available_packages()),
                     ::testing::Values(MatrixSymmetry::symmetric,
                                       MatrixSymmetry::none)));



TEST_P(EveryDirectSolver, SolvesForSeveralRightHandSides)
{
  make_matrix(string_rows(7), matrix);
  initialize(matrix);
  expect_success(solver.factorize());
  expect_solves(solver, string_rows(7));
}



TEST_P(EveryDirectSolver, TakesNewValuesWithTheSamePattern)
{
  make_matrix(string_rows(7), matrix);
  initialize(matrix);
  for (const double diagonal : {2., 5., 0.3})
  {
    const Rows rows = string_rows(7, diagonal);
    set_rows(rows, matrix);
    expect_success(solver.factorize());
    expect_solves(solver, rows);
  }
}



TEST_P(EveryDirectSolver, KeepsItsFactorsWhenValuesChange)
{
  make_matrix(string_rows(7), matrix);
  initialize(matrix);
  expect_success(solver.factorize());
  set_rows(string_rows(7, 5.), matrix);
  expect_solves(solver, string_rows(7));
}



TEST_P(EveryDirectSolver, CanBeInitializedAgain)
{
  make_matrix(string_rows(7), matrix);
  make_matrix(saddle, second);
  initialize(matrix);
  expect_success(solver.factorize());
  expect_solves(solver, string_rows(7));
  initialize(second);
  expect_success(solver.factorize());
  expect_solves(solver, saddle);
  // and the same object with a new pattern, as after refinement
  solver.release();
  make_matrix(string_rows(11), second);
  initialize(second);
  expect_success(solver.factorize());
  expect_solves(solver, string_rows(11));
}



TEST_P(EveryDirectSolver, ReportsASingularMatrix)
{
  make_matrix({{1., 1., 0.}, {1., 1., 0.}, {0., 0., 0.}}, matrix);
  initialize(matrix);
  const LinearOutcome outcome = solver.factorize();
  EXPECT_FALSE(outcome.success);
  EXPECT_FALSE(outcome.reason.empty());
}



// as with units that make stiffnesses large and compressibilities small
TEST(DirectSolver, SolvesWhereUnitsAreFarApart)
{
  const std::vector<double> units = {1e6, 1e6, 1e-7, 1e6, 1e-7};
  Rows                      rows  = {{2., 0.5, 1., 0., 0.},
                                     {0.5, 3., 1., -1., 0.2},
                                     {1., 1., -1e-3, 0., 0.},
                                     {0., -1., 0., 4., 1.},
                                     {0., 0.2, 0., 1., -1e-3}};
  std::vector<double>       expected;
  for (unsigned int i = 0; i < rows.size(); ++i)
  {
    expected.push_back((1. + i) / units[i]);
    for (unsigned int j = 0; j < rows.size(); ++j)
      rows[i][j] *= units[i] * units[j];
  }
  LinearAlgebra::SparseMatrix matrix;
  make_matrix(rows, matrix);
  DirectSolver solver;
  expect_success(solver.initialize(matrix, MatrixSymmetry::symmetric));
  // the values that scale it may change
  for (const double factor : {1., 1e-4})
  {
    Rows factored = rows;
    for (auto &row : factored)
      for (double &entry : row)
        entry *= factor;
    set_rows(factored, matrix);
    expect_success(solver.factorize());
    auto solution = distributed(expected);
    solution      = 0.;
    expect_success(
      solver.solve(solution, distributed(times(factored, expected))));
    const std::vector<double> found = gathered(solution);
    for (unsigned int i = 0; i < rows.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-11 * expected[i]) << i;
  }
}



TEST(DirectSolver, SolvesAMatrixThatIsNotSymmetric)
{
  const Rows rows = {{4., 1., 0.}, {-2., 3., 1.}, {0., 5., 1.}};
  for (const std::string &package : DirectSolver::available_packages())
  {
    LinearAlgebra::SparseMatrix matrix;
    make_matrix(rows, matrix);
    DirectSolver solver(package);
    expect_success(solver.initialize(matrix, MatrixSymmetry::none));
    expect_success(solver.factorize());
    expect_solves(solver, rows);
  }
}
