// SPDX-License-Identifier: GPL-2.0-or-later
#include <solvers/newton.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace
  {
    bool
    is_to_stop(const NewtonProblem &problem)
    {
      return problem.is_to_stop && problem.is_to_stop();
    }



    // Full step first; halved while the residual grows. Returns the residual
    // at the point where the iterate was left.
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



    LinearOutcome
    compute_correction(const NewtonProblem &problem,
                       const bool           force_new_matrix,
                       const double         linear_tolerance)
    {
      const LinearOutcome matrix = problem.update_matrix(force_new_matrix);
      return matrix.success ? problem.solve(linear_tolerance) : matrix;
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



  NewtonOutcome
  solve_newton(const NewtonProblem &problem, const NewtonOptions &options)
  {
    NewtonOutcome outcome;
    outcome.first = outcome.last = problem.residual();
    outcome.reason               = in_words_if_not_finite(outcome.first);
    if (!outcome.reason.empty())
      return outcome;
    bool         force_new_matrix = false;
    const double target           = std::max(
      options.tolerance, options.relative_tolerance * outcome.first.largest());
    LinearTolerance linear_tolerance(options);
    while (!(outcome.last.largest() <= target))
    {
      if (options.enough_iterations > 0 &&
          outcome.iterations >= options.enough_iterations &&
          outcome.last.largest() < outcome.first.largest())
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
      const LinearOutcome linear =
        compute_correction(problem,
                           force_new_matrix,
                           linear_tolerance.next(outcome.last.largest()));
      if (!linear.success)
      {
        outcome.reason = linear.reason;
        return outcome;
      }
      const ResidualSize before = outcome.last;
      outcome.last              = line_search(problem, options, before);
      outcome.iterations += 1;
      outcome.linear_iterations += linear.iterations;
      outcome.reason = in_words_if_not_finite(outcome.last);
      if (!outcome.reason.empty())
        return outcome;
      linear_tolerance.learn(before.largest(), outcome.last.largest());
      force_new_matrix =
        outcome.last.largest() > options.required_reduction * before.largest();
    }
    outcome.converged = true;
    return outcome;
  }
} // namespace MixedCracks
