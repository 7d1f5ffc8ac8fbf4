// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/collective.h>
#include <base/errors.h>

#include <simulation/case_checks.h>
#include <simulation/case_summary.h>
#include <simulation/damage_warning.h>
#include <simulation/recording.h>
#include <simulation/simulation.h>
#include <simulation/simulation_setup.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  Simulation<dim>::Simulation(const Parameters<dim> &parameters,
                              const std::string     &effective_parameters,
                              const CaseSignature   &signature,
                              const MPI_Comm         communicator,
                              Log                   &log)
    : parameters(parameters)
    , log(log)
    , timer(communicator)
    , stop(communicator, parameters.output.wall_time_limit, log)
    , body(parameters, communicator)
    , adaptation(body)
    , crack_observer(body.fields, parameters.geometry.chosen().names_of_ids())
    , load_control(parameters.load)
    , before_the_run(body, log)
    , directory(parameters.output, effective_parameters, communicator, log)
    , recorder(body.fields, body.constraints, recorder_options(parameters))
    , run_log(log, run_log_options(parameters))
    , archive(signature,
              body,
              crack_observer,
              load_control,
              recorder,
              stop,
              timer,
              log)
  {}



  template <int dim>
  void
  Simulation<dim>::preflight(const bool only_check)
  {
    {
      PhaseTimer::Scope scope(timer, "setup");
      if (archive.is_resumed())
        archive.restore_body();
      else if (only_check)
        body.make_to_check();
      else
        body.make();
      recorder.find_places();
    }
    run_log.judge_energies_by(imbalance_rule(body));
    // a run that is resumed has had its start
    if (!archive.is_resumed())
      try_expressions_at_start(body, only_check);
    before_the_run.report(recorder.slits().slits(), archive.warnings());
    if (only_check)
      before_the_run.report_not_checked();
  }



  template <int dim>
  RunOutcome
  Simulation<dim>::run(const ExistingRun existing)
  {
    if (existing == ExistingRun::resume)
      archive.read();
    if (directory.inspect(existing, files_of_run(parameters)))
      open_output();
    preflight();
    stop.leave_early_if_asked("making the mesh", archive.is_resumed());
    State accepted = first_state();
    stop.begin(archive.is_resumed());
    if (archive.is_resumed())
      ending = archive.ending(accepted);
    advance_to_the_end(accepted);
    return finish(accepted,
                  ending.outcome(recorder.rows(), stop.end_in_words()));
  }



  template <int dim>
  State
  Simulation<dim>::first_state()
  {
    const bool is_new = !archive.is_resumed();
    try
    {
      if (is_new)
        adaptation.refine_first_mesh([this]() {
          stop.leave_early_if_asked("refinement of the first mesh", false);
        });
      trial_step = std::make_unique<TrialStep<dim>>(body,
                                                    adaptation,
                                                    crack_observer,
                                                    recorder,
                                                    load_control,
                                                    stop,
                                                    run_log,
                                                    timer,
                                                    log);
      trial_step->reinit();
      if (is_new)
        return initial_state();
      State state = archive.load_state();
      open_output();
      archive.restore_records(state);
      return state;
    }
    catch (const SolverError &)
    {
      // the input was good; what could not be calculated has a log
      if (is_new)
        open_output();
      throw;
    }
  }



  // Around slits and initial cracks the phase field takes its profile before
  // any load: this is no damage of the first step.
  template <int dim>
  State
  Simulation<dim>::initial_state()
  {
    State start = undeformed_state(parameters, body.fields, body.constraints);
    stop.leave_early_if_asked("analysis of the matrix", false);
    TriedStep tried = trial_step->relax(start);
    if (tried.outcome.interrupted)
      stop.leave_early_if_asked("step 0", false);
    State &relaxed         = tried.state;
    relaxed.damage_origins = crack_observer.first_origins(relaxed.phase_field);
    open_output();
    recorder.open_crack_files();
    record(tried.row, relaxed);
    return relaxed;
  }



  template <int dim>
  void
  Simulation<dim>::advance_to_the_end(State &accepted)
  {
    // what has been calculated is to be kept whatever comes of it now
    const auto keep = [&](const int status, const std::string &reason) {
      try
      {
        finish(accepted, {status, reason});
      }
      catch (const FileError &problem)
      {
        log.line(problem.what());
      }
    };
    try
    {
      while (!ending.is_over())
        advance(accepted);
    }
    catch (const InputError &error)
    {
      ending.is(RunEnd::refused, error.what());
      keep(2, error.what());
      throw InputError(error.what() + way_to_mend(error.what(), accepted.time));
    }
    catch (const SolverError &error)
    {
      keep(3, error.what());
      throw;
    }
  }



  template <int dim>
  void
  Simulation<dim>::advance(State &accepted)
  {
    if (load_control.at_end())
      return ending.is(RunEnd::end_time);
    if (stop.before_a_step())
      return ending.is(stop.how_stopped());
    const TriedStep tried = trial_step->attempt(accepted);
    if (tried.outcome.interrupted)
      return ending.is(stop.how_stopped());
    switch (load_control.judge(tried.outcome.solved, tried.change()))
    {
      case LoadControl::Verdict::accept:
        record(tried.row, tried.state);
        accepted = tried.state;
        break;
      case LoadControl::Verdict::repeat:
        log.line("  rejected: " + tried.why_rejected());
        break;
      case LoadControl::Verdict::onset:
        log.line("  onset: " + tried.why_rejected());
        ending.is(RunEnd::onset);
        break;
      case LoadControl::Verdict::give_up:
        log.line("  failed at the smallest step: " + tried.outcome.reason);
        ending.is(RunEnd::failed,
                  ": " + tried.outcome.reason +
                    hint_at_no_stiffness(body.material->description()));
        break;
    }
  }



  template <int dim>
  void
  Simulation<dim>::record(const StatisticsRow &row, const State &state)
  {
    {
      PhaseTimer::Scope scope(timer, "output"); // a checkpoint has its own
      recorder.add(row, state);
      run_log.step(recorder.rows());
      if (const std::string line = recorder.watch_slits(state); !line.empty())
        log.line(line);
      throw_on_all_ranks(log.failure(), body.communicator());
      const bool is_carried =
        trial_step->solvers.loads_are_carried(state, row["elastic_energy"]);
      if (is_carried)
        recorder.keep_peak(state);
      const TracedCracks cracks = crack_observer.trace(state);
      for (const std::string &event : recorder.add_cracks(cracks, state))
        log.line(event);
      ending.is(end_after_step(row.force_size(),
                               cracks.separate_body,
                               is_carried,
                               parameters.load,
                               load_control));
      run_log.damage(damage_warning(body, recorder.rows(), ending.end));
      recorder.write_fields_when_due(state, ending.is_over());
    }
    const unsigned int every = parameters.output.checkpoint_every;
    // the end writes one of its own
    if (every > 0 && row.step() > 0 && row.step() % every == 0 &&
        !ending.is_over() && !load_control.at_end())
      archive.write(state, ending, trial_step->totals());
  }



  template <int dim>
  RunOutcome
  Simulation<dim>::finish(const State &last, const RunOutcome &outcome)
  {
    // where nothing was left to do, it has cost nothing more
    const RunTotals cost =
      ending.had_ended ? recorder.earlier_totals() : trial_step->totals();
    // an error may have come between a new mesh and all that belongs to it
    const bool is_usable = last.reaction.size() == body.fields.elastic.n_dofs();
    const bool to_be_kept = is_usable && !ending.had_ended;
    // who asked a run to stop may not wait for long
    const bool in_a_hurry = ending.end == RunEnd::stopped;
    if (to_be_kept && in_a_hurry)
      archive.write(last, ending, cost);
    if (is_usable)
      recorder.write_last_fields(last);
    if (to_be_kept && !in_a_hurry)
      archive.write(last, ending, cost);
    const Summary summary =
      summarize(body,
                before_the_run,
                recorder,
                {outcome,
                 ending.end,
                 cost,
                 crack_observer.trace(last).outcome,
                 load_control.fallen_force(),
                 trial_step->solvers.elastic.linear_solver().description(),
                 timer.memory(),
                 timer.peak_memory()});
    recorder.finish(summary);
    run_log.end(outcome.reason, summary, recorder.rows());
    throw_on_all_ranks(log.failure(), body.communicator());
    return outcome;
  }



  template class Simulation<2>;
  template class Simulation<3>;
} // namespace MixedCracks
