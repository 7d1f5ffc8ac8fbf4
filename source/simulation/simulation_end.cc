// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/collective.h>

#include <simulation/simulation.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  RunEnd
  Simulation<dim>::end_of_resumed_run(const State &state)
  {
    const double force_now = statistics.rows().back().force_size();
    const bool is_again = is_same_attempt(resumed->attempt, signature.attempt);
    const auto has_joined = [&]() {
      return resumed->end == RunEnd::separated ||
             crack_observer.trace(state).separate_body;
    };
    RunEnd end = RunEnd::none;
    // no parameter that may change would mend it
    if (resumed->end == RunEnd::no_equilibrium)
      end = RunEnd::no_equilibrium;
    else if (parameters.load.stop_when_separated && has_joined())
      end = RunEnd::separated;
    else if (load_control.has_fallen(force_now))
      end = RunEnd::force_fell;
    else if (load_control.at_end())
      end = RunEnd::end_time;
    // the same step would come to the same
    else if (resumed->end == RunEnd::failed && is_again)
    {
      end        = RunEnd::failed;
      why_failed = resumed->why_failed;
    }
    else if (resumed->end == RunEnd::onset && is_again)
      end = RunEnd::onset;

    log.line(end != RunEnd::none ? "nothing is left to do: " + in_words(end)
             : resumed->end == RunEnd::none || resumed->end == RunEnd::stopped
               ? "the run goes on"
               : "the run had ended (" + in_words(resumed->end) +
                   ") and goes on with the parameters of now");
    if (end == RunEnd::failed || end == RunEnd::onset)
      log.line("the same step is tried again once an entry on load steps, the "
               "linear solver or the coupling has changed");
    return end;
  }



  template <int dim>
  void
  Simulation<dim>::advance_to_the_end(State &accepted)
  {
    RunOutcome error;
    try
    {
      while (run_end == RunEnd::none)
        run_end = load_control.at_end() ? RunEnd::end_time : advance(accepted);
      return;
    }
    catch (const InputError &what)
    {
      error      = {2, what.what()};
      run_end    = RunEnd::refused;
      why_failed = what.what();
    }
    catch (const SolverError &what)
    {
      error = {3, what.what()};
    }
    // what has been calculated is to be kept whatever comes of it now
    try
    {
      finish(accepted, error);
    }
    catch (const FileError &problem)
    {
      log.line(problem.what());
    }
    if (error.exit_status == 2)
      throw InputError(
        error.reason +
        (can_be_mended(error.reason)
           ? printed(" The last accepted state, t = %.6g s, is kept: --resume "
                     "goes on from it with another expression in this entry.",
                     accepted.time)
           : std::string()));
    throw SolverError(error.reason);
  }



  template <int dim>
  RunTotals
  Simulation<dim>::totals()
  {
    RunTotals now;
    now.factorizations = elastic_step->counts().factorizations;
    now.solves         = elastic_step->counts().solves;
    now.rejected_steps = load_control.n_rejected();
    now.wall_time      = wall_clock.wall_time();
    for (const auto &[name, seconds] :
         timer.get_summary_data(TimerOutput::total_wall_time))
      now.phases[name] = Utilities::MPI::max(seconds, communicator);
    return earlier + now;
  }



  template <int dim>
  RunOutcome
  Simulation<dim>::finish(const State &last, const RunOutcome &outcome)
  {
    const unsigned int last_step = statistics.rows().back().step;
    // where nothing was left to do, it has cost nothing more
    const RunTotals cost = had_ended ? earlier : totals();
    // an error may have come between a new mesh and all that belongs to it
    const bool is_usable  = last.reaction.size() == fields.elastic.n_dofs();
    const bool to_be_kept = is_usable && !had_ended;
    // who asked a run to stop may not wait for long
    const bool in_a_hurry = run_end == RunEnd::stopped;
    if (to_be_kept && in_a_hurry)
      write_checkpoint(last, cost);
    if (is_usable && !field_output.has(peak_step))
      write_fields(peak_state, peak_step);
    if (is_usable && !field_output.has(last_step))
      write_fields(last, last_step);
    if (to_be_kept && !in_a_hurry)
      write_checkpoint(last, cost);
    Summary summary = summarize(outcome, cost);
    summary.cracks  = crack_observer.trace(last).outcome;
    crack_path_writer.finish(summary.cracks);
    if (dim == 2)
      summary.separated = separates(summary.cracks);
    std::string message;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      message = write_summary(parameters.output.directory + "/summary.json",
                              summary,
                              statistics.rows());
    throw_on_all_ranks(message, communicator);
    log_end(outcome, summary);
    throw_on_all_ranks(log.failure(), communicator);
    return outcome;
  }



#define INSTANTIATE(dim)                                                  \
  template RunEnd     Simulation<dim>::end_of_resumed_run(const State &); \
  template void       Simulation<dim>::advance_to_the_end(State &);       \
  template RunTotals  Simulation<dim>::totals();                          \
  template RunOutcome Simulation<dim>::finish(const State &,              \
                                              const RunOutcome &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
