// SPDX-License-Identifier: GPL-2.0-or-later
// Newton's method for R(x) = 0 with a line search,
//
//   A d = - R(x),   x <- x + 2^-k d,   the first k = 0, 1, ... with
//   |R(x + 2^-k d)| < |R(x)|   (or the last one tried).
//
// |R| is the larger of the two relative sizes, of displacement and pressure,
// see ResidualSize. Where R is piecewise linear with kinks (semismooth) and A
// is a generalised derivative, a full step ends within the piece it leads to. A
// may be older than x: then |R| falls by a factor rather than to 0, and A is
// made anew when the factor is above required_reduction.
//
// How accurate iterative solves are, |A d + R| <= eta |R|: forcing terms of
// Eisenstat and Walker, SIAM J. Sci. Comput. 17 (1996), choice 1,
//
//   eta_k = abs( |R_k| - |R_(k-1) + A d_(k-1)| ) / |R_(k-1)|,
//
// what the last linear model was off by. The linear residual is taken as
// eta_(k-1) |R_(k-1)|, what was asked for:  eta_k = abs(|R_k|/|R_(k-1)| -
// eta_(k-1)). Bounded by the loosest and tightest allowed, by half of
// tolerance/|R|, below which digits would be wasted, and by half of
// required_reduction, without which a good A would be given up for a bad solve.
//
// Problems with inadmissible iterates (finite strain) have the line search of
// line_search.cc instead of the one here.

#include <solvers/line_search.h>
#include <solvers/newton.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace MixedCracks
{
  namespace
  {
    bool
    is_to_stop(const NewtonProblem &problem)
    {
      return problem.is_to_stop && problem.is_to_stop();
    }



    // x stands at x + factor d; halving moves back by half of what was gone.
    // The residual at the place where x is left is known when this returns.
    ResidualSize
    line_search(const NewtonProblem &problem,
                const NewtonOptions &options,
                const ResidualSize  &before)
    {
      problem.move(1.);
      ResidualSize size   = problem.residual();
      double       factor = 1.;
      for (unsigned int i = 0; i < options.max_bisections; ++i)
      {
        // '<' rather than '>=': a residual that is NaN is no progress
        if (size.largest() < before.largest() || is_to_stop(problem))
          break;
        problem.move(-0.5 * factor);
        factor *= 0.5;
        size = problem.residual();
      }
      return size;
    }



    SearchOutcome
    search(const NewtonProblem &problem,
           const NewtonOptions &options,
           const ResidualSize  &before)
    {
      if (problem.is_admissible)
        return guarded_line_search(problem, options, before);
      SearchOutcome outcome;
      outcome.found = true;
      outcome.size  = line_search(problem, options, before);
      return outcome;
    }



    // Whether the residual still falls. Near a state that is not stable, as
    // single cells beside a crack may be, a guarded Newton's method circles:
    // ten iterations that gain less than a tenth are followed by no better
    // ones.
    class Progress
    {
    public:
      bool
      goes_on(const double residual)
      {
        residuals.push_back(residual);
        return residuals.size() <= window ||
               residual <=
                 largest_ratio * residuals[residuals.size() - 1 - window];
      }

    private:
      static constexpr unsigned int window        = 10;
      static constexpr double       largest_ratio = 0.9;
      std::vector<double>           residuals;
    };



    std::string
    why_no_step(const SearchOutcome &step)
    {
      return std::string("no step along Newton's direction lowers the residual "
                         "or the energy") +
             (step.met_barrier ? " and keeps the determinant of the "
                                 "deformation gradient above 0"
                               : "") +
             ": there may be no equilibrium near at this load";
    }



    std::string
    in_words_if_not_finite(const ResidualSize &size)
    {
      const bool displacement = !std::isfinite(size.displacement);
      if (!displacement && std::isfinite(size.pressure))
        return "";
      return std::string("the residual of the ") +
             (displacement ? "displacement" : "pressure") +
             " is not finite: loads, prescribed values or constants of the "
             "material are too large, or the matrix is singular";
    }



    // the residual at the start, or why there is none
    NewtonOutcome
    start_newton(const NewtonProblem &problem)
    {
      NewtonOutcome outcome;
      if (problem.is_admissible && !problem.is_admissible())
      {
        outcome.reason = "the state that Newton's method starts from is turned "
                         "inside out: the determinant of its deformation "
                         "gradient is not above 0 everywhere";
        return outcome;
      }
      outcome.first = outcome.last = problem.residual();
      outcome.reason               = in_words_if_not_finite(outcome.first);
      return outcome;
    }



    LinearOutcome
    compute_correction(const NewtonProblem &problem,
                       const bool           force_new_matrix,
                       const double         linear_tolerance)
    {
      const LinearOutcome matrix = problem.update_matrix(force_new_matrix);
      return matrix.success ? problem.solve(linear_tolerance) : matrix;
    }



    // How accurate linear solves should be.
    class LinearTolerance
    {
    public:
      explicit LinearTolerance(const NewtonOptions &options)
        : options(options)
        , wanted(options.loose_linear_tolerance)
      {}

      // for the residual of size @p residual
      double
      next(const double residual)
      {
        // Half of the tolerance: the linear solver measures in another norm.
        // Not of a looser target: the acceleration of the coupling would see
        // the noise (doc/solvers.md).
        used = std::max({std::min(wanted, options.loose_linear_tolerance),
                         options.tight_linear_tolerance,
                         0.5 * options.tolerance / residual});
        used = std::min(used, 0.5 * options.required_reduction);
        return used;
      }

      // An exact linear model would have left used * before.
      void
      learn(const double before, const double after)
      {
        wanted = std::abs(after / before - used);
      }

    private:
      const NewtonOptions &options;
      double               wanted;
      double               used = 0.;
    };
  } // namespace



  // Ends when |R| <= max(tolerance, relative_tolerance |R_0|). The alternate
  // minimisation (staggered) asks for little while phi still moves: a reduction
  // by relative_tolerance, or enough_iterations with any reduction.
  NewtonOutcome
  solve_newton(const NewtonProblem &problem, const NewtonOptions &options)
  {
    NewtonOutcome outcome = start_newton(problem);
    if (!outcome.reason.empty())
      return outcome;
    bool         force_new_matrix = false;
    const double target           = std::max(
      options.tolerance, options.relative_tolerance * outcome.first.largest());
    LinearTolerance linear_tolerance(options);
    Progress        progress;
    while (!(outcome.last.largest() <= target))
    {
      if (options.enough_iterations > 0 &&
          outcome.iterations >= options.enough_iterations &&
          outcome.last.largest() < outcome.first.largest() &&
          outcome.last.largest() <= options.enough_residual)
        break;
      if (is_to_stop(problem))
      {
        outcome.reason = "asked to stop";
        return outcome;
      }
      if (outcome.iterations == options.max_iterations)
      {
        outcome.reason = "no convergence within " +
                         std::to_string(options.max_iterations) +
                         " Newton iterations";
        return outcome;
      }
      if (problem.is_admissible && !progress.goes_on(outcome.last.largest()))
      {
        outcome.reason = "no progress within 10 Newton iterations";
        return outcome;
      }
      const LinearOutcome linear =
        compute_correction(problem,
                           force_new_matrix,
                           linear_tolerance.next(outcome.last.largest()));
      if (!linear.success)
      {
        outcome.reason = linear.reason;
        return outcome;
      }
      const ResidualSize  before = outcome.last;
      const SearchOutcome step   = search(problem, options, before);
      outcome.last               = step.size;
      outcome.iterations += 1;
      outcome.linear_iterations += linear.iterations;
      outcome.reason = in_words_if_not_finite(outcome.last);
      if (!outcome.reason.empty())
        return outcome;
      if (!step.found)
      {
        outcome.reason = why_no_step(step);
        if (force_new_matrix)
          return outcome;
        force_new_matrix = true;
        continue;
      }
      linear_tolerance.learn(before.largest(), outcome.last.largest());
      force_new_matrix =
        outcome.last.largest() > options.required_reduction * before.largest();
    }
    outcome.converged = true;
    outcome.reason.clear();
    return outcome;
  }
} // namespace MixedCracks
