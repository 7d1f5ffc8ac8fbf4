// SPDX-License-Identifier: GPL-2.0-or-later
// Newton's method on functions of one variable, given by callbacks.
#include <solvers/newton.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace MixedCracks;

namespace
{
  // f(x) = 0 with the derivative of a matrix that may be an old one
  struct ScalarProblem
  {
    std::function<double(double)> value;
    std::function<double(double)> derivative;
    double                        x             = 0.;
    double                        slope         = 0.; // 0: no matrix yet
    bool                          keeps_old_one = false;
    unsigned int                  n_matrices    = 0;
    unsigned int                  n_forced      = 0;
    double                        correction    = 0.;

    NewtonOutcome
    solve(const NewtonOptions &options = {})
    {
      NewtonProblem problem;
      problem.residual = [this]() {
        return ResidualSize{std::abs(value(x)), 0.};
      };
      problem.update_matrix = [this](const bool force) {
        n_forced += force;
        if (slope == 0. || force || !keeps_old_one)
        {
          slope = derivative(x);
          ++n_matrices;
        }
        return LinearOutcome();
      };
      problem.solve = [this](double) {
        correction = -value(x) / slope;
        return LinearOutcome{true, 1, ""};
      };
      problem.move = [this](const double factor) { x += factor * correction; };
      return solve_newton(problem, options);
    }
  };

  // weak in compression, stiff in tension, as a split has it
  ScalarProblem
  kinked(const double load)
  {
    return {[load](const double x) { return (x < 0. ? 0.1 : 1.) * x - load; },
            [](const double x) { return x < 0. ? 0.1 : 1.; }};
  }
} // namespace



TEST(Newton, SolvesALinearProblemInOneIteration)
{
  ScalarProblem       problem{[](const double x) { return 2. * x - 4.; },
                        [](double) { return 2.; }};
  const NewtonOutcome outcome = problem.solve();
  EXPECT_TRUE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 1u);
  EXPECT_EQ(outcome.linear_iterations, 1u);
  EXPECT_EQ(problem.n_matrices, 1u);
  EXPECT_DOUBLE_EQ(problem.x, 2.);
  EXPECT_DOUBLE_EQ(outcome.first.displacement, 4.);
  EXPECT_DOUBLE_EQ(outcome.last.displacement, 0.);
}



TEST(Newton, DoesNothingAtTheSolution)
{
  ScalarProblem problem{
    [](const double x) { return 2. * x - 4.; }, [](double) { return 2.; }, 2.};
  const NewtonOutcome outcome = problem.solve();
  EXPECT_TRUE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 0u);
  EXPECT_EQ(problem.n_matrices, 0u);
}



TEST(Newton, CrossesAKink)
{
  for (const double start : {-7., -0.01, 5.})
    for (const double load : {-0.3, 2.})
    {
      ScalarProblem problem       = kinked(load);
      problem.x                   = start;
      const NewtonOutcome outcome = problem.solve();
      EXPECT_TRUE(outcome.converged) << outcome.reason;
      // one step to the right side of the kink, halved steps included
      EXPECT_LE(outcome.iterations, 3u);
      EXPECT_NEAR(problem.x, load < 0. ? 10. * load : load, 1e-7);
    }
}



TEST(Newton, ForcesANewMatrixWhenTheOldOneFails)
{
  ScalarProblem problem       = kinked(2.);
  problem.x                   = 1.;
  problem.keeps_old_one       = true;
  problem.slope               = 0.6; // contracts by 2/3 only
  const NewtonOutcome outcome = problem.solve();
  EXPECT_TRUE(outcome.converged) << outcome.reason;
  EXPECT_EQ(problem.n_forced, 1u);
  EXPECT_EQ(problem.n_matrices, 1u);
  EXPECT_EQ(outcome.iterations, 2u);
  EXPECT_NEAR(problem.x, 2., 1e-7);
}



TEST(Newton, UsesAnOldMatrixAsLongAsItContracts)
{
  ScalarProblem problem       = kinked(2.);
  problem.x                   = 1.;
  problem.keeps_old_one       = true;
  problem.slope               = 1.05; // contracts by 1/21
  const NewtonOutcome outcome = problem.solve();
  EXPECT_TRUE(outcome.converged) << outcome.reason;
  EXPECT_EQ(problem.n_matrices, 0u);
  EXPECT_NEAR(problem.x, 2., 1e-7);
}



TEST(Newton, SurvivesAnOldMatrixThatDiverges)
{
  ScalarProblem problem       = kinked(2.);
  problem.x                   = 1.;
  problem.keeps_old_one       = true;
  problem.slope               = 0.02; // a full step would overshoot fiftyfold
  const NewtonOutcome outcome = problem.solve();
  EXPECT_TRUE(outcome.converged) << outcome.reason;
  EXPECT_LE(outcome.iterations, 3u);
  EXPECT_NEAR(problem.x, 2., 1e-7);
}



TEST(Newton, ReportsDivergence)
{
  ScalarProblem       problem{[](const double x) { return 1. + x * x; },
                        [](const double x) { return 2. * x; },
                        1.3};
  const NewtonOutcome outcome = problem.solve();
  EXPECT_FALSE(outcome.converged);
  EXPECT_FALSE(outcome.reason.empty());
  EXPECT_LE(outcome.iterations, NewtonOptions().max_iterations);
}



TEST(Newton, ReportsAResidualThatIsNoNumber)
{
  ScalarProblem problem{
    [](const double x) { return x < 1.5 ? 2. * x - 4. : std::sqrt(-x); },
    [](double) { return 2.; },
    0.};
  NewtonOptions options;
  options.max_bisections      = 0;
  const NewtonOutcome outcome = problem.solve(options);
  EXPECT_FALSE(outcome.converged);
  EXPECT_FALSE(outcome.reason.empty());
}



TEST(Newton, PassesTheReasonOfAFailedSolveOn)
{
  NewtonProblem problem;
  problem.residual      = []() { return ResidualSize{1., 0.}; };
  problem.update_matrix = [](bool) { return LinearOutcome(); };
  problem.solve         = [](double) {
    return LinearOutcome{false, 0, "out of memory"};
  };
  problem.move          = [](double) {};
  NewtonOutcome outcome = solve_newton(problem, {});
  EXPECT_FALSE(outcome.converged);
  EXPECT_NE(outcome.reason.find("out of memory"), std::string::npos);

  problem.update_matrix = [](bool) {
    return LinearOutcome{false, 0, "singular"};
  };
  outcome = solve_newton(problem, {});
  EXPECT_FALSE(outcome.converged);
  EXPECT_NE(outcome.reason.find("singular"), std::string::npos);
}



TEST(Newton, StopsAtTheRelativeTolerance)
{
  ScalarProblem problem = kinked(2.);
  problem.x             = 1.;
  problem.keeps_old_one = true;
  problem.slope         = 1.05;
  NewtonOptions options;
  options.relative_tolerance  = 0.05;
  const NewtonOutcome outcome = problem.solve(options);
  EXPECT_TRUE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 1u);
  EXPECT_NEAR(outcome.last.largest(), 1. / 21., 1e-12);
}



TEST(Newton, TakesAnyReductionAfterEnoughIterations)
{
  // an old matrix that reduces the residual by a half
  ScalarProblem problem = kinked(2.);
  problem.x             = 1.;
  problem.keeps_old_one = true;
  problem.slope         = 2.;
  NewtonOptions options;
  options.required_reduction  = 0.9;
  options.relative_tolerance  = 1e-3;
  options.enough_iterations   = 3;
  const NewtonOutcome outcome = problem.solve(options);
  EXPECT_TRUE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 3u);
  EXPECT_NEAR(outcome.last.largest(), 0.125, 1e-12);
}



TEST(Newton, JudgesTheLargerOfBothResiduals)
{
  unsigned int  n_moves = 0;
  NewtonProblem problem;
  problem.residual = [&]() { return ResidualSize{0., n_moves == 0 ? 1. : 0.}; };
  problem.update_matrix       = [](bool) { return LinearOutcome(); };
  problem.solve               = [](double) { return LinearOutcome(); };
  problem.move                = [&](double) { ++n_moves; };
  const NewtonOutcome outcome = solve_newton(problem, {});
  EXPECT_TRUE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 1u);
}



namespace
{
  // A linear system solved no better than asked for; the tolerances that were
  // asked for, and the iterations.
  struct InexactSolves
  {
    std::vector<double> tolerances;
    NewtonOutcome       outcome;
  };

  InexactSolves
  solve_inexactly(const std::function<double(double)> &value,
                  const std::function<double(double)> &derivative,
                  const double                         start,
                  const NewtonOptions                 &options)
  {
    InexactSolves result;
    double        x = start, correction = 0.;
    NewtonProblem problem;
    problem.residual = [&]() { return ResidualSize{std::abs(value(x)), 0.}; };
    problem.update_matrix = [](bool) { return LinearOutcome(); };
    problem.solve         = [&](const double tolerance) {
      result.tolerances.push_back(tolerance);
      correction = -(1. - tolerance) * value(x) / derivative(x);
      return LinearOutcome{true, 1, ""};
    };
    problem.move   = [&](const double factor) { x += factor * correction; };
    result.outcome = solve_newton(problem, options);
    return result;
  }
} // namespace



TEST(Newton, AsksForExactSolutionsOnceTheModelIsKnownToBeLinear)
{
  const NewtonOptions options;
  const InexactSolves linear =
    solve_inexactly([](const double x) { return 3. * x - 6.; },
                    [](double) { return 3.; },
                    0.,
                    options);
  EXPECT_TRUE(linear.outcome.converged) << linear.outcome.reason;
  ASSERT_EQ(linear.tolerances.size(), 2u);
  EXPECT_DOUBLE_EQ(linear.tolerances[0], options.loose_linear_tolerance);
  // the rest: from 6e-3 to half of the tolerance
  EXPECT_NEAR(linear.tolerances[1], 0.5 * options.tolerance / 6e-3, 1e-12);
}



TEST(Newton, AsksForLooseSolutionsWhileTheModelIsOff)
{
  NewtonOptions options;
  options.loose_linear_tolerance = 0.05;
  options.tolerance              = 1e-12;
  const InexactSolves curved =
    solve_inexactly([](const double x) { return x * x * x - 8.; },
                    [](const double x) { return 3. * x * x; },
                    5.,
                    options);
  EXPECT_TRUE(curved.outcome.converged) << curved.outcome.reason;
  ASSERT_GE(curved.tolerances.size(), 5u);
  // far away no model is worth more, close by they tighten
  EXPECT_DOUBLE_EQ(curved.tolerances[1], 0.05);
  EXPECT_LT(curved.tolerances.back(), 1e-3);
  for (const double tolerance : curved.tolerances)
  {
    EXPECT_LE(tolerance, 0.5 * options.required_reduction);
    EXPECT_GE(tolerance, options.tight_linear_tolerance);
  }
}
