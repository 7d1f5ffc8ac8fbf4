// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_load_step_h
#define mixed_cracks_simulation_load_step_h

#include <simulation/body.h>
#include <simulation/phase_field_points.h>

#include <steps/step.h>

namespace MixedCracks
{
  /// One load step of the case: the solvers of the coupled step with the loads,
  /// the fluid and the given phase field of the .prm.
  template <int dim>
  class LoadStep
  {
  public:
    using Callbacks = typename StepSolver<dim>::Callbacks;

    LoadStep(const Body<dim> &body,
             const StopCheck &stop,
             const Callbacks &callbacks,
             PhaseTimer      &timer,
             Log             &log);

    /// To be called when the mesh changed. Throws SolverError when the matrix
    /// cannot be analysed.
    void reinit();

    /// See StepSolver::solve().
    StepOutcome solve(const State       &accepted,
                      double             bound,
                      const StepOutcome &so_far,
                      State             &trial);

    /// What this piece of the run has cost so far; without times.
    RunTotals totals(unsigned int n_rejected) const;

    /// Whether more than the residual stiffness carries the dead loads.
    /// @p stored_energy: of the state, mJ. Collective.
    bool loads_are_carried(const State &state, double stored_energy);

    Assembler<dim>   assembler;
    ElasticStep<dim> elastic;

  private:
    LoadStep(const Body<dim>                     &body,
             const StopCheck                     &stop,
             const Callbacks                     &callbacks,
             PhaseTimer                          &timer,
             Log                                 &log,
             std::shared_ptr<FluidAssembler<dim>> fluid);

    /// Of the elastic energy, what is stored in broken cells.
    double broken_part_of_energy(const State &state);

    const Body<dim>    &body;
    PhaseFieldStep<dim> phase_field;
    StepSolver<dim>     solver;
    FixedPhaseField     fixed;

    PhaseFieldPoints<dim> phase_field_points;
  };
} // namespace MixedCracks

#endif
