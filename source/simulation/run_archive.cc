// SPDX-License-Identifier: GPL-2.0-or-later
// A run and its checkpoints: what is written is all that the next step depends
// on, so that a resumed run continues as if it had not been interrupted: the
// state with its history, the next step of the load control with what it
// remembers, the peak, and h of the first mesh.
// parallel::distributed::Triangulation restores the mesh on any number of ranks
// from the coarse mesh, which is made anew from the .prm.

#include <base/ranges.h>

#include <simulation/run_archive.h>

namespace MixedCracks
{
  template <int dim>
  void
  RunArchive<dim>::read()
  {
    resumed                    = checkpoint.read();
    const std::string fallback = fallback_in_words(checkpoint.found());
    if (has_damage(checkpoint.found()))
      damage = fallback; // logged with the other warnings
    else if (!fallback.empty())
      log.line(fallback);
    mend_case();
  }



  template <int dim>
  void
  RunArchive<dim>::mend_case()
  {
    const std::string mended = require_same_case(
      resumed->signature,
      signature.problem,
      resumed->end == RunEnd::refused ? resumed->why_failed : "");
    if (!mended.empty())
      resumed->changed_loads.push_back(
        format("the loads before t = %.6g s are those of another expression: ",
               resumed->time) +
        mended);
  }



  template <int dim>
  std::vector<std::string>
  RunArchive<dim>::warnings() const
  {
    std::vector<std::string> result;
    if (!damage.empty())
      result.push_back(damage);
    if (resumed)
      append(result, resumed->changed_loads);
    return result;
  }



  template <int dim>
  State
  RunArchive<dim>::load_state()
  {
    State state;
    checkpoint.load_fields(body.fields, body.triangulation, state);
    state.time      = resumed->time;
    state.time_step = resumed->time_step;
    load_control.restore(resumed->time,
                         resumed->next_step,
                         resumed->peak_force,
                         resumed->steps_to_wait);
    return state;
  }



  template <int dim>
  void
  RunArchive<dim>::restore_records(const State &state)
  {
    recorder.restore(*resumed, state);
    if (dim == 3)
      recorder.remember_cracks(crack_observer.trace(state), state);
    log.line(format("resumed at step %u", recorder.last().step()));
  }



  template <int dim>
  RunEnding
  RunArchive<dim>::ending(const State &state)
  {
    return ending_of_resumed_run(
      *resumed,
      signature.attempt,
      body.parameters.load,
      [&]() { return crack_observer.trace(state).separate_body; },
      load_control,
      log);
  }



  template <int dim>
  void
  RunArchive<dim>::write(const State     &state,
                         const RunEnding &ending,
                         const RunTotals &cost)
  {
    PhaseTimer::Scope scope(timer, "output");
    const double      begin = stop.clock();
    RunRecord         record;
    record.signature     = signature.problem;
    record.attempt       = signature.attempt;
    record.end           = ending.end;
    record.why_failed    = ending.why_failed;
    record.cell_size     = body.cell_size;
    record.time          = state.time;
    record.time_step     = state.time_step;
    record.next_step     = load_control.natural_step();
    record.peak_force    = load_control.peak_force();
    record.steps_to_wait = load_control.steps_to_wait();
    record.totals        = cost;
    if (resumed)
      record.changed_loads = resumed->changed_loads;
    recorder.save(record);
    checkpoint.write(record, state, body.fields, body.triangulation);
    stop.note_checkpoint(begin);
  }



  template class RunArchive<2>;
  template class RunArchive<3>;
} // namespace MixedCracks
