// SPDX-License-Identifier: GPL-2.0-or-later
// Displacement and pressure of a load step, for a given phi~: the first two
// lines of (M5),
//
//   R(u, p) = internal(u, p; g(phi~)) - external(t, phi~) = 0,   u = u_D(t)
//
// on supports. Kept for as long as they are good: the pattern and its analysis
// per mesh, the factors as long as they reduce the residual
// (step_elastic_solve.cc has Newton's method). Work and energies are per mm of
// thickness: N/mm times mm = N.

#include <deal.II/dofs/dof_tools.h>

#include <discretization/rigid_body_modes.h>
#include <discretization/sparse_matrix.h>

#include <steps/step_elastic.h>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  template <int dim>
  ElasticStep<dim>::ElasticStep(const Fields<dim>      &fields,
                                const Constraints<dim> &constraints,
                                Assembler<dim>         &assembler,
                                Loads<dim>              loads,
                                PhaseTimer             &timer,
                                const SolverParameters &solver_parameters,
                                StopCheck               stop)
    : fields(fields)
    , constraints(constraints)
    , assembler(assembler)
    , loads(std::move(loads))
    , timer(timer)
    , solver_name(solver_parameters.name)
    , solver_options(solver_parameters.linear)
    , stop(std::move(stop))
    , auxiliaries(fields, constraints)
    , matrix_free(fields, constraints)
    , potential(fields, constraints, assembler)
    , follower(fields,
               assembler.is_finite() ? this->loads.pressures
                                     : BoundaryFunctions<dim>())
  {}



  template <int dim>
  LinearOutcome
  ElasticStep<dim>::reinit()
  {
    PhaseTimer::Scope scope(timer, "setup");
    assembler.reinit();
    loads.at_points.reinit(fields, constraints.elastic_hanging_nodes());
    if (loads.fluid)
      loads.fluid->reinit();
    const DofSets &dofs = fields.elastic_dofs;
    if (solver)
      solver->release();
    choose_solver();
    if (solver->needs_matrix())
      make_sparse_matrix(
        fields.elastic, dofs, constraints.elastic_corrections(), matrix);
    else
    {
      matrix.clear();
      matrix_free.reinit();
    }
    if (assembler.is_finite())
      potential.reinit();
    for (Vector *vector :
         {&iterate, &full_residual, &residual, &correction, &external})
      vector->reinit(dofs.owned, fields.communicator());
    pressure_dofs.assign(dofs.owned.n_elements(), false);
    if (fields.layout.mixed)
    {
      const IndexSet pressure = DoFTools::extract_dofs(
        fields.elastic,
        fields.elastic.get_fe().component_mask(fields.pressure));
      for (const auto dof : pressure)
        pressure_dofs[dofs.owned.index_within_set(dof)] = true;
    }
    return solver->initialize(describe_system());
  }



  template <int dim>
  void
  ElasticStep<dim>::choose_solver()
  {
    const LinearSolverChoice earlier = choice;
    choice                           = choose_linear_solver(solver_name,
                                  dim,
                                  fields.elastic.n_dofs(),
                                  fields.layout.mixed && !follower.any());
    if (!solver || choice.name != earlier.name)
      solver = all_linear_solvers().make(choice.name, solver_options);
    if (!solver->is_direct())
      auxiliaries.reinit();
  }



  template <int dim>
  LinearSystem
  ElasticStep<dim>::describe_system()
  {
    LinearSystem system;
    if (solver->needs_matrix())
      system.matrix = &matrix;
    else
      system.product = &matrix_free;
    // at finite strain it is symmetric but need not be positive definite
    const bool is_symmetric = assembler.elastic_matrix_is_symmetric() &&
                              !follower.any() &&
                              (solver->is_direct() || !assembler.is_finite());
    system.symmetry =
      is_symmetric ? MatrixSymmetry::symmetric : MatrixSymmetry::none;
    system.n_components = dim;
    system.is_pressure  = pressure_dofs;
    for (const auto dof : fields.elastic_dofs.owned)
      system.is_constrained.push_back(
        constraints.elastic_corrections().is_constrained(dof));
    system.rigid_body_modes = [this](const std::vector<bool> &chosen) {
      return rigid_body_modes(fields, chosen);
    };
    system.auxiliary = [this]() {
      auxiliaries.assemble(assembler,
                           solver->needs_matrix() ? nullptr : &matrix_free);
      AuxiliaryMatrices result;
      if (auxiliaries.has_displacement())
      {
        result.displacement  = &auxiliaries.displacement();
        result.interpolation = &auxiliaries.coarse().interpolation();
        result.is_coarse     = &auxiliaries.coarse().at_vertices();
      }
      if (fields.layout.mixed)
        result.pressure = &auxiliaries.pressure();
      if (auxiliaries.fluid_like().has_block())
      {
        result.block         = &auxiliaries.fluid_like().block();
        result.rows_of_block = &auxiliaries.fluid_like().rows();
      }
      return result;
    };
    system.stop = [this](const std::string &finished) {
      return ask_to_stop(finished);
    };
    // in the middle of a solution, see solve_for_correction()
    system.as_set_up = [this](const std::function<void()> &work) {
      timer.count_elsewhere("solve", "factorisation", work);
    };
    return system;
  }



  template <int dim>
  bool
  ElasticStep<dim>::ask_to_stop(const std::string &finished)
  {
    is_stopped = is_to_stop(stop, finished) || is_stopped;
    return is_stopped;
  }



  template <int dim>
  std::string
  ElasticStep<dim>::linear_solver_in_words() const
  {
    return choice.name + ", " + solver->description() +
           (choice.reason.empty() ? "" : " (auto: " + choice.reason + ")");
  }



  // F(t): body force, tractions, forces at points and, at small strain,
  // pressures; N/mm at the nodes
  template <int dim>
  Vector
  ElasticStep<dim>::dead_loads(const double time) const
  {
    Vector forces = fields.owned_vector(fields.elastic_dofs);
    if (!loads.any())
      return forces;
    if (loads.body_force)
      loads.body_force->set_time(time);
    std::map<types::boundary_id, const Function<dim> *> tractions;
    for (const auto &[boundary, function] : loads.tractions)
    {
      function->set_time(time);
      tractions[boundary] = function.get();
    }
    assembler.external_forces(loads.body_force.get(),
                              tractions,
                              constraints.elastic_hanging_nodes(),
                              forces);
    const auto add_normal = [&](const BoundaryFunctions<dim> &functions,
                                const double                  sign) {
      for (const auto &entry : functions)
        entry.second->set_time(time);
      add_normal_forces(
        fields, functions, sign, constraints.elastic_hanging_nodes(), forces);
    };
    add_normal(loads.normal_tractions, 1.);
    if (!follower.any())
      add_normal(loads.pressures, -1.);
    loads.at_points.add(time, forces);
    return forces;
  }



  // F(t) + f(t, phi): with the fluid, whose forces are where phi changes, (M10)
  template <int dim>
  Vector
  ElasticStep<dim>::external_forces(const double  time,
                                    const Vector &phase_field) const
  {
    Vector forces = dead_loads(time);
    if (loads.fluid)
      loads.fluid->add_nodal_forces(
        time, phase_field, constraints.elastic_hanging_nodes(), forces);
    return forces;
  }



  template <int dim>
  DrivingForce
  ElasticStep<dim>::driving_force() const
  {
    PhaseTimer::Scope scope(timer, "assembly");
    return assembler.driving_force();
  }



  template <int dim>
  void
  ElasticStep<dim>::update_reaction(State &state)
  {
    external = external_forces(state.time, state.lagged_phase_field);
    follower.set_level(state.time, state.time, 1.);
    evaluate_residual(state);
    constraints.keep_prescribed(full_residual);
    state.reaction.reinit(fields.elastic_dofs.owned,
                          fields.elastic_dofs.relevant,
                          fields.communicator());
    state.reaction = full_residual;
  }



  template <int dim>
  double
  ElasticStep<dim>::work_of_loads(const State &state)
  {
    Vector displacement = fields.owned_vector(fields.elastic_dofs);
    displacement        = state.elastic;
    return loads_in(state) * displacement;
  }



  // By the trapezoidal rule for loads and reactions r,
  //
  //   W = 1/2 (F_0 + F_1 + r_0 + r_1) . (u_1 - u_0) + W_fluid,
  //
  // exact where both are linear in the step, as at small strain while nothing
  // breaks. r is the residual before the supports are taken out: 0 at free
  // nodes, what a support gives at the others. F of a pressure that follows the
  // boundary is that of the displacements, too.
  template <int dim>
  double
  ElasticStep<dim>::external_work(const State &before, const State &after)
  {
    Vector increment = fields.owned_vector(fields.elastic_dofs);
    Vector old       = increment;
    increment        = after.elastic;
    old              = before.elastic;
    increment.add(-1., old);
    Vector forces = loads_in(before);
    forces.add(1., loads_in(after));
    Vector reaction(increment);
    reaction = before.reaction;
    forces.add(1., reaction);
    reaction = after.reaction;
    forces.add(1., reaction);
    return 0.5 * (forces * increment) + fluid_work(before, after);
  }



  // At small strain (r + F) . u = internal . u = integral of sigma : eps =
  // twice the stored energy, as R = 0 at free nodes and the constraint holds.
  // At finite strain the law has it.
  template <int dim>
  double
  ElasticStep<dim>::stored_energy(const State &state) const
  {
    if (assembler.is_finite())
      return assembler.stored_energy(state.elastic, state.lagged_phase_field);
    // solve() left nothing but reactions in the residual
    return 0.5 * (full_residual * iterate + external * iterate);
  }



  // 1/2 sum over both pressures of E_f(before) - E_f(after), E_f = -p_f times
  // volume: the mean pressure times the volume that the crack has gained. It
  // counts what the fluid does when phi alone moves, too.
  template <int dim>
  double
  ElasticStep<dim>::fluid_work(const State &before, const State &after) const
  {
    if (!loads.fluid)
      return 0.;
    // the mean pressure of the step times the volume gained: a crack also
    // gains volume, and the fluid does work, where only the phase field moves
    double work = 0.;
    for (const double time : {before.time, after.time})
    {
      work +=
        0.5 * loads.fluid->energy(time, before.elastic, before.phase_field);
      work -= 0.5 * loads.fluid->energy(time, after.elastic, after.phase_field);
    }
    return work;
  }



  template class ElasticStep<2>;
  template class ElasticStep<3>;
} // namespace MixedCracks
