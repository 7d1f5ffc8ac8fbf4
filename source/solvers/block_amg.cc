// SPDX-License-Identifier: GPL-2.0-or-later
// FGMRES for displacement and pressure with a block-triangular preconditioner
// from the right: with the blocks of the elastic matrix (ElasticKernel)
//
//         u     p                     u     p
//    u ( A     B^T )             u ( A~    B^T )
//    p ( B     -C  )  = K,       p ( 0     -S~ )  = P,    K P^-1 y = rhs.
//
// With A~ = A and S~ = S = C + B A^-1 B^T the product
//
//   K P^-1 = ( 1         0 )
//            ( B A^-1    1 )
//
// has the eigenvalue 1 only, and FGMRES ends after two iterations; the closer
// the two are, the fewer it takes. P^-1 (f, g) is applied from the bottom up,
//
//   p = - S~^-1 g,    u = A~^-1 (f - B^T p),
//
// A~^-1 two levels or one cycle of multigrid (block_amg_setup.cc), S~^-1
// incomplete factors of the weighted mass matrix (AssembledAuxiliaries). From
// the right, so that the residual that GMRES minimises is the true one,
// whatever P is.
//
// Without pressure, with a symmetric matrix and one multigrid cycle that is
// symmetric itself: conjugate gradients with A~.
//
// Rows of p are multiplied by row_scale, sqrt(mean diag(A) * mean 1/diag(S~)),
// so that MPa-like and mm^2-like rows count alike in one norm.

#include <base/log.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

#include <solvers/block_amg.h>
#include <solvers/iteration_control.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // directions that are kept before it starts anew; fewer (30) and it does
    // not end where broken cells are compressed
    constexpr unsigned int restart       = 100;
    const char *const      asked_to_stop = "block AMG was asked to stop";
    // the end of a solution that an old one began may be too short to count
    constexpr double least_recorded = 0.5; // digits
    // matrices for which an old hierarchy is not tried after one had to be
    // given up: first 1, then so many
    constexpr unsigned int longest_pause = 3;
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
      solver.product().vmult(result, source);
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
    {}

    void
    vmult(Vector &result, const Vector &source) const
    {
      gather(source, solver.is_displacement, forces);
      displacements.resize(forces.size());
      if (solver.has_pressure)
      {
        gather(source, solver.system.is_pressure, fluxes);
        pressures.resize(fluxes.size());
        solver.mass_solver->vmult(pressures.data(), fluxes.data());
        for (double &pressure : pressures)
          pressure *= -1.;
        solver.product().pressure_forces(displacements.data(),
                                         pressures.data());
        for (std::size_t k = 0; k < forces.size(); ++k)
          forces[k] -= displacements[k];
      }
      if (solver.interpolation)
      {
        coarse_forces.resize(solver.interpolation->DomainMap().NumMyElements());
        coarse_displacements.resize(coarse_forces.size());
        spread(forces, solver.is_displacement, whole);
        multiply(*solver.interpolation,
                 coarse_forces.data(),
                 whole.data(),
                 /*transposed=*/true);
        solver.multigrid->vmult(coarse_displacements.data(),
                                coarse_forces.data());
        multiply(
          *solver.interpolation, whole.data(), coarse_displacements.data());
        displacements.clear();
        for (std::size_t i = 0; i < whole.size(); ++i)
          if (solver.is_displacement[i])
            displacements.push_back(whole[i]);
      }
      else
        solver.multigrid->vmult(displacements.data(), forces.data());
      put_together(source, result);
      // rows of displacements are not scaled
      if (solver.smoother)
        solver.smoother->smooth(result, source);
      if (solver.exact_block)
        solver.exact_block->smooth(result, source);
    }

  private:
    // chosen rows, not scaled; 0 where a constraint determines the unknown
    void
    gather(const Vector            &source,
           const std::vector<bool> &chosen,
           std::vector<double>     &part) const
    {
      const double *r = source.begin(), *scale = solver.row_scale.begin();
      part.clear();
      for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i])
          part.push_back(solver.system.is_constrained[i] ? 0.
                                                         : r[i] / scale[i]);
    }

    // part -> chosen rows, 0 elsewhere
    static void
    spread(const std::vector<double> &part,
           const std::vector<bool>   &chosen,
           std::vector<double>       &whole)
    {
      whole.assign(chosen.size(), 0.);
      for (std::size_t i = 0, next = 0; i < chosen.size(); ++i)
        if (chosen[i])
          whole[i] = part[next++];
    }

    void
    put_together(const Vector &source, Vector &result) const
    {
      const double *r = source.begin(), *scale = solver.row_scale.begin();
      std::size_t   next_displacement = 0, next_pressure = 0;
      for (std::size_t i = 0; i < solver.is_displacement.size(); ++i)
      {
        const double value = solver.is_displacement[i]
                               ? displacements[next_displacement++]
                               : pressures[next_pressure++];
        // what is constrained stands alone in its row
        result.begin()[i] = solver.system.is_constrained[i]
                              ? r[i] / scale[i] / solver.matrix_diagonal
                              : value;
      }
    }

    const BlockAmgSolver       &solver;
    mutable std::vector<double> forces, fluxes, displacements, pressures;
    mutable std::vector<double> whole, coarse_forces, coarse_displacements;
  };



  BlockAmgSolver::BlockAmgSolver(const LinearSolverOptions &options)
    : options(options)
  {}



  BlockAmgSolver::~BlockAmgSolver() = default;



  LinearOutcome
  BlockAmgSolver::initialize(const LinearSystem &new_system)
  {
    system = new_system;
    drop_hierarchy();
    when_new  = {};
    n_untried = pause = 0;
    GrowingVectorMemory<Vector>::release_unused_memory();
    is_displacement = system.is_pressure;
    is_displacement.flip();
    const bool any =
      std::find(system.is_pressure.begin(), system.is_pressure.end(), true) !=
      system.is_pressure.end();
    if (needs_matrix())
      AssembledProduct(*system.matrix, {}).reinit(row_scale);
    else
      system.product->reinit(row_scale);
    has_pressure =
      Utilities::MPI::max(any ? 1 : 0, row_scale.get_mpi_communicator());
    return {};
  }



  LinearOutcome
  BlockAmgSolver::factorize()
  {
    is_old = true;
    if (smoother)
      smoother->reinit();
    return {};
  }



  LinearOutcome
  BlockAmgSolver::iterate(const double  relative_tolerance,
                          Vector       &solution,
                          const Vector &right_hand_side)
  {
    Vector scaled(right_hand_side);
    scaled.scale(row_scale);
    const double         tolerance = relative_tolerance * scaled.l2_norm();
    LinearOutcome        outcome;
    IterationControl     control(system.stop,
                             options.max_iterations,
                             tolerance,
                             is_old ? &when_new : nullptr,
                             options.tolerated_growth);
    const ScaledMatrix   matrix(*this);
    const Preconditioner preconditioner(*this);
    try
    {
      if (options.is_matrix_free)
      {
        // half of the vectors of FGMRES; the preconditioner is always the same
        using Gmres = SolverGMRES<Vector>;
        Gmres solver(control,
                     typename Gmres::AdditionalData(restart + 2, true));
        solver.solve(matrix, solution, scaled, preconditioner);
      }
      else if (!uses_conjugate_gradients())
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
        format("%s: the residual is %.2g times the tolerance after "
               "%u iterations",
               options.is_matrix_free ? "matrix-free" : "block AMG",
               control.last_value() / tolerance,
               control.last_step());
      if (control.is_interrupted)
        outcome.reason = asked_to_stop;
    }
    outcome.iterations = control.last_step();
    if (!is_old && !is_recorded && outcome.success &&
        control.record.digits() >= least_recorded)
    {
      when_new    = control.record;
      is_recorded = true;
    }
    return outcome;
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
    const bool is_tried  = multigrid && is_old && options.tolerated_growth > 0.;
    if (is_tried && n_untried > 0)
      --n_untried;
    else if (is_tried)
    {
      const LinearOutcome outcome =
        iterate(relative_tolerance, solution, right_hand_side);
      if (outcome.success || outcome.reason == asked_to_stop)
      {
        pause = 0;
        return outcome;
      }
      earlier = outcome.iterations;
      // while a crack runs the next one will be no better
      pause     = std::min(2 * pause + 1, longest_pause);
      n_untried = pause;
    }
    if (!multigrid || is_old)
    {
      if (system.as_set_up)
        system.as_set_up([this]() { set_up(); });
      else
        set_up();
      if (is_to_stop(system.stop, "set-up of block AMG (ML)"))
        return {false, earlier, asked_to_stop};
    }
    LinearOutcome outcome =
      iterate(relative_tolerance, solution, right_hand_side);
    outcome.iterations += earlier;
    return outcome;
  }



  bool
  BlockAmgSolver::uses_conjugate_gradients() const
  {
    // a smoother after the coarse level, and none before it, is not symmetric
    return !has_pressure && !smoother &&
           system.symmetry == MatrixSymmetry::symmetric;
  }



  std::string
  BlockAmgSolver::description() const
  {
    return uses_conjugate_gradients()
             ? "conjugate gradients with smoothed aggregation"
           : options.is_matrix_free ? "GMRES with matrix-free products"
                                    : "FGMRES with smoothed aggregation";
  }



  double
  BlockAmgSolver::operator_complexity() const
  {
    return multigrid ? multigrid->operator_complexity() : 0.;
  }
} // namespace MixedCracks
