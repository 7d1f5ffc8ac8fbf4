// SPDX-License-Identifier: GPL-2.0-or-later
// When the mesh changes, and what goes with it. The lengths of the .prm are
// multiplied by l here (discretization/adaptation.cc says what they mean).
//
// Three states are carried to the new mesh in a load step: the accepted one,
// the trial, and that of the peak load, which the recorder keeps. Flags depend
// on places, not on cells: a round makes a cell one level finer, and the same
// places are asked again until no cell is left to refine.
//
// Before the first step nothing is carried: phi at the start is known as a
// function, and is set on each mesh anew.

#include <simulation/mesh_adaptation.h>
#include <simulation/simulation_setup.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    bool
    is_in_load_step(const State &trial)
    {
      return trial.time_step > 0.;
    }



    void
    collect(State                                &state,
            std::vector<LinearAlgebra::Vector *> &elastic,
            std::vector<LinearAlgebra::Vector *> &phase_field)
    {
      // the peak has no state before the first step is accepted
      if (state.elastic.size() == 0)
        return;
      for (LinearAlgebra::Vector *field : fields_on(StateDofs::elastic, state))
        elastic.push_back(field);
      for (LinearAlgebra::Vector *field :
           fields_on(StateDofs::phase_field, state))
        phase_field.push_back(field);
    }
    // nodes that a finer side has gained go by the mean strain of their state
    template <int dim>
    void
    fit_periodic_sides(State &state, const Body<dim> &body)
    {
      if (!body.constraints.periodic().any() || state.elastic.size() == 0)
        return;
      LinearAlgebra::Vector owned =
        body.fields.owned_vector(body.fields.elastic_dofs);
      owned = state.elastic;
      body.constraints.fit(state.time, owned);
      state.elastic = owned;
    }
  } // namespace



  template <int dim>
  AdaptationRule
  MeshAdaptation<dim>::rule(const bool in_load_step) const
  {
    const MeshParameters<dim> &mesh   = body.parameters.mesh;
    const double               length = body.length_scale();
    AdaptationRule             result;
    result.threshold    = mesh.phase_field_threshold;
    result.finest_level = mesh.finest_adaptive_level();
    result.margin       = mesh.refinement_margin * length;
    // no crack runs before the first load step; fronts in 3-d have no tips
    if (dim == 2 && in_load_step)
      result.lookahead = mesh.refinement_lookahead * length;
    if (in_load_step)
      result.kept_margin = mesh.coarsening_margin * length;
    return result;
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::needs_finer_mesh(const State &trial) const
  {
    return body.parameters.mesh.adaptation != "none" &&
           !places_to_refine(
              body.fields, trial.phase_field, rule(is_in_load_step(trial)))
              .empty();
  }



  template <int dim>
  void
  MeshAdaptation<dim>::refine_first_mesh(
    const std::function<void()> &ask_to_stop)
  {
    // the initial phase field is set anew on each mesh: interpolated, it would
    // be damaged over the width of a coarse cell
    const Fields<dim> &fields = body.fields;
    while (true)
    {
      ask_to_stop();
      const LinearAlgebra::Vector start =
        initial_phase_field(body.parameters, fields, body.constraints);
      State state;
      state.phase_field = fields.ghosted_vector(fields.phase_field_dofs);
      state.phase_field = start;
      if (!needs_finer_mesh(state))
        return;
      const AdaptationRule now = rule(false);
      if (!flag_cells_near(places_to_refine(fields, state.phase_field, now),
                           now,
                           body.triangulation))
        return;
      refine_and_transfer(
        body.triangulation, body.fields, body.constraints, {}, {});
    }
  }



  template <int dim>
  void
  MeshAdaptation<dim>::refine(const State                &trial,
                              const std::vector<State *> &states)
  {
    const Parameters<dim>       &parameters = body.parameters;
    const AdaptationRule         now        = rule(is_in_load_step(trial));
    const RefinementRegions<dim> regions =
      now.coarsens() ? refined_regions(parameters, body.triangulation)
                     : RefinementRegions<dim>();
    const RefinedAtStart<dim> was_refined = [&](const auto &cell) {
      return is_refined<dim>(cell, parameters.mesh.global_refinements, regions);
    };
    const AdaptationPlaces<dim> places =
      places_to_refine(body.fields, trial.phase_field, now);
    // a round adds one level
    while (flag_cells_near(places, now, body.triangulation))
    {
      if (now.coarsens())
        flag_cells_to_coarsen(
          places, now, was_refined, body.fields, trial.phase_field);
      std::vector<LinearAlgebra::Vector *> elastic, phase_field;
      for (State *state : states)
        collect(*state, elastic, phase_field);
      refine_and_transfer(body.triangulation,
                          body.fields,
                          body.constraints,
                          elastic,
                          phase_field);
      for (State *state : states)
        fit_periodic_sides(*state, body);
    }
  }



  template class MeshAdaptation<2>;
  template class MeshAdaptation<3>;
} // namespace MixedCracks
