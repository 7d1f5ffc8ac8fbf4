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
// Rows of p are multiplied by pressure_scale, sqrt(mean diag(A) * mean
// 1/diag(S~)), so that MPa-like and mm^2-like rows count alike in one norm.

#include <base/log.h>
#include <base/memory.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

#include <solvers/block_amg.h>
#include <solvers/iteration_control.h>
#include <solvers/matrix_block.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

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
      solver.scale_pressure_rows(result);
    }

  private:
    const BlockAmgSolver &solver;
  };



  class BlockAmgSolver::Preconditioner
  {
  public:
    explicit Preconditioner(const BlockAmgSolver &solver)
      : solver(solver)
    {
      solver.product().reinit(forces);
      fluxes.resize(solver.pressures.size());
      values.resize(solver.pressures.size());
    }

    void
    vmult(Vector &result, const Vector &source) const
    {
      if (solver.has_pressure)
      {
        find_pressures(source);
        for (std::size_t k = 0; k < values.size(); ++k)
          result.local_element(solver.pressures[k]) = values[k];
        solver.product().pressure_forces(forces, result);
        forces.sadd(-1., 1., source);
      }
      else
        forces = source;
      for (const unsigned int i : solver.constrained)
        forces.local_element(i) = 0.;
      if (solver.interpolation)
        solve_on_coarse_level(result);
      else
        solve_for_displacements(result);
      for (std::size_t k = 0; k < values.size(); ++k)
        result.local_element(solver.pressures[k]) = values[k];
      // what is constrained stands alone in its row
      for (const unsigned int i : solver.constrained)
        result.local_element(i) =
          source.local_element(i) / solver.scale_of(i) / solver.matrix_diagonal;
      // rows of displacements are not scaled
      if (solver.smoother)
        solver.smoother->smooth(result, source);
      if (solver.exact_block)
        solver.exact_block->smooth(result, source);
    }

  private:
    // p = - S~^-1 g
    void
    find_pressures(const Vector &source) const
    {
      for (std::size_t k = 0; k < fluxes.size(); ++k)
      {
        const unsigned int i = solver.pressures[k];
        fluxes[k]            = solver.system.is_constrained[i]
                                 ? 0.
                                 : -source.local_element(i) / solver.pressure_scale;
      }
      solver.mass_solver->vmult(values.data(), fluxes.data());
    }

    // u = P M(P^T forces)
    void
    solve_on_coarse_level(Vector &result) const
    {
      coarse_forces.resize(solver.interpolation->DomainMap().NumMyElements());
      coarse_displacements.resize(coarse_forces.size());
      multiply(*solver.interpolation,
               coarse_forces.data(),
               forces.begin(),
               /*transposed=*/true);
      solver.multigrid->vmult(coarse_displacements.data(),
                              coarse_forces.data());
      multiply(
        *solver.interpolation, result.begin(), coarse_displacements.data());
    }

    // u = M(forces)
    void
    solve_for_displacements(Vector &result) const
    {
      const std::vector<bool> &chosen = solver.is_displacement;
      coarse_forces.clear();
      for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i])
          coarse_forces.push_back(forces.local_element(i));
      coarse_displacements.resize(coarse_forces.size());
      solver.multigrid->vmult(coarse_displacements.data(),
                              coarse_forces.data());
      for (std::size_t i = 0, next = 0; i < chosen.size(); ++i)
        if (chosen[i])
          result.local_element(i) = coarse_displacements[next++];
    }

    const BlockAmgSolver       &solver;
    mutable Vector              forces;
    mutable std::vector<double> fluxes, values; // of owned pressures
    mutable std::vector<double> coarse_forces, coarse_displacements;
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
    // the next mesh needs other sizes
    if (options.is_matrix_free)
      return_free_memory();
    is_displacement = system.is_pressure;
    is_displacement.flip();
    pressures.clear();
    constrained.clear();
    for (unsigned int i = 0; i < is_displacement.size(); ++i)
    {
      if (system.is_pressure[i])
        pressures.push_back(i);
      if (system.is_constrained[i])
        constrained.push_back(i);
    }
    if (needs_matrix())
      AssembledProduct(*system.matrix, {}).reinit(known);
    else
      system.product->reinit(known);
    found.reinit(known);
    has_pressure = Utilities::MPI::max(pressures.empty() ? 0 : 1,
                                       known.get_mpi_communicator());
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



  void
  BlockAmgSolver::scale_pressure_rows(Vector &vector) const
  {
    for (const unsigned int i : pressures)
      vector.local_element(i) *= pressure_scale;
  }



  LinearOutcome
  BlockAmgSolver::iterate(const double                 relative_tolerance,
                          const LinearAlgebra::Vector &right_hand_side)
  {
    std::copy(right_hand_side.begin(), right_hand_side.end(), known.begin());
    scale_pressure_rows(known);
    const double         tolerance = relative_tolerance * known.l2_norm();
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
        solver.solve(matrix, found, known, preconditioner);
      }
      else if (!uses_conjugate_gradients())
      {
        SolverFGMRES<Vector> solver(
          control, typename SolverFGMRES<Vector>::AdditionalData(restart));
        solver.solve(matrix, found, known, preconditioner);
      }
      else
      {
        SolverCG<Vector> solver(control);
        solver.solve(matrix, found, known, preconditioner);
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
  BlockAmgSolver::solve(LinearAlgebra::Vector       &solution,
                        const LinearAlgebra::Vector &right_hand_side,
                        const double                 relative_tolerance)
  {
    found = 0.;
    LinearOutcome outcome;
    if (right_hand_side.l2_norm() > 0.)
      outcome = find(right_hand_side, relative_tolerance);
    std::copy(found.begin(), found.end(), solution.begin());
    return outcome;
  }



  LinearOutcome
  BlockAmgSolver::find(const LinearAlgebra::Vector &right_hand_side,
                       const double                 relative_tolerance)
  {
    unsigned int earlier = 0;
    const bool is_tried  = multigrid && is_old && options.tolerated_growth > 0.;
    if (is_tried && n_untried > 0)
      --n_untried;
    else if (is_tried)
    {
      const LinearOutcome outcome =
        iterate(relative_tolerance, right_hand_side);
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
    LinearOutcome outcome = iterate(relative_tolerance, right_hand_side);
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
