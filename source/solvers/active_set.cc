// SPDX-License-Identifier: GPL-2.0-or-later
// A quadratic problem with bounds,
//
//   minimise  1/2 x . K x - f . x   subject to   l <= x <= u,   r = K x - f,
//
// K symmetric, not always positive definite (Wu's crack density). Conditions
// for a minimum, with the multiplier -r at the bounds:
//
//   l < x < u: r = 0     x = l: r >= 0     x = u: r <= 0.
//
// The primal-dual active set [HWW15] holds i at the upper bound if -r_i + c
// (x_i - u_i) > 0. As all iterates here are within the bounds, that is x_i =
// u_i and r_i < 0, whatever c > 0 is; in the same way at the lower one. One
// iteration, with I the dofs that are not held:
//
//   1. K_II d_I = - r_I by preconditioned conjugate gradients, truncated
//   2. x(t) = projection of x + t d on the bounds, t = 1, 1/2, 1/4, ...
//      until the energy has fallen:  E(x(t)) - E(x) <= 1e-4 r . (x(t) - x)
//   3. r <- r + K (x(t) - x), new sets
//
// (More and Toraldo, SIAM J. Optim. 1 (1991), for the search along the
// projected path.) With x + d and new sets instead, the sets cycle in most
// iterations of a growing crack: K has positive entries off the diagonal, from
// the consistent mass matrix, and is no M-matrix, for which that method is
// known to converge.
//
// The energy is known up to a constant without f: E(x + m) - E(x) = r . m + 1/2
// m . K m, one product with K per trial, which updates r, too.

#include <deal.II/base/mpi.h>

#include <solvers/active_set.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // bounds closer than this leave nothing to solve for
    constexpr double same_bounds = 1e-14;
    // of r . move, the decrease that the slope promises (Armijo)
    constexpr double sufficient_decrease = 1e-4;
    // digits that a solve would add before the sets are known are wasted
    constexpr double loose_tolerance = 1e-3;
    // where they stay, this much below what is asked for
    constexpr double       safety                = 0.1;
    constexpr double       tightest_tolerance    = 1e-10;
    constexpr unsigned int max_linear_iterations = 1000;
    constexpr unsigned int max_bisections        = 40;
    // iterations of conjugate gradients between two questions whether to stop
    constexpr unsigned int iterations_unasked = 10;



    enum class Side : char
    {
      free,
      lower,
      upper
    };



    // The state of the method between its iterations.
    struct Iterate
    {
      const BoundedProblem &problem;
      Vector               &x;
      Vector               &r; // gradient of the energy at x
      std::vector<Side>     sides;
      std::vector<bool>     is_free; // neither held nor constrained
      Vector                direction;
      Vector                image; // matrix times a vector
      bool                  curved_downwards = false;
    };



    // Start within the bounds: x <- x + m, r <- r + K m.
    Iterate
    projected_start(const BoundedProblem &p, Vector &x, Vector &r)
    {
      Iterate state{p, x, r, {}, {}, r, r, false};
      Vector &move = state.direction;
      for (std::size_t i = 0; i < p.constrained.size(); ++i)
        move.begin()[i] =
          p.constrained[i]
            ? 0.
            : std::clamp(x.begin()[i], p.lower.begin()[i], p.upper.begin()[i]) -
                x.begin()[i];
      p.matrix.vmult(state.image, move);
      x.add(1., move);
      r.add(1., state.image);
      return state;
    }



    // held where a bound is reached and the energy falls beyond it
    Side
    side_of(const BoundedProblem &p,
            const std::size_t     i,
            const double          x,
            const double          r)
    {
      const double lower = p.lower.begin()[i], upper = p.upper.begin()[i];
      if ((x <= lower && r >= 0.) || upper - lower <= same_bounds)
        return Side::lower;
      return x >= upper && r <= 0. ? Side::upper : Side::free;
    }



    // Decide which dofs are held. Sets sizes and residual of @p outcome and
    // returns how many dofs changed sides.
    types::global_dof_index
    decide_sides(Iterate &state, ActiveSetOutcome &outcome)
    {
      const BoundedProblem &p     = state.problem;
      const std::size_t     n     = p.constrained.size();
      double                worst = 0.;
      // held, changed, and with a residual that is not finite
      std::vector<types::global_dof_index> counts(3, 0);
      const std::vector<Side>              before = std::move(state.sides);
      state.sides.assign(n, Side::free);
      state.is_free.assign(n, false);
      for (std::size_t i = 0; i < n; ++i)
      {
        const double r = state.r.begin()[i];
        if (!p.constrained[i])
          state.sides[i] = side_of(p, i, state.x.begin()[i], r);
        state.is_free[i] = !p.constrained[i] && state.sides[i] == Side::free;
        counts[0] += state.sides[i] != Side::free;
        counts[1] += before.empty() || state.sides[i] != before[i];
        if (state.is_free[i])
          worst = std::max(worst, std::abs(r / p.scale.begin()[i]));
        // NaN is neither held nor the largest
        counts[2] += !std::isfinite(r) || !std::isfinite(state.x.begin()[i]);
      }
      const MPI_Comm communicator = state.x.get_mpi_communicator();
      Utilities::MPI::sum(counts, communicator, counts);
      outcome.residual = counts[2] > 0
                           ? std::numeric_limits<double>::quiet_NaN()
                           : Utilities::MPI::max(worst, communicator);
      outcome.n_active = counts[0];
      return counts[1];
    }



    void
    keep_free(const Iterate &state, Vector &vector)
    {
      for (std::size_t i = 0; i < state.is_free.size(); ++i)
        if (!state.is_free[i])
          vector.begin()[i] = 0.;
    }



    // Conjugate gradients for K_II d = - r_I with the preconditioner M^-1, from
    // d = 0, until sqrt(rho . M^-1 rho) has fallen by the tolerance, rho the
    // linear residual; truncated (Steihaug, SIAM J. Numer. Anal. 20 (1983)) at
    // a search direction s with s . K s <= 0, which is taken as d: the energy
    // falls along it without end, so that it leads to a bound. s is a direction
    // of descent, r . s < 0, as a step of conjugate gradients always is.
    unsigned int
    find_direction(Iterate                       &state,
                   const FreeBlockPreconditioner &preconditioner,
                   const double                   tolerance)
    {
      Vector remainder(state.r), preconditioned(state.r);
      remainder *= -1.;
      keep_free(state, remainder);
      preconditioner.vmult(preconditioned, remainder);
      Vector       search(preconditioned);
      double       product    = remainder * preconditioned;
      const double target     = tolerance * tolerance * product;
      unsigned int iterations = 0;
      state.direction         = 0.;
      state.curved_downwards  = false;
      while (product > target && iterations < max_linear_iterations)
      {
        if (iterations % iterations_unasked == 0 &&
            is_to_stop(state.problem.stop, "iterations of the phase field"))
          break;
        ++iterations;
        state.problem.matrix.vmult(state.image, search);
        keep_free(state, state.image);
        const double curvature = search * state.image;
        if (!(curvature > 1e-14 * product))
        {
          // downhill it is: the search direction starts as the gradient
          state.curved_downwards = true;
          state.direction        = search;
          break;
        }
        const double length = product / curvature;
        state.direction.add(length, search);
        remainder.add(-length, state.image);
        preconditioner.vmult(preconditioned, remainder);
        const double new_product = remainder * preconditioned;
        search.sadd(new_product / product, 1., preconditioned);
        product = new_product;
      }
      return iterations;
    }



    // Step 2 and 3. Negative curvature: t begins such that the longest entry of
    // t d is 1, which is as far as the bounds can be apart.
    bool
    move_downhill(Iterate &state)
    {
      const BoundedProblem &p      = state.problem;
      double                factor = 1.;
      if (state.curved_downwards)
        // far enough to reach a bound, which are at most 1 apart
        factor = 1. / std::max(state.direction.linfty_norm(), 1e-300);
      Vector move(state.x);
      for (unsigned int k = 0; k < max_bisections; ++k, factor *= 0.5)
      {
        for (std::size_t i = 0; i < state.is_free.size(); ++i)
        {
          const double x = state.x.begin()[i];
          move.begin()[i] =
            state.is_free[i]
              ? std::clamp(x + factor * state.direction.begin()[i],
                           p.lower.begin()[i],
                           p.upper.begin()[i]) -
                  x
              : 0.;
        }
        p.matrix.vmult(state.image, move);
        const double slope  = state.r * move;
        const double change = slope + 0.5 * (state.image * move);
        if (slope < 0. && change <= sufficient_decrease * slope)
        {
          state.x.add(1., move);
          state.r.add(1., state.image);
          return true;
        }
      }
      return false;
    }
  } // namespace



  ActiveSetSolver::ActiveSetSolver(const ActiveSetOptions &options)
    : options(options)
    , preconditioner(options.patience)
  {}



  void
  ActiveSetSolver::reinit()
  {
    preconditioner.clear();
  }



  ActiveSetOutcome
  ActiveSetSolver::solve(const BoundedProblem &problem,
                         Vector               &solution,
                         Vector               &residual)
  {
    ActiveSetOutcome outcome;
    Iterate          state = projected_start(problem, solution, residual);
    preconditioner.set_matrix(problem);
    while (true)
    {
      const types::global_dof_index n_changed = decide_sides(state, outcome);
      if (outcome.iterations > 0)
        outcome.n_changes += n_changed;
      outcome.converged = outcome.residual <= options.tolerance;
      if (outcome.converged)
        return outcome;
      if (!std::isfinite(outcome.residual))
      {
        outcome.reason = "the residual of the phase field is not finite";
        return outcome;
      }
      if (outcome.iterations == options.max_iterations)
        break;

      ++outcome.iterations;
      double tolerance = loose_tolerance;
      if (n_changed == 0)
        tolerance = std::clamp(safety * options.tolerance / outcome.residual,
                               tightest_tolerance,
                               loose_tolerance);
      preconditioner.restrict_to(problem, state.is_free);
      if (is_to_stop(problem.stop, "multigrid of the phase field (ML)"))
      {
        outcome.reason = "asked to stop";
        return outcome;
      }
      const unsigned int n = find_direction(state, preconditioner, tolerance);
      outcome.linear_iterations += n;
      if (!state.curved_downwards)
        preconditioner.note_solve(n, -std::log10(tolerance));
      if (move_downhill(state))
        continue;
      // as low as rounding lets it
      outcome.converged = outcome.residual <= 1e3 * options.tolerance;
      if (outcome.converged)
        return outcome;
      if (!preconditioner.give_up_multigrid())
        break;
    }
    outcome.reason = "the phase field did not settle within " +
                     std::to_string(outcome.iterations) +
                     " iterations of the active set";
    return outcome;
  }
} // namespace MixedCracks
