// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>

#include <simulation/simulation.h>

#include <iostream>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::optional<types::boundary_id>
    force_boundary_id(const Parameters<dim> &parameters)
    {
      const std::string name = parameters.force_boundary();
      if (name.empty())
        return {};
      return parameters.geometry.chosen().boundary_ids().at(name);
    }
  } // namespace



  template <int dim>
  Simulation<dim>::Simulation(const Parameters<dim> &parameters,
                              const std::string     &effective_parameters,
                              const CaseSignature   &signature,
                              const MPI_Comm         communicator,
                              Log                   &log)
    : parameters(parameters)
    , effective_parameters(effective_parameters)
    , signature(signature)
    , communicator(communicator)
    , log(log)
    , timer(communicator,
            std::cout,
            TimerOutput::never,
            TimerOutput::wall_times)
    , stop_poll(communicator, parameters.output.wall_time_limit)
    , triangulation(communicator)
    , fields(triangulation,
             {parameters.model.mixed(), parameters.model.degree()})
    , constraints(
        fields,
        prescribed_components(parameters,
                              dim + (parameters.model.mixed() ? 1 : 0)),
        prescribed_points(parameters, dim + (parameters.model.mixed() ? 1 : 0)))
    , load_control(parameters.load)
    , boundary_quantities(fields, constraints, force_boundary_id(parameters))
    , crack_observer(fields, parameters.geometry.chosen().boundary_ids())
    , crack_path_writer(parameters.output.directory, communicator)
    , crack_opening(fields, parameters.crack_opening.lines())
    , crack_opening_file(parameters.output.directory,
                         crack_opening.lines(),
                         communicator)
    , point_displacements(fields, parameters.point_displacements.points())
    , slit_overlap(fields)
    , statistics(communicator)
    , field_output(fields,
                   parameters.output.directory,
                   parameters.output.field_format)
    , checkpoint(parameters.output.directory, communicator)
  {}



  template <int dim>
  RunOutcome
  Simulation<dim>::run(const ExistingRun existing)
  {
    if (existing == ExistingRun::resume)
    {
      resumed                    = checkpoint.read();
      const std::string fallback = fallback_in_words(checkpoint.found());
      if (has_damage(checkpoint.found()))
        warnings.push_back(fallback); // logged with the others
      else if (!fallback.empty())
        log.line(fallback);
      mend_resumed_case();
    }
    inspect_output(existing);
    preflight();
    leave_early_if_asked("making the mesh");
    State accepted = first_state();
    stop_poll.heed_the_clock();
    if (resumed)
      run_end = end_of_resumed_run(accepted);
    had_ended = run_end != RunEnd::none && resumed;
    advance_to_the_end(accepted);
    if (run_end == RunEnd::failed && !had_ended)
      why_failed += hint_at_no_stiffness();
    return finish(accepted,
                  {exit_status(run_end), end_in_words() + why_failed});
  }



  template <int dim>
  State
  Simulation<dim>::first_state()
  {
    try
    {
      if (!resumed)
        refine_initial_mesh();
      make_solvers();
      reinit_on_mesh();
      return resumed ? resumed_state() : initial_state();
    }
    catch (const SolverError &)
    {
      // the input was good; what could not be calculated has a log
      if (!resumed)
        prepare_output();
      throw;
    }
  }



  template <int dim>
  void
  Simulation<dim>::make_mesh_and_material(const bool only_check)
  {
    TimerOutput::Scope scope(timer, "setup");
    if (resumed)
    {
      parameters.geometry.chosen().create(triangulation);
      checkpoint.load_mesh(triangulation);
      cell_size = resumed->cell_size;
    }
    else if (only_check)
    {
      not_built = make_mesh_to_check(parameters, fields.layout, triangulation);
      cell_size = not_built ? not_built->finest_size
                            : finest_cell_size(triangulation, communicator);
    }
    else
    {
      make_mesh(parameters, triangulation);
      cell_size = finest_cell_size(triangulation, communicator);
    }
    material = std::make_unique<Material<dim>>(
      describe_material(parameters.model, parameters.material, dim, cell_size));
    require_solver_for_stiffness();
    fields.distribute();
    constraints.reinit();
    require_held_body();
    point_displacements.reinit();
    material_field = std::make_unique<const MaterialField<dim>>(
      make_material_field(parameters.material, triangulation));
    material_range = MixedCracks::material_range(*material_field, fields);
  }



  template <int dim>
  void
  Simulation<dim>::make_solvers()
  {
    const unsigned int n_components = fields.elastic.get_fe().n_components();
    assembler                       = std::make_unique<Assembler<dim>>(
      fields, *material, constants_function(parameters.model, *material_field));
    Loads<dim> loads     = make_loads(parameters, n_components);
    loads.fluid          = make_fluid(parameters, fields);
    const StopCheck stop = [this](const std::string &finished) {
      return stop_now(finished);
    };
    elastic_step = std::make_unique<ElasticStep<dim>>(
      fields, constraints, *assembler, loads, timer, solver_parameters(), stop);
    phase_field_step = std::make_unique<PhaseFieldStep<dim>>(
      fields, constraints, *material, *assembler, loads.fluid, timer, stop);
    step_solver = std::make_unique<StepSolver<dim>>(
      *elastic_step,
      *phase_field_step,
      parameters.coupling.options(),
      parameters.solver.newton,
      typename StepSolver<dim>::Callbacks{
        [this]() { return stop_now("coupling iteration"); },
        [this](State &trial) { crack_observer.watch(trial); },
        [this](const State &trial) {
          return needs_finer_mesh(trial.phase_field);
        },
        [this](const State &state) {
          const double limit = load_control.force_when_apart();
          return limit > 0. ? force(state).norm() / limit
                            : std::numeric_limits<double>::infinity();
        },
        [this](const State &trial) {
          return crack_observer.trace(trial).separate_body;
        }},
      communicator,
      log);
  }



  template <int dim>
  void
  Simulation<dim>::reinit_on_mesh()
  {
    const LinearOutcome analysis = elastic_step->reinit();
    if (!analysis.success)
      throw SolverError(analysis.reason);
    log_linear_solver();
    phase_field_step->reinit();
    boundary_quantities.reinit();
    crack_observer.reinit(material->description().length_scale);
    point_displacements.reinit();
    if (!crack_opening.lines().empty())
      crack_opening.reinit(parameters.crack_opening.reach *
                           material->description().length_scale);
    fixed_phase_field.frozen = unbreakable_nodes(parameters, fields);
  }



  template <int dim>
  State
  Simulation<dim>::initial_state()
  {
    State state;
    state.elastic     = fields.ghosted_vector(fields.elastic_dofs);
    state.reaction    = state.elastic;
    state.phase_field = fields.ghosted_vector(fields.phase_field_dofs);
    // named, since a temporary would be moved and take the ghosts away
    const LinearAlgebra::Vector start =
      initial_phase_field(parameters, fields, constraints);
    state.phase_field          = start;
    state.lagged_phase_field   = state.phase_field;
    state.previous_phase_field = state.phase_field;

    // Around slits and initial cracks the phase field takes its profile
    // before any load: this is no damage of the first step.
    leave_early_if_asked("analysis of the matrix");
    log.line("");
    log.line("step 0: profile of the initial cracks");
    State             relaxed = state;
    const StepOutcome outcome =
      solve_step(state, relaxed, std::numeric_limits<double>::infinity());
    if (outcome.interrupted)
      leave_early_if_asked("step 0");
    if (!outcome.solved)
      throw SolverError("the initial state cannot be computed: " +
                        outcome.reason + hint_at_no_stiffness());
    relaxed.previous_phase_field = relaxed.phase_field;
    const StatisticsRow row      = measure(relaxed, relaxed, outcome);
    if (const std::string fault = not_finite(relaxed, row); !fault.empty())
      throw SolverError("the initial state cannot be computed: " + fault);
    prepare_output();
    crack_path_writer.open(material->description().length_scale);
    relaxed.damage_origins = crack_observer.first_origins(relaxed.phase_field);
    crack_opening_file.open();
    record(row, relaxed);
    return relaxed;
  }



  template <int dim>
  StepOutcome
  Simulation<dim>::solve_step(State &accepted, State &trial, const double bound)
  {
    StepOutcome outcome;
    while (true)
    {
      fixed_phase_field.prescribed =
        prescribed_phase_field(parameters, fields, trial.time);
      outcome =
        step_solver->solve(accepted, fixed_phase_field, bound, outcome, trial);
      if (!outcome.mesh_is_too_coarse)
        return outcome;
      outcome.interrupted = stop_now("coupling iteration");
      if (outcome.interrupted)
        return outcome;
      refine(accepted, trial);
    }
  }



  namespace
  {
    std::string
    why_rejected(const StepOutcome &outcome)
    {
      if (!outcome.solved)
        return outcome.reason;
      return printed(outcome.runs_away
                       ? "the phase field runs away, by %.3g so far"
                       : "the phase field changed by %.3g",
                     outcome.phase_field_change);
    }
  } // namespace



  template <int dim>
  RunEnd
  Simulation<dim>::advance(State &accepted)
  {
    while (true)
    {
      if (stop_before_a_step())
        return how_stopped();
      State trial     = accepted;
      trial.time      = load_control.target_time();
      trial.time_step = load_control.step();
      log.line("");
      log.line(printed("step %zu: t = %.6g s, dt = %.4g s",
                       statistics.rows().size(),
                       trial.time,
                       trial.time_step));
      const double bound   = load_control.phase_field_bound();
      StepOutcome  outcome = solve_step(accepted, trial, bound);
      if (outcome.interrupted)
        return how_stopped();
      StatisticsRow row;
      if (outcome.solved && outcome.phase_field_change <= bound)
      {
        row            = measure(accepted, trial, outcome);
        outcome.reason = not_finite(trial, row);
        outcome.solved = outcome.reason.empty();
      }
      const double change = outcome.runs_away
                              ? std::numeric_limits<double>::infinity()
                              : outcome.phase_field_change;
      switch (load_control.judge(outcome.solved, change))
      {
        case LoadControl::Verdict::accept:
          trial.previous_phase_field = accepted.phase_field;
          record(row, trial);
          accepted = trial;
          return run_end;
        case LoadControl::Verdict::repeat:
          log.line("  rejected: " + why_rejected(outcome));
          break;
        case LoadControl::Verdict::onset:
          log.line("  onset: " + why_rejected(outcome));
          return RunEnd::onset;
        case LoadControl::Verdict::give_up:
          log.line("  failed at the smallest step: " + outcome.reason);
          why_failed = ": " + outcome.reason;
          return RunEnd::failed;
      }
    }
  }



  template class Simulation<2>;
  template class Simulation<3>;
} // namespace MixedCracks
