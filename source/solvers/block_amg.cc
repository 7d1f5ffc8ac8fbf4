// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/log.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

#include <solvers/block_amg.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // directions FGMRES keeps before it starts anew
    constexpr unsigned int restart = 100;
    // a few iterations say nothing about a hierarchy
    constexpr unsigned int always_tolerated = 4;
  } // namespace



  // The rows of displacements and pressures have different units; scaled
  // they are comparable, and one norm serves for both.
  class BlockAmgSolver::ScaledMatrix
  {
  public:
    explicit ScaledMatrix(const BlockAmgSolver &solver)
      : solver(solver)
    {}

    void
    vmult(Vector &result, const Vector &source) const
    {
      solver.system.matrix->vmult(result, source);
      result.scale(solver.row_scale);
    }

  private:
    const BlockAmgSolver &solver;
  };



  class BlockAmgSolver::Preconditioner
  {
  public:
    explicit Preconditioner(const BlockAmgSolver &solver)
      : solver(solver)
      , n(solver.is_displacement.size())
      , pressure(solver.row_scale)
      , rest(solver.row_scale)
    {}

    void
    vmult(Vector &result, const Vector &source) const
    {
      const double *r = source.begin(), *scale = solver.row_scale.begin();
      rest = 0.;
      if (solver.has_pressure)
      {
        solve_pressure(r);
        // of the product only the rows of displacements are used
        solver.system.matrix->vmult(rest, pressure);
      }
      part.clear();
      for (std::size_t i = 0; i < n; ++i)
        if (solver.is_displacement[i])
          part.push_back(solver.system.is_constrained[i]
                           ? 0.
                           : r[i] / scale[i] - rest.begin()[i]);
      solution.resize(part.size());
      solver.multigrid->vmult(solution.data(), part.data());
      put_together(r, result);
      if (solver.smoothing.size() > 0)
      {
        solver.system.matrix->vmult(rest, result);
        rest.sadd(-1., 1., source);
        rest.scale(solver.smoothing);
        result.add(1., rest);
      }
    }

  private:
    // -S~^-1 of the pressure rows of r; 0 in those of displacements
    void
    solve_pressure(const double *r) const
    {
      const double *scale = solver.row_scale.begin();
      part.clear();
      for (std::size_t i = 0; i < n; ++i)
        if (!solver.is_displacement[i])
          part.push_back(solver.system.is_constrained[i] ? 0.
                                                         : -r[i] / scale[i]);
      solution.resize(part.size());
      solver.mass_solver->vmult(solution.data(), part.data());
      std::size_t next = 0;
      for (std::size_t i = 0; i < n; ++i)
        if (!solver.is_displacement[i])
        {
          const double value  = solution[next++];
          pressure.begin()[i] = solver.system.is_constrained[i] ? 0. : value;
        }
        else
          pressure.begin()[i] = 0.;
    }

    // solution and pressure into one vector
    void
    put_together(const double *r, Vector &result) const
    {
      const double *scale  = solver.row_scale.begin();
      double       *values = result.begin();
      std::size_t   next   = 0;
      for (std::size_t i = 0; i < n; ++i)
      {
        values[i] =
          solver.is_displacement[i] ? solution[next++] : pressure.begin()[i];
        if (solver.system.is_constrained[i])
          // stands alone in its row
          values[i] = r[i] / scale[i] / solver.matrix_diagonal;
      }
    }

    const BlockAmgSolver       &solver;
    const std::size_t           n;
    mutable Vector              pressure, rest;
    mutable std::vector<double> part, solution;
  };



  BlockAmgSolver::BlockAmgSolver(const LinearSolverOptions &options)
    : options(options)
  {}



  BlockAmgSolver::~BlockAmgSolver() = default;



  LinearOutcome
  BlockAmgSolver::initialize(const LinearSystem &new_system)
  {
    system = new_system;
    multigrid.reset();
    mass_solver.reset();
    smoothing.clear();
    GrowingVectorMemory<Vector>::release_unused_memory();
    is_displacement = system.is_pressure;
    is_displacement.flip();
    row_scale.reinit(system.matrix->locally_owned_range_indices(),
                     system.matrix->get_mpi_communicator());
    const bool any =
      std::find(system.is_pressure.begin(), system.is_pressure.end(), true) !=
      system.is_pressure.end();
    has_pressure =
      Utilities::MPI::max(any ? 1 : 0, system.matrix->get_mpi_communicator());
    return {};
  }



  LinearOutcome
  BlockAmgSolver::factorize()
  {
    is_old = true;
    if (smoothing.size() > 0)
      set_smoothing();
    return {};
  }



  LinearOutcome
  BlockAmgSolver::iterate(const double       relative_tolerance,
                          const unsigned int max_iterations,
                          Vector            &solution,
                          const Vector      &right_hand_side)
  {
    Vector scaled(right_hand_side);
    scaled.scale(row_scale);
    const double         tolerance = relative_tolerance * scaled.l2_norm();
    LinearOutcome        outcome;
    SolverControl        control(max_iterations, tolerance, false, false);
    const ScaledMatrix   matrix(*this);
    const Preconditioner preconditioner(*this);
    try
    {
      if (!uses_conjugate_gradients())
      {
        SolverFGMRES<Vector> solver(
          control, typename SolverFGMRES<Vector>::AdditionalData(restart));
        solver.solve(matrix, solution, scaled, preconditioner);
      }
      else
      {
        SolverCG<Vector> solver(control);
        solver.solve(matrix, solution, scaled, preconditioner);
      }
    }
    catch (const SolverControl::NoConvergence &)
    {
      outcome.success = false;
      outcome.reason =
        printed("block AMG: the residual is %.2g times the tolerance after "
                "%u iterations",
                control.last_value() / tolerance,
                control.last_step());
    }
    outcome.iterations  = control.last_step();
    const double digits = std::log10(control.initial_value() / tolerance);
    // remembered for patience()
    if (!is_old && iterations_per_digit == 0. && digits > 0.5)
      iterations_per_digit = outcome.iterations / digits;
    return outcome;
  }



  unsigned int
  BlockAmgSolver::patience(const double relative_tolerance) const
  {
    const double digits = -std::log10(relative_tolerance);
    return std::min<double>(options.max_iterations,
                            always_tolerated + options.tolerated_growth *
                                                 iterations_per_digit * digits);
  }



  LinearOutcome
  BlockAmgSolver::solve(Vector       &solution,
                        const Vector &right_hand_side,
                        const double  relative_tolerance)
  {
    solution = 0.;
    if (right_hand_side.l2_norm() == 0.)
      return {};
    unsigned int earlier = 0;
    if (multigrid && is_old && options.tolerated_growth > 0.)
    {
      const LinearOutcome outcome = iterate(relative_tolerance,
                                            patience(relative_tolerance),
                                            solution,
                                            right_hand_side);
      if (outcome.success)
        return outcome;
      earlier = outcome.iterations;
    }
    if (!multigrid || is_old)
      set_up();
    LinearOutcome outcome = iterate(
      relative_tolerance, options.max_iterations, solution, right_hand_side);
    outcome.iterations += earlier;
    return outcome;
  }



  bool
  BlockAmgSolver::uses_conjugate_gradients() const
  {
    // the sweep after the cycle, and none before it, is not symmetric
    return !has_pressure && smoothing.size() == 0 &&
           system.symmetry == MatrixSymmetry::symmetric;
  }



  std::string
  BlockAmgSolver::description() const
  {
    return uses_conjugate_gradients()
             ? "conjugate gradients with smoothed aggregation"
             : "FGMRES with smoothed aggregation";
  }



  double
  BlockAmgSolver::operator_complexity() const
  {
    return multigrid ? multigrid->operator_complexity() : 0.;
  }
} // namespace MixedCracks
