// SPDX-License-Identifier: GPL-2.0-or-later
// The active set method on problems of a few unknowns whose solution is
// computed by hand; on two ranks the same numbers have to come out.
#include "small_systems.h"

#include <solvers/active_set.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  // minimise 1/2 x.Kx - load.x with lower <= x <= upper
  struct Obstacle
  {
    Rows                rows;
    std::vector<double> load;
    std::vector<double> lower;
    std::vector<double> upper;
    std::vector<double> start;
    std::vector<bool>   constrained = std::vector<bool>(load.size(), false);
  };

  struct Solution
  {
    ActiveSetOutcome    outcome;
    std::vector<double> x;
    std::vector<double> gradient; // as the solver left it
  };

  Solution
  solve(const Obstacle &obstacle, ActiveSetOptions options = {})
  {
    LinearAlgebra::SparseMatrix matrix;
    make_matrix(obstacle.rows, matrix);
    std::vector<double> gradient = times(obstacle.rows, obstacle.start);
    for (std::size_t i = 0; i < gradient.size(); ++i)
      gradient[i] -= obstacle.load[i];

    std::vector<bool> constrained;
    for (const auto i : owned_part(obstacle.load.size()))
      constrained.push_back(obstacle.constrained[i]);
    const auto lower    = distributed(obstacle.lower);
    const auto upper    = distributed(obstacle.upper);
    const auto scale    = distributed(std::vector<double>(gradient.size(), 1.));
    auto       x        = distributed(obstacle.start);
    auto       residual = distributed(gradient);
    const auto outcome  = ActiveSetSolver(options).solve(
      {matrix, lower, upper, scale, constrained}, x, residual);
    return {outcome, gathered(x), gathered(residual)};
  }

  void
  expect_near(const std::vector<double> &found,
              const std::vector<double> &expected,
              const double               tolerance = 1e-9)
  {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], tolerance) << "unknown " << i;
  }

  // The conditions of a solution: within the bounds, and where the gradient
  // does not vanish it pushes against the bound
  void
  expect_optimal(const Obstacle &obstacle,
                 const Solution &solution,
                 const double    tolerance = 1e-8)
  {
    std::vector<double> gradient = times(obstacle.rows, solution.x);
    for (std::size_t i = 0; i < gradient.size(); ++i)
    {
      SCOPED_TRACE("unknown " + std::to_string(i));
      gradient[i] -= obstacle.load[i];
      const double above_lower = solution.x[i] - obstacle.lower[i];
      const double below_upper = obstacle.upper[i] - solution.x[i];
      EXPECT_GE(above_lower, -tolerance);
      EXPECT_GE(below_upper, -tolerance);
      EXPECT_TRUE(gradient[i] <= tolerance || above_lower <= tolerance);
      EXPECT_TRUE(gradient[i] >= -tolerance || below_upper <= tolerance);
      EXPECT_NEAR(gradient[i], solution.gradient[i], tolerance);
    }
  }

  // A string of five nodes under a load of -1 per node hangs down to -4.5;
  // the ground is at -3.5. By hand: the middle lies on the ground, then
  // 2 x1 - x2 = -1 and -x1 + 2 x2 = -1 - 3.5.
  const Obstacle            grounded{string_rows(5),
                          std::vector<double>(5, -1.),
                          std::vector<double>(5, -3.5),
                          std::vector<double>(5, 100.),
                          std::vector<double>(5, 0.)};
  const std::vector<double> grounded_solution = {-13. / 6.,
                                                 -10. / 3.,
                                                 -3.5,
                                                 -10. / 3.,
                                                 -13. / 6.};
} // namespace



TEST(ActiveSet, FixesTheNodeOnTheGround)
{
  const Solution solution = solve(grounded);
  EXPECT_TRUE(solution.outcome.converged) << solution.outcome.reason;
  EXPECT_TRUE(solution.outcome.reason.empty());
  EXPECT_EQ(solution.outcome.n_active, 1u);
  EXPECT_LT(solution.outcome.residual, 1e-8);
  expect_near(solution.x, grounded_solution);
  // pushed up by the ground: -x2 + 2 x3 - x4 + 1
  expect_near(solution.gradient, {0., 0., 2. / 3., 0., 0.});
  expect_optimal(grounded, solution);
}



TEST(ActiveSet, ReleasesNodesThatStartOnTheBound)
{
  Obstacle obstacle = grounded;
  obstacle.start    = obstacle.lower;
  Solution solution = solve(obstacle);
  EXPECT_TRUE(solution.outcome.converged) << solution.outcome.reason;
  EXPECT_GT(solution.outcome.n_changes, 0u);
  expect_near(solution.x, grounded_solution);

  // pulled away from the upper bound: every node is released
  obstacle.lower = std::vector<double>(5, -100.);
  obstacle.upper = obstacle.start = std::vector<double>(5, 0.);
  solution                        = solve(obstacle);
  EXPECT_TRUE(solution.outcome.converged) << solution.outcome.reason;
  EXPECT_EQ(solution.outcome.n_active, 0u);
  expect_near(solution.x, {-2.5, -4., -4.5, -4., -2.5});
}



TEST(ActiveSet, HoldsBothBoundsAtOnce)
{
  // antisymmetric load on seven nodes; by hand as above with x4 = 0
  const Obstacle obstacle{string_rows(7),
                          {-1., -1., -1., 0., 1., 1., 1.},
                          std::vector<double>(7, -1.75),
                          std::vector<double>(7, 1.75),
                          std::vector<double>(7, 0.)};
  const Solution solution = solve(obstacle);
  EXPECT_TRUE(solution.outcome.converged) << solution.outcome.reason;
  EXPECT_EQ(solution.outcome.n_active, 2u);
  expect_near(solution.x, {-1.375, -1.75, -1.375, 0., 1.375, 1.75, 1.375});
  expect_optimal(obstacle, solution);
}



TEST(ActiveSet, MovesNodesWithEqualBoundsThere)
{
  Obstacle obstacle = grounded;
  obstacle.lower = obstacle.upper = {-100., 1., -100., -100., -100.};
  obstacle.upper                  = {100., 1., 100., 100., 100.};
  const Solution solution         = solve(obstacle);
  EXPECT_TRUE(solution.outcome.converged) << solution.outcome.reason;
  // x1 = (1 - 1)/2; right of the node a parabola through 1 and 0 at node 6
  expect_near(solution.x, {0., 1., -0.75, -1.5, -1.25});
  EXPECT_EQ(solution.outcome.n_active, 1u);
}



TEST(ActiveSet, NeverMovesConstrainedUnknowns)
{
  Obstacle obstacle       = grounded;
  obstacle.start[2]       = -8.;
  obstacle.constrained[2] = true;
  const Solution solution = solve(obstacle);
  EXPECT_TRUE(solution.outcome.converged) << solution.outcome.reason;
  EXPECT_EQ(solution.x[2], -8.);
  // its neighbours are held by the ground all the same
  expect_near(solution.x, {-2.25, -3.5, -8., -3.5, -2.25});
}



TEST(ActiveSet, SaysWhenItsIterationsDoNotSuffice)
{
  ActiveSetOptions options;
  options.max_iterations  = 1;
  const Solution solution = solve(grounded, options);
  EXPECT_FALSE(solution.outcome.converged);
  EXPECT_NE(solution.outcome.reason.find("did not settle"), std::string::npos)
    << solution.outcome.reason;
}



TEST(ActiveSet, StartsFromOutsideTheBounds)
{
  Obstacle obstacle       = grounded;
  obstacle.start          = {-20., 300., -3., -20., 200.};
  const Solution solution = solve(obstacle);
  EXPECT_TRUE(solution.outcome.converged) << solution.outcome.reason;
  expect_near(solution.x, grounded_solution);
}



namespace
{
  // Positive definite, but off-diagonal entries of both signs: without the
  // projection the sets {3}, {1}, {1,2,3} follow each other from 0 without end,
  // whatever the constant of the criterion. The only solution is (0, -1/4, 0).
  const Obstacle cycling{{{5., 4., -2.}, {4., 4., -4.}, {-2., -4., 9.}},
                         {0., -1., 3.},
                         std::vector<double>(3, -1e6),
                         std::vector<double>(3, 0.),
                         std::vector<double>(3, 0.)};
} // namespace



TEST(ActiveSet, DoesNotCycle)
{
  const Solution solution = solve(cycling);
  EXPECT_TRUE(solution.outcome.converged) << solution.outcome.reason;
  EXPECT_LE(solution.outcome.iterations, 6u);
  EXPECT_EQ(solution.outcome.n_active, 2u);
  expect_near(solution.x, {0., -0.25, 0.}, 1e-8);
  expect_near(solution.gradient, {-1., 0., -2.}, 1e-8);
}



namespace
{
  // The homogeneous operator of Wu's functional, -phi'' - phi, by finite
  // differences on n intervals of the length h; phi is 0 at the first node,
  // the last has no flux.
  Obstacle
  wu_profile(const unsigned int n, const double h)
  {
    const unsigned int n_nodes = n + 1;
    Obstacle           obstacle{string_rows(n_nodes, 2. - h * h),
                      std::vector<double>(n_nodes, 0.),
                      std::vector<double>(n_nodes, 0.),
                      std::vector<double>(n_nodes, 1.),
                      std::vector<double>(n_nodes, 1.)};
    obstacle.rows[n][n] = 1. - 0.5 * h * h;
    obstacle.upper[0]   = 0.;
    return obstacle;
  }
} // namespace



TEST(ActiveSet, FindsTheProfileOfWu)
{
  // sin(x) up to pi/2, 1 from there on; the operator is indefinite on wider
  // free sets
  const unsigned int n        = 60;
  const double       h        = 0.05;
  const Obstacle     obstacle = wu_profile(n, h);
  const Solution     solution = solve(obstacle);
  ASSERT_TRUE(solution.outcome.converged) << solution.outcome.reason;
  expect_optimal(obstacle, solution, 1e-7);
  for (unsigned int i = 0; i <= n; ++i)
    EXPECT_NEAR(solution.x[i],
                i * h < 0.5 * dealii::numbers::PI ? std::sin(i * h) : 1.,
                h * h);
}



TEST(ActiveSet, SurvivesIndefiniteAndSingularFreeBlocks)
{
  // All nodes but the ends are free at first. The operator is singular on
  // 2 sin(angle/2) = h with angle = pi/n, definite below, indefinite above.
  const unsigned int n        = 20;
  const double       singular = 2. * std::sin(0.5 * dealii::numbers::PI / n);
  for (const double factor : {0.9, 1. - 1e-9, 1., 1. + 1e-9, 1.1, 2.})
  {
    SCOPED_TRACE("h = " + std::to_string(factor) + " of the singular one");
    Obstacle obstacle = wu_profile(n, factor * singular);
    obstacle.lower[0] = obstacle.upper[0] = 1.;
    obstacle.lower[n] = obstacle.upper[n] = 1.;
    obstacle.start                        = std::vector<double>(n + 1, 0.5);
    const Solution solution               = solve(obstacle);
    for (const double x : solution.x)
      EXPECT_TRUE(std::isfinite(x));
    if (solution.outcome.converged)
      expect_optimal(obstacle, solution, 1e-7);
    else
      EXPECT_FALSE(solution.outcome.reason.empty());
  }
}
