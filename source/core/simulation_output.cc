// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/simulation.h>
#include <core/version.h>

#include <fstream>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  void
  Simulation<dim>::prepare_output(const ExistingRun existing)
  {
    const std::string &directory = parameters.output.directory;
    prepare_output_directory(
      directory, existing, parameters.output.with_fields(), communicator);
    log.open(directory + "/log.txt", existing == ExistingRun::resume);
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
  void
  Simulation<dim>::record(const State       &before,
                          const State       &state,
                          const StepOutcome &outcome)
  {
    std::optional<TimerOutput::Scope> scope(std::in_place, timer, "output");
    const double                      thickness = parameters.thickness_factor();
    StatisticsRow                     row;
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
    external_work += thickness * elastic_step->external_work(before, state);
    row.external_work       = external_work;
    row.min_phase_field     = smallest_phase_field(state);
    row.phase_field_change  = outcome.phase_field_change;
    row.newton_iterations   = outcome.newton_iterations;
    row.linear_iterations   = outcome.linear_iterations;
    row.active_set_size     = outcome.active_set_size;
    row.cells               = triangulation.n_global_active_cells();
    row.dofs                = fields.n_dofs();
    row.wall_time           = wall_clock.wall_time();
    row.coupling_iterations = outcome.coupling_iterations;
    row.coupling_change     = outcome.coupling_change;
    row.factorizations      = elastic_step->counts().factorizations;
    row.rejected_steps      = load_control.n_rejected();
    row.refinements         = n_refinements;
    record_opening(state, row);
    row.point_displacements = point_displacements.evaluate(state.elastic);
    statistics.add(row);
    log_step(row);
    check_energy_balance();
    watch_slits(state);

    if (row.force_size() > load_control.peak_force())
    {
      peak_state = state;
      peak_step  = row.step;
    }
    const bool joined = crack_observer.record(
      row.step, row.time, row.displacement, state.phase_field);
    if (parameters.load.stop_when_separated && joined)
      run_end = RunEnd::separated;
    if (load_control.has_fallen(row.force_size()))
      run_end = RunEnd::force_fell;
    if (!loads_are_carried(state))
      run_end = RunEnd::no_equilibrium;
    write_fields_when_due(state);
    scope.reset(); // a checkpoint has its own
    const unsigned int every = parameters.output.checkpoint_every;
    if (every > 0 && row.step > 0 && row.step % every == 0)
      write_checkpoint(state);
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
      assembler->cell_data(state.elastic, state.lagged_phase_field).values);
  }



  template <int dim>
  RunOutcome
  Simulation<dim>::finish(const State &last)
  {
    const unsigned int last_step = statistics.rows().back().step;
    if (!field_output.has(peak_step))
      write_fields(peak_state, peak_step);
    if (!field_output.has(last_step))
      write_fields(last, last_step);
    if (run_end == RunEnd::stopped)
      write_checkpoint(last);
    const RunOutcome outcome{exit_status(run_end), end_in_words()};
    Summary          summary = summarize(outcome);
    summary.cracks           = crack_observer.finish(last.phase_field);
    if (dim == 3 && summary.separated)
      summary.cracks.path = "separated";
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      write_summary(parameters.output.directory + "/summary.json",
                    summary,
                    statistics.rows());
    log_end(outcome, summary);
    return outcome;
  }



  template <int dim>
  Summary
  Simulation<dim>::summarize(const RunOutcome &outcome)
  {
    Summary summary;
    summary.version            = MIXED_CRACKS_VERSION;
    summary.revision           = MIXED_CRACKS_REVISION;
    summary.deal_ii_version    = DEAL_II_PACKAGE_VERSION;
    summary.case_in_words      = case_in_words;
    summary.coupling           = parameters.model.coupling;
    summary.pressure_law       = parameters.model.pressure_law;
    summary.formulation        = parameters.model.formulation;
    summary.kinematics         = dim == 2 ? parameters.model.kinematics : "3-d";
    summary.linear_solver      = elastic_step->linear_solver().description();
    summary.ranks              = Utilities::MPI::n_mpi_processes(communicator);
    summary.cell_size          = finest_cell_size(triangulation, communicator);
    summary.length_scale       = material->description().length_scale;
    summary.residual_stiffness = material->description().residual_stiffness;
    summary.thickness          = parameters.material.thickness;
    summary.separated =
      run_end == RunEnd::separated || run_end == RunEnd::force_fell;
    summary.exit_reason    = outcome.reason;
    summary.exit_status    = outcome.exit_status;
    summary.rejected_steps = load_control.n_rejected();
    summary.factorizations = elastic_step->counts().factorizations;
    summary.wall_time      = wall_clock.wall_time();
    for (const auto &[name, seconds] :
         timer.get_summary_data(TimerOutput::total_wall_time))
      summary.phases[name] = Utilities::MPI::max(seconds, communicator);
    summary.dimension         = dim;
    summary.with_crack_volume = parameters.crack_opening.crack_volume;
    summary.warnings          = all_warnings();
    return summary;
  }



#define INSTANTIATE(dim)                                                      \
  template void Simulation<dim>::prepare_output(ExistingRun);                 \
  template void Simulation<dim>::record(                                      \
    const State &, const State &, const StepOutcome &);                       \
  template Tensor<1, dim> Simulation<dim>::force(const State &) const;        \
  template double Simulation<dim>::smallest_phase_field(const State &) const; \
  template void   Simulation<dim>::write_fields_when_due(const State &);      \
  template void   Simulation<dim>::write_fields(const State &, unsigned int); \
  template RunOutcome Simulation<dim>::finish(const State &);                 \
  template Summary    Simulation<dim>::summarize(const RunOutcome &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
