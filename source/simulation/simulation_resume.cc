// SPDX-License-Identifier: GPL-2.0-or-later
#include <simulation/simulation.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  void
  Simulation<dim>::mend_resumed_case()
  {
    const std::string mended = require_same_case(
      resumed->signature,
      signature.problem,
      resumed->end == RunEnd::refused ? resumed->why_failed : "");
    if (!mended.empty())
      resumed->changed_loads.push_back(
        printed("the loads before t = %.6g s are those of another expression: ",
                resumed->time) +
        mended);
  }



  template <int dim>
  void
  Simulation<dim>::write_checkpoint(const State &state, const RunTotals &cost)
  {
    TimerOutput::Scope scope(timer, "output");
    const double       begin = stop_poll.now();
    RunRecord          record;
    record.signature           = signature.problem;
    record.attempt             = signature.attempt;
    record.end                 = run_end;
    record.why_failed          = why_failed;
    record.cell_size           = cell_size;
    record.time                = state.time;
    record.time_step           = state.time_step;
    record.next_step           = load_control.natural_step();
    record.peak_force          = load_control.peak_force();
    record.external_work       = external_work;
    record.peak_step           = peak_step;
    record.steps_to_wait       = load_control.steps_to_wait();
    record.n_refinements       = n_refinements;
    record.n_overlapping_steps = n_overlapping_steps;
    record.deepest_overlap     = deepest_overlap;
    record.overlap_in_words    = overlap_in_words;
    if (resumed)
      record.changed_loads = resumed->changed_loads;
    record.totals = cost;
    record.nuclei = state.damage_origins.nuclei;
    record.rows   = statistics.rows();
    // the state of the peak is not kept: what shall be seen of it is written
    if (!field_output.has(peak_step))
      write_fields(peak_state, peak_step);
    record.field_files = field_output.records();
    record.tables      = {{"crack_path.csv", crack_path_writer.rows()},
                          {"crack_opening.csv", crack_opening_file.rows()}};
    checkpoint.write(record, state, fields, triangulation);
    note_checkpoint(begin);
  }



  template <int dim>
  State
  Simulation<dim>::resumed_state()
  {
    State state;
    checkpoint.load_fields(fields, triangulation, state);
    state.time      = resumed->time;
    state.time_step = resumed->time_step;
    load_control.restore(resumed->time,
                         resumed->next_step,
                         resumed->peak_force,
                         resumed->steps_to_wait);
    external_work = resumed->external_work;
    peak_step     = resumed->peak_step;
    peak_state    = state;
    peak_state.reaction.clear();
    prepare_output();
    statistics.restore(resumed->rows);
    n_refinements       = resumed->n_refinements;
    n_overlapping_steps = resumed->n_overlapping_steps;
    deepest_overlap     = resumed->deepest_overlap;
    overlap_in_words    = resumed->overlap_in_words;
    earlier             = resumed->totals;
    state.damage_origins =
      crack_observer.resumed_origins(resumed->nuclei, state.phase_field);
    crack_path_writer.restore(material->description().length_scale,
                              resumed->tables["crack_path.csv"]);
    crack_opening_file.restore(resumed->tables["crack_opening.csv"]);
    field_output.restore(resumed->field_files);
    // a run without fields kept nothing of its peak, and this state is another
    if (peak_step < resumed->rows.back().step)
      field_output.leave_out(peak_step);
    log.line("resumed at step " +
             std::to_string(statistics.rows().back().step));
    return state;
  }



#define INSTANTIATE(dim)                                               \
  template void  Simulation<dim>::mend_resumed_case();                 \
  template void  Simulation<dim>::write_checkpoint(const State &,      \
                                                  const RunTotals &); \
  template State Simulation<dim>::resumed_state();
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
