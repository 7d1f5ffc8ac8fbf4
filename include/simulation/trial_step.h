// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_trial_step_h
#define mixed_cracks_simulation_trial_step_h

#include <output/recorder.h>
#include <output/run_log.h>

#include <simulation/load_step.h>
#include <simulation/mesh_adaptation.h>
#include <simulation/run_stop.h>

#include <steps/load_control.h>

namespace MixedCracks
{
  /// What trying a load step came to.
  struct TriedStep
  {
    State         state;
    StepOutcome   outcome;
    StatisticsRow row; ///< where the outcome is within the bound

    /// For LoadControl; infinite where the phase field runs away.
    double change() const;

    std::string why_rejected() const;
  };

  /// Tries load steps: predicts, refines where the prediction damages coarse
  /// cells, and corrects; then looks at what came of it. Nothing of a step is
  /// kept here.
  template <int dim>
  class TrialStep
  {
  public:
    TrialStep(Body<dim>           &body,
              MeshAdaptation<dim> &adaptation,
              CrackObserver<dim>  &crack_observer,
              Recorder<dim>       &recorder,
              const LoadControl   &load_control,
              RunStop             &stop,
              RunLog              &run_log,
              PhaseTimer          &timer,
              Log                 &log);

    /// Everything that depends on the mesh, after it changed.
    void reinit();

    /// Try the step that load control has set, from @p accepted, which is on
    /// another mesh afterwards where that was refined.
    TriedStep attempt(State &accepted);

    /// The state at the start, in equilibrium. Throws SolverError when there is
    /// none.
    TriedStep relax(State &start);

    /// What the run has cost, with the pieces before this one. Collective.
    RunTotals totals() const;

    LoadStep<dim> solvers;

  private:
    using Callbacks = typename LoadStep<dim>::Callbacks;

    static Callbacks callbacks(const MeshAdaptation<dim> &adaptation,
                               const CrackObserver<dim>  &crack_observer,
                               const Recorder<dim>       &recorder,
                               const LoadControl         &load_control,
                               RunStop                   &stop);

    StepOutcome solve(State &accepted, State &trial, double bound);

    void refine(State &accepted, State &trial);

    StatisticsRow measure(const State       &before,
                          const State       &state,
                          const StepOutcome &outcome);

    Body<dim>           &body;
    MeshAdaptation<dim> &adaptation;
    CrackObserver<dim>  &crack_observer;
    Recorder<dim>       &recorder;
    const LoadControl   &load_control;
    RunStop             &stop;
    RunLog              &run_log;
    PhaseTimer          &timer;
    Log                 &log;
  };
} // namespace MixedCracks

#endif
