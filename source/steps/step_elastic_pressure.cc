// SPDX-License-Identifier: GPL-2.0-or-later
// Loads of a step that depend on its displacements: pressures that follow the
// boundary (normal_loads_follower.cc). The residual has their forces at the
// iterate, the matrix their derivative; what the loads of one boundary come to
// is asked for by who watches it.

#include <steps/step_elastic.h>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  template <int dim>
  double
  ElasticStep<dim>::subtract_pressures(const Vector &elastic)
  {
    if (!follower.any())
      return 0.;
    Vector forces = fields.owned_vector(fields.elastic_dofs);
    follower.add_forces(elastic, constraints.elastic_hanging_nodes(), forces);
    full_residual.add(-1., forces);
    return forces.l2_norm();
  }



  // F_p(u) at the level to come, less that at the present one. It is asked for
  // before the residual, with which the state of `follower` is set again.
  template <int dim>
  Vector
  ElasticStep<dim>::pressures_to_come(const Vector &elastic)
  {
    Vector present = fields.owned_vector(fields.elastic_dofs);
    if (!follower.any())
      return present;
    Vector      forces  = present;
    const auto &hanging = constraints.elastic_hanging_nodes();
    follower.add_forces(elastic, hanging, present);
    FollowerPressure<dim> coming(follower);
    coming.advance_level(1.);
    coming.add_forces(elastic, hanging, forces);
    forces.add(-1., present);
    return forces;
  }



  template <int dim>
  Vector
  ElasticStep<dim>::loads_in(const State &state)
  {
    Vector forces = dead_loads(state.time);
    if (!follower.any())
      return forces;
    FollowerPressure<dim> there(follower);
    there.set_level(state.time, state.time, 1.);
    there.add_forces(
      state.elastic, constraints.elastic_hanging_nodes(), forces);
    return forces;
  }



  // The forces are those at the iterate that the last correction starts from:
  // the first place that is asked for is that one.
  template <int dim>
  double
  ElasticStep<dim>::work_along_search(const Vector &elastic,
                                      const Vector &displacement)
  {
    double work = external * displacement;
    if (!follower.any())
      return work;
    if (search_begins)
    {
      search_forces = fields.owned_vector(fields.elastic_dofs);
      FollowerPressure<dim> here(follower);
      here.add_forces(
        elastic, constraints.elastic_hanging_nodes(), search_forces);
      search_begins = false;
    }
    work += search_forces * displacement;
    return work;
  }



  template <int dim>
  Vector
  ElasticStep<dim>::loads_on_boundary(const types::boundary_id boundary,
                                      const State             &state)
  {
    Vector      forces  = fields.owned_vector(fields.elastic_dofs);
    const auto &hanging = constraints.elastic_hanging_nodes();
    if (const auto found = loads.tractions.find(boundary);
        found != loads.tractions.end())
    {
      found->second->set_time(state.time);
      assembler.external_forces(
        nullptr, {{boundary, found->second.get()}}, hanging, forces);
    }
    const auto of_boundary = [&](const BoundaryFunctions<dim> &functions) {
      BoundaryFunctions<dim> result;
      if (const auto found = functions.find(boundary); found != functions.end())
      {
        found->second->set_time(state.time);
        result.insert(*found);
      }
      return result;
    };
    add_normal_forces(
      fields, of_boundary(loads.normal_tractions), 1., hanging, forces);
    const BoundaryFunctions<dim> pressures = of_boundary(loads.pressures);
    if (!follower.any())
    {
      add_normal_forces(fields, pressures, -1., hanging, forces);
      return forces;
    }
    FollowerPressure<dim> there(fields, pressures);
    there.set_level(state.time, state.time, 1.);
    there.add_forces(state.elastic, hanging, forces);
    return forces;
  }



#define INSTANTIATE(dim)                                                  \
  template double ElasticStep<dim>::subtract_pressures(const Vector &);   \
  template Vector ElasticStep<dim>::pressures_to_come(const Vector &);    \
  template Vector ElasticStep<dim>::loads_in(const State &);              \
  template double ElasticStep<dim>::work_along_search(const Vector &,     \
                                                      const Vector &);    \
  template Vector ElasticStep<dim>::loads_on_boundary(types::boundary_id, \
                                                      const State &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
