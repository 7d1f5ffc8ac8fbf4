// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/base/mpi.h>


#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>

#include <solvers/active_set.h>
#include <solvers/projected_descent.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // bounds closer than this leave nothing to solve for
    constexpr double same_bounds = 1e-14;
    // the phase field lies between 0 and 1
    constexpr double largest_correction = 1e5;
    // digits that a solve would add before the sets are known are wasted
    constexpr double loose_tolerance = 1e-4;

    // The matrix on the free dofs and the identity on all others. Applied to
    // vectors that vanish outside the free dofs.
    class FreeBlock
    {
    public:
      FreeBlock(const LinearAlgebra::SparseMatrix &matrix,
                const std::vector<bool>           &is_free)
        : matrix(matrix)
        , is_free(is_free)
      {}

      void
      vmult(Vector &result, const Vector &source) const
      {
        matrix.vmult(result, source);
        double *values = result.begin();
        for (std::size_t i = 0; i < is_free.size(); ++i)
          if (!is_free[i])
            values[i] = 0.;
      }

    private:
      const LinearAlgebra::SparseMatrix &matrix;
      const std::vector<bool>           &is_free;
    };



    // fails where the operator is indefinite
    LinearOutcome
    solve_free_block(const FreeBlock              &block,
                     const DiagonalMatrix<Vector> &preconditioner,
                     const ActiveSetOptions       &options,
                     const double                  tolerance,
                     const Vector                 &right_hand_side,
                     Vector                       &solution)
    {
      LinearOutcome outcome;
      const double  size = right_hand_side.l2_norm();
      if (size == 0.)
        return outcome;
      SolverControl control(
        options.max_linear_iterations, tolerance * size, false, false);
      SolverCG<Vector> solver(control);
      try
      {
        solver.solve(block, solution, right_hand_side, preconditioner);
      }
      catch (const SolverControl::NoConvergence &)
      {
        outcome.success = false;
        outcome.reason  = "the phase-field operator is indefinite";
      }
      outcome.iterations = control.last_step();
      // the residual is updated, not computed anew: a correction this far
      // outside all bounds would cost it its digits
      if (outcome.success && solution.linfty_norm() > largest_correction)
      {
        outcome.success = false;
        outcome.reason  = "the phase-field operator is nearly singular";
      }
      return outcome;
    }
  } // namespace



  namespace
  {
    // whether all ranks find their sides in the same iteration before
    template <typename Sides>
    bool
    is_repeated(const Sides              &sides,
                const std::vector<Sides> &history,
                const MPI_Comm            communicator)
    {
      std::vector<int> is_same;
      for (const Sides &earlier : history)
        is_same.push_back(sides == earlier ? 1 : 0);
      Utilities::MPI::min(is_same, communicator, is_same);
      return std::find(is_same.begin(), is_same.end(), 1) != is_same.end();
    }
  } // namespace



  void
  invert_diagonal(const LinearAlgebra::SparseMatrix &matrix, Vector &inverse)
  {
    std::size_t i      = 0;
    double     *values = inverse.begin();
    for (const auto row : inverse.locally_owned_elements())
    {
      const double diagonal = std::abs(matrix.diag_element(row));
      values[i++]           = diagonal > 0. ? 1. / diagonal : 1.;
    }
  }



  std::vector<ActiveSetSolver::Side>
  ActiveSetSolver::decide_sides(const BoundedProblem &problem,
                                const Vector         &solution,
                                const Vector         &residual) const
  {
    std::vector<Side> sides(problem.constrained.size(), Side::free);
    const double     *x = solution.begin(), *r = residual.begin();
    const double *lower = problem.lower.begin(), *upper = problem.upper.begin();
    const double *scale = problem.scale.begin();
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      if (problem.constrained[i])
        continue;
      // positive where the energy falls with a growing phase field
      const double multiplier = -r[i] / scale[i];
      if (upper[i] - lower[i] <= same_bounds ||
          multiplier + options.weight * (x[i] - lower[i]) < 0.)
        sides[i] = Side::lower;
      else if (multiplier + options.weight * (x[i] - upper[i]) > 0.)
        sides[i] = Side::upper;
    }
    return sides;
  }



  LinearOutcome
  ActiveSetSolver::compute_correction(const BoundedProblem    &problem,
                                      const std::vector<Side> &sides,
                                      const Vector            &solution,
                                      const Vector            &residual,
                                      const double             tolerance,
                                      Vector                  &correction) const
  {
    // move the active dofs to their bounds, then solve for the free ones
    correction           = 0.;
    const double *x      = solution.begin();
    double       *values = correction.begin();
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (sides[i] == Side::lower)
        values[i] = problem.lower.begin()[i] - x[i];
      else if (sides[i] == Side::upper)
        values[i] = problem.upper.begin()[i] - x[i];

    Vector right_hand_side(residual);
    problem.matrix.vmult(right_hand_side, correction);
    right_hand_side.add(1., residual);
    right_hand_side *= -1.;
    std::vector<bool> is_free(sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      is_free[i] = sides[i] == Side::free && !problem.constrained[i];
      if (!is_free[i])
        right_hand_side.begin()[i] = 0.;
    }

    DiagonalMatrix<Vector> preconditioner;
    Vector                 inverse_diagonal(residual);
    invert_diagonal(problem.matrix, inverse_diagonal);
    preconditioner.reinit(inverse_diagonal);
    Vector free_correction(residual);
    free_correction = 0.;
    const LinearOutcome outcome =
      solve_free_block(FreeBlock(problem.matrix, is_free),
                       preconditioner,
                       options,
                       tolerance,
                       right_hand_side,
                       free_correction);
    correction.add(1., free_correction);
    return outcome;
  }



  ActiveSetOutcome
  ActiveSetSolver::solve(const BoundedProblem &problem,
                         Vector               &solution,
                         Vector               &residual) const
  {
    const Vector           start(solution), start_residual(residual);
    const ActiveSetOutcome settled = settle(problem, solution, residual);
    if (settled.converged)
      return settled;
    // downhill from where the step began, not from where a cycle left off
    solution = start;
    residual = start_residual;
    ActiveSetOutcome outcome =
      descend_within_bounds(problem, options, solution, residual);
    outcome.descents = outcome.iterations;
    outcome.iterations += settled.iterations;
    outcome.linear_iterations += settled.linear_iterations;
    outcome.n_changes += settled.n_changes;
    return outcome;
  }



  types::global_dof_index
  ActiveSetSolver::compare_sides(const BoundedProblem    &problem,
                                 const std::vector<Side> &sides,
                                 const std::vector<Side> &new_sides,
                                 const Vector            &residual,
                                 ActiveSetOutcome        &outcome)
  {
    std::vector<types::global_dof_index> counts(2, 0);
    double                               largest = 0.;
    for (std::size_t i = 0; i < new_sides.size(); ++i)
    {
      counts[0] += new_sides[i] != Side::free;
      counts[1] += sides.empty() || new_sides[i] != sides[i];
      if (new_sides[i] == Side::free && !problem.constrained[i])
        largest = std::max(
          largest, std::abs(residual.begin()[i] / problem.scale.begin()[i]));
    }
    const MPI_Comm communicator = residual.get_mpi_communicator();
    Utilities::MPI::sum(counts, communicator, counts);
    outcome.residual = Utilities::MPI::max(largest, communicator);
    outcome.n_active = counts[0];
    return counts[1];
  }



  ActiveSetOutcome
  ActiveSetSolver::settle(const BoundedProblem &problem,
                          Vector               &solution,
                          Vector               &residual) const
  {
    const MPI_Comm    communicator = solution.get_mpi_communicator();
    ActiveSetOutcome  outcome;
    Vector            correction(residual), image(residual);
    std::vector<Side> sides;
    bool              is_precise = false;
    std::vector<std::vector<Side>> history;
    for (; outcome.iterations <= options.max_iterations; ++outcome.iterations)
    {
      const std::vector<Side> new_sides =
        decide_sides(problem, solution, residual);
      const types::global_dof_index n_changed =
        compare_sides(problem, sides, new_sides, residual, outcome);
      const bool is_same = outcome.iterations > 0 && n_changed == 0;
      if (is_same && is_precise)
      {
        outcome.converged = true;
        return outcome;
      }
      if (outcome.iterations > 0)
        outcome.n_changes += n_changed;
      if (!is_same && is_repeated(new_sides, history, communicator))
      {
        outcome.reason = "the active set cycles";
        return outcome;
      }
      if (outcome.iterations == options.max_iterations)
        break;

      if (!is_same)
        history.push_back(new_sides);
      sides                      = new_sides;
      is_precise                 = is_same;
      const LinearOutcome linear = compute_correction(
        problem,
        sides,
        solution,
        residual,
        is_precise ? options.relative_tolerance : loose_tolerance,
        correction);
      outcome.linear_iterations += linear.iterations;
      if (!linear.success)
      {
        outcome.reason = linear.reason;
        return outcome;
      }
      solution.add(1., correction);
      problem.matrix.vmult(image, correction);
      residual.add(1., image);
    }
    outcome.reason = "the active set did not settle within " +
                     std::to_string(options.max_iterations) + " iterations";
    return outcome;
  }
} // namespace MixedCracks
