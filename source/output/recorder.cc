// SPDX-License-Identifier: GPL-2.0-or-later
// An accepted step n, in this order: row (measure), tables, peak, cracks,
// fields. Trials are measured, too, since what is not finite is not accepted;
// nothing is kept of them. With t the thickness (1 in 3-d),
//
//   W_n = W_(n-1) + t ElasticStep::external_work(n-1, n),  W_0 = 0      mJ
//
// is summed up here as steps are accepted, so that a trial that is dropped has
// done no work. Clocks are summed over the pieces of a run: what earlier ones
// took plus the clock of this one.
//
// The fields of the peak, the largest |F| that was carried, are known to be
// those only when the force has fallen, by 2 %: the state is kept until then. A
// checkpoint does not have it, so that save() writes its fields first.

#include <output/mean_stress.h>
#include <output/quantities.h>
#include <output/recorder.h>
#include <output/small_file.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // only such a fall tells that the peak was one
    constexpr double fall_after_peak = 0.98;
  } // namespace



  template <int dim>
  Recorder<dim>::Recorder(const Fields<dim>          &fields,
                          const Constraints<dim>     &constraints,
                          const RecorderOptions<dim> &options)
    : fields(fields)
    , constraints(constraints)
    , options(options)
    , boundary_quantities(fields, constraints, options.force_boundary)
    , crack_path_writer(options.output.directory, fields.communicator())
    , crack_sheet_writer(options.output.directory, fields)
    , event_table(options.output.directory,
                  dim,
                  options.events,
                  fields.communicator())
    , crack_opening(fields, options.crack_opening.lines())
    , crack_opening_file(options.output.directory,
                         crack_opening.lines(),
                         fields.communicator())
    , traction_profiles(options.output.directory,
                        options.tractions,
                        fields.communicator())
    , point_displacements(fields, options.points.points())
    , watched_boundaries(fields,
                         constraints,
                         options.watched,
                         options.thickness,
                         options.finite_strain)
    , point_reactions(constraints, options.held_points)
    , slit_watch(fields)
    , statistics(fields.communicator())
    , field_output(fields,
                   options.output.directory,
                   options.output.field_format)
  {}



  template <int dim>
  std::vector<std::string>
  Recorder<dim>::asked_quantities() const
  {
    std::vector<std::string> asked;
    if (options.crack_opening.crack_volume)
      asked.push_back("Output/Crack volume");
    if (options.finite_strain)
      asked.push_back("Model/Strains = finite");
    if (constraints.periodic().any())
    {
      asked.push_back("Geometry/Periodic sides");
      if (options.finite_strain)
        asked.push_back("Geometry/Periodic sides and Model/Strains = finite");
    }
    return asked;
  }



  template <int dim>
  void
  Recorder<dim>::find_places()
  {
    point_displacements.reinit();
    slit_watch.reinit();
  }



  template <int dim>
  void
  Recorder<dim>::reinit(Assembler<dim> &present, const double length)
  {
    assembler    = &present;
    length_scale = length;
    boundary_quantities.reinit();
    point_displacements.reinit();
    watched_boundaries.reinit();
    if (!crack_opening.lines().empty())
      crack_opening.reinit(options.crack_opening.reach * length_scale);
  }



  template <int dim>
  void
  Recorder<dim>::open_statistics()
  {
    std::vector<std::string> columns = point_reactions.column_names();
    for (const std::string &column : watched_boundaries.column_names())
      columns.push_back(column);
    statistics.open(options.output.directory + "/statistics.csv",
                    dim,
                    asked_quantities(),
                    point_displacements.column_names(),
                    columns);
  }



  template <int dim>
  void
  Recorder<dim>::open_crack_files()
  {
    crack_path_writer.open(length_scale);
    crack_sheet_writer.open(length_scale);
    event_table.open();
    crack_opening_file.open();
    traction_profiles.open();
  }



  template <int dim>
  Tensor<1, dim>
  Recorder<dim>::force(const State &state) const
  {
    return options.thickness * boundary_quantities.force(state.reaction);
  }



  template <int dim>
  StatisticsRow
  Recorder<dim>::measure(const State      &state,
                         const double      work,
                         const StepEffort &effort,
                         const RunTotals  &piece) const
  {
    Measurement<dim> step{fields, state};
    step.thickness    = options.thickness;
    step.step         = static_cast<unsigned int>(statistics.rows().size());
    step.displacement = boundary_quantities.displacement(state.time);
    step.force        = force(state);
    step.energies     = assembler->energies(
      state.elastic, state.lagged_phase_field, state.phase_field);
    step.external_work = external_work + options.thickness * work;
    step.effort        = effort;
    step.totals        = earlier + piece;
    step.totals.wall_time += wall_clock.wall_time();
    step.n_refinements   = n_refinements;
    const auto &periodic = constraints.periodic();
    if (periodic.any())
      step.mean_stress =
        integral_of_stress(fields, *assembler, state) /
        periodic.sides().cell_volume(fields.elastic.get_triangulation());
    StatisticsRow row       = evaluate_quantities(step, asked_quantities());
    row.point_displacements = point_displacements.evaluate(state.elastic);
    row.reactions           = point_reactions.evaluate(fields, state.reaction);
    for (double &reaction : row.reactions)
      reaction *= options.thickness;
    for (const double value : watched_boundaries.evaluate(state))
      row.reactions.push_back(value);
    return row;
  }



  template <int dim>
  void
  Recorder<dim>::record_opening(const StatisticsRow &row, const State &state)
  {
    if (!crack_opening.lines().empty())
      crack_opening_file.add(
        row.step(),
        row["time"],
        crack_opening.evaluate(state.elastic, state.phase_field));
  }



  template <int dim>
  void
  Recorder<dim>::add(const StatisticsRow &row, const State &state)
  {
    external_work = row["external_work"];
    record_opening(row, state);
    traction_profiles.add(row.step(), state, *assembler);
    statistics.add(row);
  }



  template <int dim>
  void
  Recorder<dim>::keep_peak(const State &state)
  {
    if (last().force_size() <= peak_force)
      return;
    peak_force = last().force_size();
    peak_step  = last().step();
    peak       = state;
    peak.reaction.clear(); // which is of no use on another mesh
  }



  template <int dim>
  std::vector<std::string>
  Recorder<dim>::add_cracks(const TracedCracks &cracks, const State &state)
  {
    crack_path_writer.add(
      last().step(), last()["time"], last()["displacement"], cracks.paths);
    crack_sheet_writer.add(last().step(),
                           last()["time"],
                           last()["displacement"],
                           cracks.sheets,
                           state.elastic);
    return event_table.add(last(), cracks, state.damage_origins);
  }



  template <int dim>
  void
  Recorder<dim>::write_fields(const State &state, const unsigned int step)
  {
    if (!field_output.is_on())
      return; // stresses of all cells would be evaluated for nothing
    field_output.write(
      state,
      step,
      assembler
        ->cell_data(state.elastic, state.lagged_phase_field, state.phase_field)
        .values);
  }



  template <int dim>
  void
  Recorder<dim>::write_fields_when_due(const State &state, const bool ends)
  {
    const unsigned int every = options.output.fields_every;
    const bool past_peak = last().force_size() < fall_after_peak * peak_force;
    if (past_peak && !field_output.has(peak_step))
      write_fields(peak, peak_step);
    const unsigned int step = last().step();
    if (step == 0 || ends || (every > 0 && step % every == 0) ||
        event_table.is_of_event(step))
      write_fields(state, step);
  }



  template <int dim>
  void
  Recorder<dim>::write_last_fields(const State &state)
  {
    if (!field_output.has(peak_step))
      write_fields(peak, peak_step);
    if (!field_output.has(last().step()))
      write_fields(state, last().step());
  }



  template <int dim>
  void
  Recorder<dim>::save(RunRecord &record)
  {
    slit_watch.save(record);
    record.external_work = external_work;
    record.peak_step     = peak_step;
    record.n_refinements = n_refinements;
    record.rows          = statistics.rows();
    // the state of the peak is not kept: what shall be seen of it is written
    if (!field_output.has(peak_step))
      write_fields(peak, peak_step);
    record.field_files = field_output.records();
    record.tables      = {{"crack_path.csv", crack_path_writer.rows()},
                          {"crack_opening.csv", crack_opening_file.rows()}};
    if (dim == 3)
    {
      record.tables["crack_sheet.csv"] = crack_sheet_writer.sheet_rows();
      record.tables["crack_front.csv"] = crack_sheet_writer.front_rows();
    }
    if (!event_table.rows().empty())
      record.tables["events.csv"] = event_table.rows();
    if (!traction_profiles.rows().empty())
      record.tables["traction_profiles.csv"] = traction_profiles.rows();
  }



  template <int dim>
  void
  Recorder<dim>::restore(const RunRecord &record, const State &state)
  {
    const auto table = [&record](const std::string &name) {
      const auto found = record.tables.find(name);
      return found == record.tables.end() ? "" : found->second;
    };
    external_work = record.external_work;
    peak_force    = record.peak_force;
    peak_step     = record.peak_step;
    peak          = state;
    peak.reaction.clear();
    n_refinements = record.n_refinements;
    earlier       = record.totals;
    statistics.restore(record.rows);
    slit_watch.restore(record);
    crack_path_writer.restore(length_scale, table("crack_path.csv"));
    crack_sheet_writer.restore(
      length_scale, table("crack_sheet.csv"), table("crack_front.csv"));
    crack_opening_file.restore(table("crack_opening.csv"));
    event_table.restore(table("events.csv"));
    traction_profiles.restore(table("traction_profiles.csv"));
    field_output.restore(record.field_files);
    // a run without fields kept nothing of its peak, and this state is another
    if (peak_step < record.rows.back().step())
      field_output.leave_out(peak_step);
  }



  template <int dim>
  RunTotals
  Recorder<dim>::totals(const RunTotals &piece, const PhaseTimer &timer) const
  {
    RunTotals now = piece;
    now.wall_time = wall_clock.wall_time();
    now.phases    = timer.seconds();
    return earlier + now;
  }



  template <int dim>
  void
  Recorder<dim>::finish(const Summary &summary)
  {
    crack_path_writer.finish(summary.cracks);
    crack_sheet_writer.finish(summary.cracks);
    on_first_rank(fields.communicator(), [&]() {
      write_summary(options.output.directory + "/summary.json",
                    summary,
                    statistics.rows(),
                    event_table.rows());
    });
  }



  template class Recorder<2>;
  template class Recorder<3>;
} // namespace MixedCracks
