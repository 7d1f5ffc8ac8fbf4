// SPDX-License-Identifier: GPL-2.0-or-later
// Orders of elimination from METIS, and what MUMPS makes of them, on grids of
// nodes with several unknowns each.
#include "small_systems.h"

#include <solvers/direct_solver.h>
#include <solvers/mumps.h>
#include <solvers/nested_dissection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr int n_components = 3;

  // n x n x n nodes in a box, each coupled to those around it
  struct Box
  {
    int n;

    unsigned int
    n_unknowns() const
    {
      return n_components * n * n * n;
    }

    template <typename Call>
    void
    for_each_entry(const Call &call) const
    {
      const int last = n - 1;
      for (const auto i : owned_part(n_unknowns()))
      {
        const int node = i / n_components;
        const int x = node % n, y = node / n % n, z = node / n / n;
        for (int c = std::max(z - 1, 0); c <= std::min(z + 1, last); ++c)
          for (int b = std::max(y - 1, 0); b <= std::min(y + 1, last); ++b)
            for (int a = std::max(x - 1, 0); a <= std::min(x + 1, last); ++a)
              for (unsigned int k = 0; k < n_components; ++k)
                call(static_cast<unsigned int>(i),
                     n_components * ((c * n + b) * n + a) + k);
      }
    }

    void
    make(LinearAlgebra::SparseMatrix &matrix) const
    {
      LinearAlgebra::SparsityPattern pattern(owned_part(n_unknowns()),
                                             MPI_COMM_WORLD);
      for_each_entry([&](const auto i, const auto j) { pattern.add(i, j); });
      pattern.compress();
      matrix.reinit(pattern);
      for_each_entry([&](const auto i, const auto j) {
        matrix.set(i, j, i == j ? 100. : -1.);
      });
      matrix.compress(dealii::VectorOperation::insert);
    }
  };

  // on rank 0; checks that each place is taken once, and that there are none
  // on the others
  std::vector<int>
  places_of(const LinearAlgebra::SparseMatrix &matrix,
            const MatrixSymmetry               symmetry)
  {
    std::vector<int>    places(3, 7);
    const LinearOutcome outcome = nested_dissection(matrix, symmetry, places);
    EXPECT_TRUE(outcome.success) << outcome.reason;
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    {
      EXPECT_TRUE(places.empty());
      return places;
    }
    std::vector<int> expected(matrix.m());
    std::iota(expected.begin(), expected.end(), 0);
    std::vector<int> sorted = places;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, expected);
    return places;
  }

  const auto both = {MatrixSymmetry::symmetric, MatrixSymmetry::none};

  class NestedDissection : public ::testing::Test
  {
  protected:
    void
    SetUp() override
    {
      if (!nested_dissection_is_available() || !Mumps::is_available())
        GTEST_SKIP() << "built without METIS or MUMPS";
    }

    // it must outlive the solver
    LinearAlgebra::SparseMatrix matrix, second;
  };
} // namespace



TEST_F(NestedDissection, GivesEachUnknownAPlace)
{
  Box{5}.make(matrix);
  for (const MatrixSymmetry symmetry : both)
    places_of(matrix, symmetry);
  make_matrix(string_rows(9), matrix);
  for (const MatrixSymmetry symmetry : both)
    places_of(matrix, symmetry);
}



TEST_F(NestedDissection, LeavesUnknownsOfANodeTogether)
{
  Box{4}.make(matrix);
  const std::vector<int> places = places_of(matrix, MatrixSymmetry::symmetric);
  // nodes whose unknowns are on two ranks may be torn apart
  const unsigned int n_whole = 10 * n_components;
  for (unsigned int i = 0; i < n_whole && i < places.size(); ++i)
    EXPECT_EQ(places[i], places[i - i % n_components] + int(i % n_components));
}



TEST_F(NestedDissection, TakesUnknownsWithoutNeighbours)
{
  make_matrix({{1., 0., 0.}, {0., 2., 0.}, {0., 0., 3.}}, matrix);
  for (const MatrixSymmetry symmetry : both)
    places_of(matrix, symmetry);
  // one of them is held
  make_matrix({{2., 0., 1.}, {0., 3., 0.}, {1., 0., 4.}}, second);
  for (const MatrixSymmetry symmetry : both)
    places_of(second, symmetry);
}



TEST_F(NestedDissection, TakesPatternsThatAreNotSymmetric)
{
  Rows rows = string_rows(12);
  for (unsigned int i = 0; i + 1 < rows.size(); ++i)
    rows[i + 1][i] = 0.;
  rows[11][0] = 1.;
  make_matrix(rows, matrix);
  places_of(matrix, MatrixSymmetry::none);
  DirectSolver solver("MUMPS", "METIS");
  ASSERT_TRUE(solver.initialize(matrix, MatrixSymmetry::none).success);
  ASSERT_TRUE(solver.factorize().success);
  const std::vector<double> expected(rows.size(), 2.);
  auto                      solution = distributed(expected);
  solution                           = 0.;
  ASSERT_TRUE(
    solver.solve(solution, distributed(times(rows, expected))).success);
  for (const double found : gathered(solution))
    EXPECT_NEAR(found, 2., 1e-12);
}



TEST_F(NestedDissection, SolvesAsOtherOrderingsDo)
{
  DirectSolver solver("MUMPS", "METIS");
  // the second pattern as after refinement
  for (const int n : {4, 6})
    for (const MatrixSymmetry symmetry : both)
    {
      solver.release();
      const Box box{n};
      box.make(matrix);
      ASSERT_TRUE(solver.initialize(matrix, symmetry).success);
      ASSERT_TRUE(solver.factorize().success);
      std::vector<double> load(box.n_unknowns());
      for (unsigned int i = 0; i < load.size(); ++i)
        load[i] = 1. + i % 7;
      const auto   right_hand_side = distributed(load);
      auto         found           = distributed(load);
      auto         expected        = found;
      DirectSolver other("MUMPS", "AMD");
      ASSERT_TRUE(other.initialize(matrix, symmetry).success);
      ASSERT_TRUE(other.factorize().success);
      ASSERT_TRUE(solver.solve(found, right_hand_side).success);
      ASSERT_TRUE(other.solve(expected, right_hand_side).success);
      expected -= found;
      EXPECT_LT(expected.linfty_norm(), 1e-13 * found.linfty_norm());
    }
}



TEST_F(NestedDissection, IsNamedInTheLog)
{
  Box{4}.make(matrix);
  DirectSolver solver("MUMPS", "METIS");
  ASSERT_TRUE(solver.initialize(matrix, MatrixSymmetry::symmetric).success);
  EXPECT_EQ(solver.description(), "MUMPS (ordering by METIS)");
}



TEST_F(NestedDissection, IsTheDefaultInThreeDimensions)
{
  Box{4}.make(matrix);
  for (const auto &[components, name] :
       {std::pair<unsigned int, std::string>{3, "METIS"}, {2, "AMD"}})
  {
    DirectSolver solver("MUMPS");
    LinearSystem system;
    system.matrix       = &matrix;
    system.symmetry     = MatrixSymmetry::symmetric;
    system.n_components = components;
    ASSERT_TRUE(solver.initialize(system).success);
    EXPECT_EQ(solver.description(), "MUMPS (ordering by " + name + ")");
  }
}



TEST_F(NestedDissection, HasFewerEntriesOfFactorsThanAmdInThreeDimensions)
{
  Box{14}.make(matrix);
  const auto entries = [&](const std::string &ordering) {
    LinearOutcome outcome;
    const Mumps   mumps(matrix, MatrixSymmetry::symmetric, outcome, ordering);
    EXPECT_TRUE(outcome.success) << outcome.reason;
    EXPECT_EQ(mumps.ordering(), ordering);
    return mumps.n_entries_of_factors();
  };
  EXPECT_LT(entries("METIS"), 0.9 * entries("AMD"));
}
