// SPDX-License-Identifier: GPL-2.0-or-later
// Newton's method with a barrier and a potential, on functions of one variable.
#include <solvers/newton.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;

namespace
{
  // The minimum of a function of x, or another point where its derivative is 0,
  // with a barrier.
  struct GuardedProblem
  {
    std::function<double(double)> potential;
    double                        terms = 0.; // that cancel in it
    std::function<double(double)> value;      // its derivative
    std::function<double(double)> derivative;
    std::function<bool(double)>   admits;
    double                        x            = 0.;
    bool                          is_minimum   = true;
    double                        correction   = 0.;
    unsigned int                  n_potentials = 0;

    NewtonOutcome
    solve(const NewtonOptions &options = {})
    {
      NewtonProblem problem;
      problem.residual = [this]() {
        EXPECT_TRUE(admits(x)) << "the residual of " << x;
        return ResidualSize{std::abs(value(x)), 0.};
      };
      problem.update_matrix = [](bool) { return LinearOutcome(); };
      problem.solve         = [this](double) {
        correction = -value(x) / derivative(x);
        return LinearOutcome{true, 1, ""};
      };
      problem.move = [this](const double factor) { x += factor * correction; };
      problem.is_admissible = [this]() { return admits(x); };
      if (potential)
      {
        problem.potential = [this]() {
          ++n_potentials;
          return potential(x);
        };
        problem.potential_terms = [this]() { return terms; };
        problem.slope           = [this]() { return value(x) * correction; };
      }
      problem.is_minimum = is_minimum;
      return solve_newton(problem, options);
    }
  };

  const auto anything = [](double) { return true; };

  // minimum at 2, infinite at 0
  GuardedProblem
  with_barrier(const double start)
  {
    GuardedProblem problem;
    problem.potential  = [](const double x) { return x - 2. * std::log(x); };
    problem.value      = [](const double x) { return 1. - 2. / x; };
    problem.derivative = [](const double x) { return 2. / (x * x); };
    problem.admits     = [](const double x) { return x > 0.; };
    problem.x          = start;
    return problem;
  }
} // namespace



TEST(LineSearch, NeverGoesBeyondABarrier)
{
  for (const bool has_potential : {true, false})
    for (const double start : {1e-3, 0.5, 3.9, 10., 50.})
    {
      GuardedProblem problem = with_barrier(start);
      if (!has_potential)
        problem.potential = nullptr;
      const NewtonOutcome outcome = problem.solve();
      EXPECT_TRUE(outcome.converged) << outcome.reason;
      EXPECT_NEAR(problem.x, 2., 1e-6) << "from " << start;
    }
}



TEST(LineSearch, TurnsRoundWhereItsDirectionLeadsUp)
{
  // maximum at 0, minima at -1 and 1; from 0.1 Newton's direction is that of 0
  for (const double start : {0.1, -0.1, 0.5})
  {
    GuardedProblem problem;
    problem.potential = [](const double x) {
      return 0.25 * x * x * x * x - 0.5 * x * x;
    };
    problem.value      = [](const double x) { return x * x * x - x; };
    problem.derivative = [](const double x) { return 3. * x * x - 1.; };
    problem.admits     = anything;
    problem.x          = start;
    const NewtonOutcome outcome = problem.solve();
    EXPECT_TRUE(outcome.converged) << outcome.reason;
    EXPECT_NEAR(problem.x, start > 0. ? 1. : -1., 1e-6);
  }
}



TEST(LineSearch, TakesAStepThatLowersThePotentialThoughTheResidualGrows)
{
  // from 1 the full step leads to -0.718, where |R| is 1.05 and was 0.63; where
  // the potential does not decide, half of it is taken
  GuardedProblem problem;
  problem.potential  = [](const double x) { return x + std::exp(-x); };
  problem.value      = [](const double x) { return 1. - std::exp(-x); };
  problem.derivative = [](const double x) { return std::exp(-x); };
  problem.admits     = anything;
  for (const bool is_minimum : {true, false})
  {
    problem.x          = 1.;
    problem.is_minimum = is_minimum;
    NewtonOptions options;
    options.max_iterations = 1;
    EXPECT_FALSE(problem.solve(options).converged);
    const double step = 1. - std::exp(1.);
    EXPECT_NEAR(problem.x, 1. + (is_minimum ? step : 0.5 * step), 1e-12);
    options.max_iterations = 10;
    EXPECT_TRUE(problem.solve(options).converged);
    EXPECT_NEAR(problem.x, 0., 1e-6);
  }
}



// A minimum at which the potential, a sum of terms near 10, is 0: near to it
// what their rounding leaves is more than what the step gains.
TEST(LineSearch, FollowsTheResidualWhereThePotentialIsButRounding)
{
  const double   start = 2e-8;
  GuardedProblem problem;
  problem.potential = [start](const double x) {
    return 0.5 * x * x + (x < start ? 1e-15 : 0.);
  };
  problem.value      = [](const double x) { return x; };
  problem.derivative = [](double) { return 1.; };
  problem.admits     = anything;
  for (const double terms : {10., 0.})
  {
    problem.x                   = start;
    problem.terms               = terms;
    const NewtonOutcome outcome = problem.solve();
    EXPECT_EQ(outcome.converged, terms > 0.) << outcome.reason;
  }
}



TEST(LineSearch,
     AsksForAPotentialThatDoesNotDecideOnlyWhereAnEighthOfTheStepIsNoBetter)
{
  // from 10 an eighth of the step stays on this side of the barrier, from 50
  // not
  GuardedProblem problem;
  for (const double start : {1.5, 10.})
  {
    problem            = with_barrier(start);
    problem.is_minimum = false;
    EXPECT_TRUE(problem.solve().converged);
    EXPECT_EQ(problem.n_potentials, 0u);
  }
  problem            = with_barrier(50.);
  problem.is_minimum = false;
  EXPECT_TRUE(problem.solve().converged);
  EXPECT_GT(problem.n_potentials, 0u);
}



TEST(LineSearch, StaysWhereItWasIfNoStepIsAdmissible)
{
  GuardedProblem problem      = with_barrier(10.);
  problem.admits              = [](const double x) { return x == 10.; };
  const NewtonOutcome outcome = problem.solve();
  EXPECT_FALSE(outcome.converged);
  EXPECT_NEAR(problem.x, 10., 1e-9);
  EXPECT_NE(outcome.reason.find("determinant"), std::string::npos)
    << outcome.reason;
}



TEST(LineSearch, DoesNotStartInsideOut)
{
  GuardedProblem      problem = with_barrier(-1.);
  const NewtonOutcome outcome = problem.solve();
  EXPECT_FALSE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 0u);
  EXPECT_NE(outcome.reason.find("inside out"), std::string::npos)
    << outcome.reason;
}



TEST(LineSearch, ComparesResidualsInTheLineSearchByOneScale)
{
  // the residual grows tenfold, what it is relative to a hundredfold
  const ResidualSize before{0.1, 0., 1., 1.}, after{0.01, 0., 100., 1.};
  EXPECT_DOUBLE_EQ(after.relative_to(before).largest(), 1.);
  EXPECT_DOUBLE_EQ(before.relative_to(before).largest(), before.largest());
}
