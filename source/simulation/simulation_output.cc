// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/collective.h>
#include <base/version.h>

#include <simulation/simulation.h>

#include <fstream>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // bytes: the header of statistics.csv, points of the user's own included
    constexpr std::uint64_t room_for_first_rows = 4096;

    // Relative to the output directory, folders with '/' behind; files that
    // have a number in their names are recorded when they are written.
    template <int dim>
    std::vector<std::string>
    files_to_be_written(const Parameters<dim> &parameters)
    {
      const std::string        format = parameters.output.field_format;
      std::vector<std::string> names  = {"log.txt",
                                         "statistics.csv",
                                         "parameters.prm",
                                         "summary.json",
                                         "summary.json.part",
                                         "checkpoint/",
                                         "checkpoint/generation-0/",
                                         "checkpoint/generation-1/"};
      const auto               add = [&names](const bool                      is_written,
                                const std::vector<std::string> &more) {
        if (is_written)
          names.insert(names.end(), more.begin(), more.end());
      };
      add(dim == 2, {"crack_path.csv", "crack_path.pvd", "crack_path/"});
      add(!parameters.crack_opening.lines().empty(), {"crack_opening.csv"});
      add(parameters.output.with_fields(), {"fields/"});
      add(format == "VTU" || format == "both",
          {"fields.pvd", "fields.pvd.part"});
      add(format == "XDMF" || format == "both",
          {"fields.xdmf", "fields.xdmf.part"});
      add(dim == 3 && parameters.output.with_fields(), {"crack_surface.pvd"});
      return names;
    }
  } // namespace



  template <int dim>
  void
  Simulation<dim>::inspect_output(const ExistingRun existing)
  {
    waiting_output = existing;
    if (inspect_output_directory(parameters.output.directory,
                                 existing,
                                 files_to_be_written(parameters),
                                 communicator))
      prepare_output();
  }



  template <int dim>
  void
  Simulation<dim>::prepare_output()
  {
    if (!waiting_output)
      return;
    const ExistingRun  existing  = *waiting_output;
    const std::string &directory = parameters.output.directory;
    waiting_output.reset();
    prepare_output_directory(directory,
                             existing,
                             files_to_be_written(parameters),
                             {{"parameters.prm", effective_parameters.size()},
                              {"log.txt", log.size_until_open()},
                              {"statistics.csv", room_for_first_rows}},
                             communicator);
    log.open(directory + "/log.txt", existing == ExistingRun::resume);
    throw_on_all_ranks(log.failure(), communicator);
    statistics.open(directory + "/statistics.csv",
                    dim,
                    parameters.crack_opening.crack_volume,
                    point_displacements.column_names());
    std::string message;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      std::ofstream file(directory + "/parameters.prm");
      file << effective_parameters << std::flush;
      if (!file)
        message = "Output/Directory: '" + directory +
                  "/parameters.prm' cannot be written.";
    }
    throw_on_all_ranks(message, communicator);
  }



  template <int dim>
  StatisticsRow
  Simulation<dim>::measure(const State       &before,
                           const State       &state,
                           const StepOutcome &outcome)
  {
    TimerOutput::Scope scope(timer, "output");
    const double       thickness = parameters.thickness_factor();
    StatisticsRow      row;
    row.step         = static_cast<unsigned int>(statistics.rows().size());
    row.time         = state.time;
    row.displacement = boundary_quantities.displacement(state.time);
    const Tensor<1, dim> force_now = force(state);
    for (unsigned int d = 0; d < dim; ++d)
      row.force[d] = force_now[d];
    const Energies energies = assembler->energies(
      state.elastic, state.lagged_phase_field, state.phase_field);
    row.elastic_energy = thickness * energies.elastic;
    row.crack_energy   = thickness * energies.crack;
    row.crack_surface  = energies.crack_surface;
    row.external_work =
      external_work + thickness * elastic_step->external_work(before, state);
    row.min_phase_field     = smallest_phase_field(state);
    row.phase_field_change  = outcome.phase_field_change;
    row.newton_iterations   = outcome.newton_iterations;
    row.linear_iterations   = outcome.linear_iterations;
    row.active_set_size     = outcome.active_set_size;
    row.cells               = triangulation.n_global_active_cells();
    row.dofs                = fields.n_dofs();
    row.wall_time           = earlier.wall_time + wall_clock.wall_time();
    row.coupling_iterations = outcome.coupling_iterations;
    row.coupling_change     = outcome.coupling_change;
    row.factorizations =
      earlier.factorizations + elastic_step->counts().factorizations;
    row.rejected_steps = earlier.rejected_steps + load_control.n_rejected();
    row.refinements    = n_refinements;
    if (parameters.crack_opening.crack_volume)
      row.crack_volume =
        thickness * crack_volume(fields, state.elastic, state.phase_field);
    row.point_displacements = point_displacements.evaluate(state.elastic);
    return row;
  }



  template <int dim>
  void
  Simulation<dim>::record(const StatisticsRow &row, const State &state)
  {
    std::optional<TimerOutput::Scope> scope(std::in_place, timer, "output");
    external_work = row.external_work;
    record_opening(state, row);
    statistics.add(row);
    log_step(row);
    check_energy_balance();
    watch_slits(state);
    throw_on_all_ranks(log.failure(), communicator);

    // a load that nothing carries any more is no force that was borne
    const bool is_carried = loads_are_carried(state);
    if (is_carried && row.force_size() > load_control.peak_force())
    {
      peak_state = state;
      peak_state.reaction.clear(); // which is of no use on another mesh
      peak_step = row.step;
    }
    const TracedCracks cracks = crack_observer.trace(state);
    crack_path_writer.add(row.step, row.time, row.displacement, cracks.paths);
    if (parameters.load.stop_when_separated && cracks.separate_body)
      run_end = RunEnd::separated;
    if (is_carried && load_control.has_fallen(row.force_size()) &&
        run_end == RunEnd::none)
      run_end = RunEnd::force_fell;
    if (!is_carried)
      run_end = RunEnd::no_equilibrium;
    check_damage();
    write_fields_when_due(state);
    scope.reset(); // a checkpoint has its own
    const unsigned int every = parameters.output.checkpoint_every;
    // the end writes one of its own
    if (every > 0 && row.step > 0 && row.step % every == 0 &&
        run_end == RunEnd::none && !load_control.at_end())
      write_checkpoint(state, totals());
  }



  template <int dim>
  Tensor<1, dim>
  Simulation<dim>::force(const State &state) const
  {
    return parameters.thickness_factor() *
           boundary_quantities.force(state.reaction);
  }



  template <int dim>
  double
  Simulation<dim>::smallest_phase_field(const State &state) const
  {
    double smallest = 1.;
    for (const auto dof : fields.phase_field_dofs.owned)
      smallest = std::min(smallest, double(state.phase_field(dof)));
    return Utilities::MPI::min(smallest, communicator);
  }



  template <int dim>
  void
  Simulation<dim>::write_fields_when_due(const State &state)
  {
    const StatisticsRow &row   = statistics.rows().back();
    const unsigned int   every = parameters.output.fields_every;
    // only a fall tells that the peak was one
    const bool past_peak = row.force_size() < 0.98 * load_control.peak_force();
    if (past_peak && !field_output.has(peak_step))
      write_fields(peak_state, peak_step);
    if (row.step == 0 || run_end != RunEnd::none ||
        (every > 0 && row.step % every == 0))
      write_fields(state, row.step);
  }



  template <int dim>
  void
  Simulation<dim>::write_fields(const State &state, const unsigned int step)
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
  Summary
  Simulation<dim>::summarize(const RunOutcome &outcome, const RunTotals &cost)
  {
    Summary summary;
    summary.version            = MIXED_CRACKS_VERSION;
    summary.revision           = MIXED_CRACKS_REVISION;
    summary.deal_ii_version    = DEAL_II_PACKAGE_VERSION;
    summary.case_in_words      = case_in_words;
    summary.coupling           = parameters.coupling.kind;
    summary.pressure_law       = parameters.model.pressure_law;
    summary.formulation        = parameters.model.formulation;
    summary.kinematics         = dim == 2 ? parameters.model.kinematics : "3-d";
    summary.linear_solver      = elastic_step->linear_solver().description();
    summary.ranks              = Utilities::MPI::n_mpi_processes(communicator);
    summary.cell_size          = finest_cell_size(triangulation, communicator);
    summary.length_scale       = material->description().length_scale;
    summary.residual_stiffness = material->description().residual_stiffness;
    summary.thickness          = parameters.material.thickness;
    summary.force_fell =
      statistics.rows().back().force_size() < load_control.fallen_force();
    summary.without_equilibrium = run_end == RunEnd::no_equilibrium;
    summary.exit_reason         = outcome.reason;
    summary.exit_status         = outcome.exit_status;
    summary.rejected_steps      = cost.rejected_steps;
    summary.factorizations      = cost.factorizations;
    summary.solves              = cost.solves;
    summary.wall_time           = cost.wall_time;
    summary.phases              = cost.phases;
    summary.dimension           = dim;
    summary.with_crack_volume   = parameters.crack_opening.crack_volume;
    summary.warnings            = all_warnings();
    for (const std::string &warning :
         {damage_warning(),
          imbalance_in_words(statistics.rows(), imbalance_rule())})
      if (!warning.empty())
        summary.warnings.push_back(warning);
    return summary;
  }



#define INSTANTIATE(dim)                                                       \
  template void          Simulation<dim>::inspect_output(ExistingRun);         \
  template void          Simulation<dim>::prepare_output();                    \
  template StatisticsRow Simulation<dim>::measure(                             \
    const State &, const State &, const StepOutcome &);                        \
  template void Simulation<dim>::record(const StatisticsRow &, const State &); \
  template Tensor<1, dim> Simulation<dim>::force(const State &) const;         \
  template double  Simulation<dim>::smallest_phase_field(const State &) const; \
  template void    Simulation<dim>::write_fields_when_due(const State &);      \
  template void    Simulation<dim>::write_fields(const State &, unsigned int); \
  template Summary Simulation<dim>::summarize(const RunOutcome &,              \
                                              const RunTotals &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
