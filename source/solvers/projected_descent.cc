// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/base/mpi.h>

#include <solvers/projected_descent.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    constexpr double       sufficient_decrease = 1e-4;
    constexpr double       inner_tolerance     = 1e-3;
    constexpr unsigned int max_bisections      = 40;
    // of the criterion's weight, an energy density
    constexpr double relative_residual = 1e-9;



    // what the method keeps between its iterations
    struct Descent
    {
      const BoundedProblem &problem;
      Vector               &x;
      Vector               &r;
      std::vector<bool>     is_free;
      Vector                direction;
      Vector                image; // matrix times a direction
      bool                  curved_downwards = false;
    };



    // Free are the dofs between their bounds, and those at a bound that the
    // residual pushes inwards. Returns the largest residual of a free dof.
    double
    find_free_dofs(Descent &d)
    {
      const BoundedProblem &p       = d.problem;
      double                largest = 0.;
      d.is_free.assign(p.constrained.size(), false);
      for (std::size_t i = 0; i < d.is_free.size(); ++i)
      {
        const double x = d.x.begin()[i], r = d.r.begin()[i];
        const double lower = p.lower.begin()[i], upper = p.upper.begin()[i];
        const bool   held = (x <= lower && r >= 0.) || (x >= upper && r <= 0.);
        d.is_free[i]      = !p.constrained[i] && !held && lower < upper;
        if (d.is_free[i])
          largest = std::max(largest, std::abs(r / p.scale.begin()[i]));
      }
      return Utilities::MPI::max(largest, d.x.get_mpi_communicator());
    }



    void
    keep_free(const Descent &d, Vector &vector)
    {
      for (std::size_t i = 0; i < d.is_free.size(); ++i)
        if (!d.is_free[i])
          vector.begin()[i] = 0.;
    }



    // Truncated conjugate gradients for the direction: stops at a direction
    // of negative curvature and takes that one.
    unsigned int
    find_direction(Descent &d, const Vector &inverse_diagonal)
    {
      Vector remainder(d.r);
      remainder *= -1.;
      keep_free(d, remainder);
      Vector preconditioned(remainder);
      preconditioned.scale(inverse_diagonal);
      Vector       search(preconditioned);
      double       product = remainder * preconditioned;
      const double target  = inner_tolerance * inner_tolerance * product;
      d.direction          = 0.;
      d.curved_downwards   = false;
      unsigned int       iterations     = 0;
      const unsigned int max_iterations = 300;
      while (product > target && iterations < max_iterations)
      {
        ++iterations;
        d.problem.matrix.vmult(d.image, search);
        keep_free(d, d.image);
        const double curvature = search * d.image;
        if (!(curvature > 1e-14 * product))
        {
          // downhill it is: the search direction starts as the gradient
          d.curved_downwards = true;
          d.direction        = search;
          break;
        }
        const double length = product / curvature;
        d.direction.add(length, search);
        remainder.add(-length, d.image);
        preconditioned = remainder;
        preconditioned.scale(inverse_diagonal);
        const double new_product = remainder * preconditioned;
        search.sadd(new_product / product, 1., preconditioned);
        product = new_product;
      }
      return iterations;
    }



    // Move along the projected direction until the energy falls. False when
    // it does not, which only rounding can cause.
    bool
    move_downhill(Descent &d)
    {
      const BoundedProblem &p      = d.problem;
      double                factor = 1.;
      if (d.curved_downwards)
        // far enough to reach a bound, which are at most 1 apart
        factor = 1. / std::max(d.direction.linfty_norm(), 1e-300);
      Vector move(d.x);
      for (unsigned int i = 0; i < max_bisections; ++i, factor *= 0.5)
      {
        for (std::size_t j = 0; j < d.is_free.size(); ++j)
        {
          const double x  = d.x.begin()[j];
          move.begin()[j] = d.is_free[j]
                              ? std::clamp(x + factor * d.direction.begin()[j],
                                           p.lower.begin()[j],
                                           p.upper.begin()[j]) -
                                  x
                              : 0.;
        }
        p.matrix.vmult(d.image, move);
        const double slope  = d.r * move;
        const double change = slope + 0.5 * (d.image * move);
        if (slope < 0. && change <= sufficient_decrease * slope)
        {
          d.x.add(1., move);
          d.r.add(1., d.image);
          return true;
        }
      }
      return false;
    }



    // the start has to lie within the bounds
    void
    project_start(Descent &d)
    {
      const BoundedProblem &p = d.problem;
      Vector                move(d.x);
      for (std::size_t i = 0; i < p.constrained.size(); ++i)
      {
        const double x = d.x.begin()[i];
        move.begin()[i] =
          p.constrained[i]
            ? 0.
            : std::clamp(x, p.lower.begin()[i], p.upper.begin()[i]) - x;
      }
      p.matrix.vmult(d.image, move);
      d.x.add(1., move);
      d.r.add(1., d.image);
    }



    types::global_dof_index
    count_held(const Descent &d)
    {
      types::global_dof_index count = 0;
      for (std::size_t i = 0; i < d.is_free.size(); ++i)
        count += !d.is_free[i] && !d.problem.constrained[i];
      return Utilities::MPI::sum(count, d.x.get_mpi_communicator());
    }
  } // namespace



  ActiveSetOutcome
  descend_within_bounds(const BoundedProblem   &problem,
                        const ActiveSetOptions &options,
                        Vector                 &solution,
                        Vector                 &residual)
  {
    Descent d{problem, solution, residual, {}, residual, residual, false};
    Vector  inverse_diagonal(residual);
    invert_diagonal(problem.matrix, inverse_diagonal);
    project_start(d);
    ActiveSetOutcome outcome;
    while (true)
    {
      outcome.residual = find_free_dofs(d);
      outcome.n_active = count_held(d);
      if (outcome.residual <= relative_residual * options.weight)
      {
        outcome.converged = true;
        return outcome;
      }
      if (outcome.iterations == options.max_descents)
        break;
      ++outcome.iterations;
      outcome.linear_iterations += find_direction(d, inverse_diagonal);
      if (!move_downhill(d))
      {
        // as low as rounding lets it
        outcome.converged =
          outcome.residual <= 1e3 * relative_residual * options.weight;
        break;
      }
    }
    if (!outcome.converged)
      outcome.reason = "the phase field did not settle within " +
                       std::to_string(outcome.iterations) +
                       " iterations of the safeguard";
    return outcome;
  }
} // namespace MixedCracks
