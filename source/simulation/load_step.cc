// SPDX-License-Identifier: GPL-2.0-or-later
// The solvers of a load step with what the .prm applies. It is one object for
// the whole run; reinit() after each change of the mesh.
//
// Whether dead loads are still carried: a body in two parts, one of them with
// loads and no support, has no equilibrium for kappa = 0; with kappa > 0 it has
// one, in which the broken cells are stretched until they bear the load. Signs
// of it:
//
//   1/2 l(u) > 1/2 E_el    most of the energy is due to the dead loads l, and
//   E_el in cells with mean phi < 0.1  >=  1/2 E_el    it sits in the crack.

#include <base/errors.h>

#include <simulation/case_checks.h>
#include <simulation/load_step.h>
#include <simulation/simulation_setup.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // mean phase field of a cell that carries with its residual stiffness only
    constexpr double broken = 0.1;

    template <int dim>
    Loads<dim>
    loads_on(const Body<dim> &body, std::shared_ptr<FluidAssembler<dim>> fluid)
    {
      Loads<dim> loads = make_loads(body.parameters,
                                    body.fields.elastic.get_fe().n_components(),
                                    body.triangulation);
      loads.fluid      = std::move(fluid);
      return loads;
    }
  } // namespace



  template <int dim>
  LoadStep<dim>::LoadStep(const Body<dim> &body,
                          const StopCheck &stop,
                          const Callbacks &callbacks,
                          PhaseTimer      &timer,
                          Log             &log)
    : LoadStep(body,
               stop,
               callbacks,
               timer,
               log,
               make_fluid(body.parameters, body.fields))
  {}



  template <int dim>
  LoadStep<dim>::LoadStep(const Body<dim>                     &body,
                          const StopCheck                     &stop,
                          const Callbacks                     &callbacks,
                          PhaseTimer                          &timer,
                          Log                                 &log,
                          std::shared_ptr<FluidAssembler<dim>> fluid)
    : assembler(body.fields,
                *body.material,
                constants_function(body.parameters.model, *body.material_field))
    , elastic(body.fields,
              body.constraints,
              assembler,
              loads_on(body, fluid),
              timer,
              solver_for_stiffness(body.parameters.solver,
                                   body.material->description()),
              stop)
    , body(body)
    , phase_field(body.fields,
                  body.constraints,
                  *body.material,
                  assembler,
                  fluid,
                  timer,
                  stop)
    , solver(elastic,
             phase_field,
             body.parameters.coupling.options(),
             body.parameters.solver.newton,
             callbacks,
             body.communicator(),
             log)
    , phase_field_points(body.parameters.boundary_conditions)
  {}



  template <int dim>
  void
  LoadStep<dim>::reinit()
  {
    const LinearOutcome analysis = elastic.reinit();
    if (!analysis.success)
      throw SolverError(analysis.reason);
    phase_field.reinit();
    fixed.frozen = unbreakable_nodes(body.parameters, body.fields);
    phase_field_points.reinit(body.fields, body.constraints);
  }



  template <int dim>
  StepOutcome
  LoadStep<dim>::solve(const State       &accepted,
                       const double       bound,
                       const StepOutcome &so_far,
                       State             &trial)
  {
    fixed.prescribed =
      prescribed_phase_field(body.parameters, body.fields, trial.time);
    phase_field_points.add(trial.time, fixed.prescribed);
    return solver.solve(accepted, fixed, bound, so_far, trial);
  }



  template <int dim>
  RunTotals
  LoadStep<dim>::totals(const unsigned int n_rejected) const
  {
    RunTotals now;
    now.factorizations = elastic.counts().factorizations;
    now.solves         = elastic.counts().solves;
    now.rejected_steps = n_rejected;
    return now;
  }



  // Sum of psi_K |K| over cells with mean phi < 0.1 by that over all cells,
  // psi_K the elastic energy density of the cell.
  template <int dim>
  double
  LoadStep<dim>::broken_part_of_energy(const State &state)
  {
    const auto data = assembler.cell_data(
      state.elastic, state.lagged_phase_field, state.phase_field);
    const Vector<float> &density = data.values.at("strain_energy_density");
    std::vector<double>  sums(2, 0.); // all, broken
    for (const auto &cell : body.fields.phase_field.active_cell_iterators())
    {
      if (!cell->is_locally_owned())
        continue;
      const double energy =
        density(cell->active_cell_index()) * cell->measure();
      double mean = 0.;
      for (const unsigned int v : cell->vertex_indices())
        mean +=
          state.phase_field(cell->vertex_dof_index(v, 0)) / cell->n_vertices();
      sums[0] += energy;
      if (mean < broken)
        sums[1] += energy;
    }
    Utilities::MPI::sum(sums, body.communicator(), sums);
    return sums[0] > 0. ? sums[1] / sums[0] : 0.;
  }



  // A body that dead loads have torn apart is in equilibrium by its residual
  // stiffness only: what the loads store is stored in broken material. Where
  // prescribed displacements hold the parts, the loads store little of it.
  template <int dim>
  bool
  LoadStep<dim>::loads_are_carried(const State &state,
                                   const double stored_energy)
  {
    if (!elastic.has_dead_loads())
      return true;
    const double by_loads =
      0.5 * body.parameters.thickness_factor() * elastic.work_of_loads(state);
    return !(by_loads > 0.5 * stored_energy) ||
           broken_part_of_energy(state) < 0.5;
  }



  template class LoadStep<2>;
  template class LoadStep<3>;
} // namespace MixedCracks
