// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/simulation.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  void
  Simulation<dim>::write_checkpoint(const State &state)
  {
    TimerOutput::Scope scope(timer, "output");
    const double       begin = stop_poll.now();
    RunRecord          record;
    record.signature     = signature;
    record.cell_size     = cell_size;
    record.time          = state.time;
    record.time_step     = state.time_step;
    record.next_step     = load_control.step();
    record.peak_force    = load_control.peak_force();
    record.external_work = external_work;
    record.peak_step     = peak_step;
    record.steps_to_wait = load_control.steps_to_wait();
    record.nuclei        = crack_observer.origins().nuclei();
    record.rows          = statistics.rows();
    // the state of the peak is not kept: what shall be seen of it is written
    if (!field_output.has(peak_step))
      write_fields(peak_state, peak_step);
    record.field_files = field_output.records();
    checkpoint.write(record, state, fields, triangulation);
    note_checkpoint(begin);
  }



  template <int dim>
  State
  Simulation<dim>::resumed_state()
  {
    State state;
    checkpoint.load_fields(fields, state);
    state.time      = resumed->time;
    state.time_step = resumed->time_step;
    load_control.restore(resumed->time,
                         resumed->next_step,
                         resumed->peak_force,
                         resumed->steps_to_wait);
    external_work = resumed->external_work;
    peak_step     = resumed->peak_step;
    peak_state    = state;
    statistics.restore(resumed->rows);
    n_refinements = resumed->rows.back().refinements;
    crack_observer.resume(material->description().length_scale,
                          resumed->rows.back().step,
                          resumed->nuclei,
                          state.phase_field);
    crack_opening_file.restore(resumed->rows.back().step);
    field_output.restore(resumed->field_files);
    // a run without fields kept nothing of its peak, and this state is another
    if (peak_step < resumed->rows.back().step)
      field_output.leave_out(peak_step);
    log.line("resumed at step " +
             std::to_string(statistics.rows().back().step));
    return state;
  }



#define INSTANTIATE(dim)                                           \
  template void  Simulation<dim>::write_checkpoint(const State &); \
  template State Simulation<dim>::resumed_state();
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
