// SPDX-License-Identifier: GPL-2.0-or-later
#include <simulation/simulation.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
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
  } // namespace



  template <int dim>
  AdaptationRule
  Simulation<dim>::adaptation_rule() const
  {
    const double   length_scale = material->description().length_scale;
    AdaptationRule rule;
    rule.threshold    = parameters.mesh.phase_field_threshold;
    rule.finest_level = parameters.mesh.finest_adaptive_level();
    rule.margin       = parameters.mesh.refinement_margin * length_scale;
    // no crack runs before the first load step; fronts in 3-d have no tips
    if (dim == 2 && !statistics.rows().empty())
      rule.lookahead = parameters.mesh.refinement_lookahead * length_scale;
    if (!statistics.rows().empty())
      rule.kept_margin = parameters.mesh.coarsening_margin * length_scale;
    return rule;
  }



  template <int dim>
  bool
  Simulation<dim>::needs_finer_mesh(
    const LinearAlgebra::Vector &phase_field) const
  {
    return parameters.mesh.adaptation != "none" &&
           !places_to_refine(fields, phase_field, adaptation_rule()).empty();
  }



  template <int dim>
  void
  Simulation<dim>::refine_initial_mesh()
  {
    // the initial phase field is set anew on each mesh: interpolated, it would
    // be damaged over the width of a coarse cell
    while (true)
    {
      leave_early_if_asked("refinement of the first mesh");
      const LinearAlgebra::Vector start =
        initial_phase_field(parameters, fields, constraints);
      LinearAlgebra::Vector phase_field =
        fields.ghosted_vector(fields.phase_field_dofs);
      phase_field               = start;
      const AdaptationRule rule = adaptation_rule();
      if (!needs_finer_mesh(phase_field) ||
          !flag_cells_near(
            places_to_refine(fields, phase_field, rule), rule, triangulation))
        return;
      refine_and_transfer(triangulation, fields, constraints, {}, {});
    }
  }



  template <int dim>
  void
  Simulation<dim>::refine(State &accepted, State &trial)
  {
    {
      TimerOutput::Scope           scope(timer, "refinement");
      const AdaptationRule         rule = adaptation_rule();
      const RefinementRegions<dim> regions =
        rule.coarsens() ? refined_regions(parameters, triangulation)
                        : RefinementRegions<dim>();
      const RefinedAtStart<dim> was_refined = [&](const auto &cell) {
        return is_refined<dim>(
          cell, parameters.mesh.global_refinements, regions);
      };
      const AdaptationPlaces<dim> places =
        places_to_refine(fields, trial.phase_field, rule);
      // a round adds one level
      while (flag_cells_near(places, rule, triangulation))
      {
        if (rule.coarsens())
          flag_cells_to_coarsen(
            places, rule, was_refined, fields, trial.phase_field);
        std::vector<LinearAlgebra::Vector *> elastic, phase_field;
        for (State *state : {&accepted, &trial, &peak_state})
          collect(*state, elastic, phase_field);
        refine_and_transfer(
          triangulation, fields, constraints, elastic, phase_field);
      }
    }
    ++n_refinements;
    reinit_on_mesh();
    // nodal forces cannot be interpolated
    elastic_step->update_reaction(accepted);
    log.line(printed(
      "  refined: %llu cells, %llu dofs",
      static_cast<unsigned long long>(triangulation.n_global_active_cells()),
      static_cast<unsigned long long>(fields.n_dofs())));
  }



#define INSTANTIATE(dim)                                            \
  template AdaptationRule Simulation<dim>::adaptation_rule() const; \
  template bool           Simulation<dim>::needs_finer_mesh(        \
    const LinearAlgebra::Vector &) const;                 \
  template void Simulation<dim>::refine_initial_mesh();             \
  template void Simulation<dim>::refine(State &, State &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
