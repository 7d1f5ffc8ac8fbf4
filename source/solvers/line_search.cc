// SPDX-License-Identifier: GPL-2.0-or-later
// A line search for problems with a barrier, beyond which iterates make no
// sense (det F <= 0), and with a potential Pi whose stationary points are the
// solutions. A step x + a d is taken if it is admissible and
//
//   |R(x + a d)| < |R(x)|                    or
//   Pi(x + a d) <= Pi(x) + c a Pi'(x) d      with c = 1e-4 (Armijo).
//
// Either of them alone fails: the residual has minima that are no solutions, at
// which it was seen to stall for ever once cells are broken; and near a
// solution with constraints, where the potential is curved, full steps that
// converge quadratically are refused by it (Maratos). |R| is relative to what
// cancels in it at x, not at x + a d: terms that have grown do not make a
// residual small.
//
// Where the solution is a minimum (is_minimum), Pi has the last word: the
// residual counts only where Pi does not grow by more than rounding, which is
// that of the terms it is made of: of a body without strain Pi is 0. And where
// Pi'(x) d > 0, d leads up: -d is searched then, by the potential alone.
//
// A problem that need not be a minimum is asked for its potential, which costs
// more than a residual there, only when neither the full step nor its half, its
// quarter or its eighth lowers the residual.

#include <solvers/line_search.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  namespace
  {
    constexpr double armijo                = 1e-4;
    constexpr double rounding_of_potential = 1e-12; // of the potential

    // What a fall of the potential excuses where the solution is no minimum of
    // it: a residual that grows by more is that of another place.
    constexpr double largest_growth = 10.;

    // The smallest part of a step that is taken for its residual alone.
    constexpr double smallest_without_potential = 0.125;

    class GuardedSearch
    {
    public:
      GuardedSearch(const NewtonProblem &problem,
                    const NewtonOptions &options,
                    const ResidualSize  &before)
        : problem(problem)
        , options(options)
        , before(before)
      {}

      SearchOutcome
      run()
      {
        const bool decides = problem.potential && problem.is_minimum;
        if (!decides && residual_is_enough())
          return outcome;
        move_to(0.);
        if (problem.potential)
        {
          start = problem.potential();
          terms = terms_of_potential();
          slope = problem.slope();
        }
        bisect();
        return outcome;
      }

    private:
      // the iterate stands at x + outcome.factor d
      void
      move_to(const double factor)
      {
        if (factor != outcome.factor)
          problem.move(factor - outcome.factor);
        outcome.factor = factor;
      }



      // Whether x + factor d is admissible; its residual is known then.
      bool
      try_factor(const double factor)
      {
        move_to(factor);
        const bool admissible = problem.is_admissible();
        outcome.met_barrier |= !admissible;
        if (admissible)
          outcome.size = problem.residual();
        return admissible;
      }



      bool
      residual_falls() const
      {
        return outcome.size.relative_to(before).largest() < before.largest();
      }



      bool
      residual_is_enough()
      {
        for (double factor = 1.; factor >= smallest_without_potential;
             factor *= 0.5)
        {
          outcome.found = try_factor(factor) && residual_falls();
          if (outcome.found || (problem.is_to_stop && problem.is_to_stop()))
            break;
        }
        return outcome.found;
      }



      double
      terms_of_potential() const
      {
        return problem.potential_terms ? problem.potential_terms() : 0.;
      }



      // of the difference of the potential between start and now
      double
      rounding(const double now) const
      {
        return rounding_of_potential *
                 std::max(std::abs(start), std::abs(now)) +
               std::numeric_limits<double>::epsilon() *
                 std::max(terms, terms_of_potential());
      }



      // '<=' of numbers that are none is false
      bool
      is_good_enough() const
      {
        if (!problem.potential)
          return residual_falls();
        const double now = problem.potential();
        const bool   is_lower =
          slope != 0. && now <= start + armijo * outcome.factor * slope;
        const bool may_count_residual =
          outcome.factor > 0. &&
          (!problem.is_minimum || now <= start + rounding(now));
        const bool is_near =
          problem.is_minimum || outcome.size.relative_to(before).largest() <=
                                  largest_growth * before.largest();
        return (is_lower && is_near) ||
               (may_count_residual && residual_falls());
      }



      void
      bisect()
      {
        double factor = slope > 0. ? -1. : 1.;
        for (unsigned int i = 0; i <= options.max_guarded_bisections; ++i)
        {
          outcome.found = try_factor(factor) && is_good_enough();
          if (outcome.found || (problem.is_to_stop && problem.is_to_stop()))
            break;
          factor *= 0.5;
        }
        if (outcome.found)
          return;
        move_to(0.);
        outcome.size = problem.residual();
      }



      const NewtonProblem &problem;
      const NewtonOptions &options;
      const ResidualSize  &before;
      double               start = 0.; // the potential there
      double               terms = 0.; // that cancel in it
      double               slope = 0.;
      SearchOutcome        outcome;
    };
  } // namespace



  SearchOutcome
  guarded_line_search(const NewtonProblem &problem,
                      const NewtonOptions &options,
                      const ResidualSize  &before)
  {
    return GuardedSearch(problem, options, before).run();
  }
} // namespace MixedCracks
