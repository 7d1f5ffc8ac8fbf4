// SPDX-License-Identifier: GPL-2.0-or-later
// One load step, tried from the accepted state:
//
//   trial = accepted, t = t + dt
//   repeat  solve (u, p, phi) (steps/step.cc)
//           refine where phi asks for it, carry accepted and trial over
//   until   the mesh is fine enough
//   measure; phi^(n-1) of the trial = phi of the accepted state
//
// The accepted state is not touched but for being carried to the new mesh: a
// trial may be thrown away. LoadControl judges it. Step 0, relax(), has no
// bound for the change of phi: its profile around initial cracks is no damage
// of a load step.

#include <base/errors.h>

#include <output/finite_check.h>

#include <simulation/case_checks.h>
#include <simulation/trial_step.h>

#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    StepEffort
    effort_of(const StepOutcome &outcome)
    {
      StepEffort effort;
      effort.phase_field_change  = outcome.phase_field_change;
      effort.coupling_change     = outcome.coupling_change;
      effort.newton_iterations   = outcome.newton_iterations;
      effort.linear_iterations   = outcome.linear_iterations;
      effort.coupling_iterations = outcome.coupling_iterations;
      effort.active_set_size     = outcome.active_set_size;
      return effort;
    }



    // From a crack to where the optimal profile is 0.5, in l, by bisection.
    double
    distance_of_half(const CrackDensity &density)
    {
      double inside = 0., outside = 2.;
      for (unsigned int i = 0; i < 40; ++i)
      {
        const double middle = 0.5 * (inside + outside);
        (density.optimal_profile(middle) < 0.5 ? inside : outside) = middle;
      }
      return inside;
    }
  } // namespace



  double
  TriedStep::change() const
  {
    return outcome.runs_away ? infinity : outcome.phase_field_change;
  }



  std::string
  TriedStep::why_rejected() const
  {
    if (!outcome.solved)
      return outcome.reason;
    return format(outcome.runs_away
                    ? "the phase field runs away, by %.3g so far"
                    : "the phase field changed by %.3g",
                  outcome.phase_field_change);
  }



  template <int dim>
  typename TrialStep<dim>::Callbacks
  TrialStep<dim>::callbacks(const MeshAdaptation<dim> &adaptation,
                            const CrackObserver<dim>  &crack_observer,
                            const Recorder<dim>       &recorder,
                            const LoadControl         &load_control,
                            RunStop                   &stop)
  {
    return {[&stop]() { return stop.now("coupling iteration"); },
            [&crack_observer](State &trial) { crack_observer.watch(trial); },
            [&adaptation](const State &trial) {
              return adaptation.needs_finer_mesh(trial);
            },
            [&recorder, &load_control](const State &state) {
              const double limit = load_control.force_when_apart();
              return limit > 0. ? recorder.force(state).norm() / limit
                                : infinity;
            },
            [&crack_observer](const State &trial) {
              return crack_observer.trace(trial).separate_body;
            }};
  }



  template <int dim>
  TrialStep<dim>::TrialStep(Body<dim>           &body,
                            MeshAdaptation<dim> &adaptation,
                            CrackObserver<dim>  &crack_observer,
                            Recorder<dim>       &recorder,
                            const LoadControl   &load_control,
                            RunStop             &stop,
                            RunLog              &run_log,
                            PhaseTimer          &timer,
                            Log                 &log)
    : solvers(
        body,
        [&stop](const std::string &finished) { return stop.now(finished); },
        callbacks(adaptation, crack_observer, recorder, load_control, stop),
        timer,
        log)
    , body(body)
    , adaptation(adaptation)
    , crack_observer(crack_observer)
    , recorder(recorder)
    , load_control(load_control)
    , stop(stop)
    , run_log(run_log)
    , timer(timer)
    , log(log)
  {
    recorder.take_loads_from(
      [this](const types::boundary_id boundary, const State &state) {
        return solvers.elastic.loads_on_boundary(boundary, state);
      });
  }



  template <int dim>
  void
  TrialStep<dim>::reinit()
  {
    solvers.reinit();
    run_log.linear_solver(solvers.elastic.linear_solver_in_words());
    crack_observer.reinit(body.length_scale(),
                          distance_of_half(body.material->crack_density()));
    recorder.reinit(solvers.assembler, body.length_scale());
  }



  template <int dim>
  void
  TrialStep<dim>::refine(State &accepted, State &trial)
  {
    {
      PhaseTimer::Scope scope(timer, "refinement");
      adaptation.refine(trial, {&accepted, &trial, &recorder.peak_state()});
    }
    recorder.note_refinement();
    reinit();
    solvers.elastic.update_reaction(accepted);
    log.line(format("  refined: %llu cells, %llu dofs",
                    static_cast<unsigned long long>(
                      body.triangulation.n_global_active_cells()),
                    static_cast<unsigned long long>(body.fields.n_dofs())));
  }



  template <int dim>
  StepOutcome
  TrialStep<dim>::solve(State &accepted, State &trial, const double bound)
  {
    StepOutcome outcome;
    while (true)
    {
      outcome = solvers.solve(accepted, bound, outcome, trial);
      if (!outcome.mesh_is_too_coarse)
        return outcome;
      outcome.interrupted = stop.now("coupling iteration");
      if (outcome.interrupted)
        return outcome;
      refine(accepted, trial);
    }
  }



  template <int dim>
  StatisticsRow
  TrialStep<dim>::measure(const State       &before,
                          const State       &state,
                          const StepOutcome &outcome)
  {
    PhaseTimer::Scope scope(timer, "output");
    return recorder.measure(state,
                            solvers.elastic.external_work(before, state),
                            effort_of(outcome),
                            solvers.totals(load_control.n_rejected()));
  }



  template <int dim>
  TriedStep
  TrialStep<dim>::attempt(State &accepted)
  {
    const double bound = load_control.phase_field_bound();
    TriedStep    tried;
    State       &trial   = tried.state;
    StepOutcome &outcome = tried.outcome;
    trial                = accepted;
    trial.time           = load_control.target_time();
    trial.time_step      = load_control.step();
    log.line("");
    log.line(format("step %zu: t = %.6g s, dt = %.4g s",
                    recorder.rows().size(),
                    trial.time,
                    trial.time_step));
    outcome = solve(accepted, trial, bound);
    if (outcome.interrupted || !outcome.solved ||
        !(outcome.phase_field_change <= bound))
      return tried;
    tried.row                  = measure(accepted, trial, outcome);
    outcome.reason             = not_finite(body.fields, trial, tried.row);
    outcome.solved             = outcome.reason.empty();
    trial.previous_phase_field = accepted.phase_field;
    return tried;
  }



  template <int dim>
  TriedStep
  TrialStep<dim>::relax(State &start)
  {
    const std::string failure = "the initial state cannot be computed: ";
    log.line("");
    log.line("step 0: profile of the initial cracks");
    TriedStep tried;
    State    &relaxed = tried.state;
    relaxed           = start;
    tried.outcome     = solve(start, relaxed, infinity);
    if (tried.outcome.interrupted)
      return tried;
    if (!tried.outcome.solved)
      throw SolverError(failure + tried.outcome.reason +
                        hint_at_no_stiffness(body.material->description()));
    relaxed.previous_phase_field = relaxed.phase_field;
    tried.row                    = measure(relaxed, relaxed, tried.outcome);
    const std::string fault      = not_finite(body.fields, relaxed, tried.row);
    if (!fault.empty())
      throw SolverError(failure + fault);
    return tried;
  }



  template <int dim>
  RunTotals
  TrialStep<dim>::totals() const
  {
    return recorder.totals(solvers.totals(load_control.n_rejected()), timer);
  }



  template class TrialStep<2>;
  template class TrialStep<3>;
} // namespace MixedCracks
