// SPDX-License-Identifier: GPL-2.0-or-later
// Sizes of cells. With h_0 the size in the coarse mesh, G 'Global refinements',
// R the levels of a region and A the 'Adaptive levels',
//
//   h = h_0/2^G everywhere,  h_0/2^(G+R) in a region,  and down to h_0/2^(G+A)
//   where adaptation refines.
//
// A crack needs l >= 2 h across it (Preflight warns); all lengths of adaptation
// are therefore in units of l: margin, lookahead, coarsening margin. l itself
// is fixed by the first mesh, so that adaptation changes the error and not the
// model.

#include <base/errors.h>

#include <deal.II/base/patterns.h>

#include <problem/mesh_parameters.h>

namespace MixedCracks
{
  template <int dim>
  void
  MeshParameters<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.enter_subsection("Mesh");
    prm.add_parameter("Global refinements",
                      global_refinements,
                      "How often every cell of the coarse mesh is halved.",
                      Integer(0, max_refinements));
    regions.add_parameters(prm);
    prm.add_parameter("Adaptation",
                      adaptation,
                      "Refinement during the run. 'none': the mesh stays; "
                      "'predictor corrector': cells that a step damages are "
                      "refined within the step, and the step is corrected. "
                      "The length scale stays, h in its expression is that of "
                      "the mesh at the start.",
                      Selection("none|predictor corrector"));
    prm.add_parameter("Adaptive levels",
                      adaptive_levels,
                      "How many levels adaptation may add to the global "
                      "refinements.",
                      Integer(0, max_refinements));
    prm.add_parameter("Phase-field threshold",
                      phase_field_threshold,
                      "Adaptation refines cells where the phase field falls "
                      "below this; dimensionless.",
                      Double(0., 1.));
    prm.add_parameter("Refinement margin",
                      refinement_margin,
                      "Cells within this distance of damaged nodes are refined "
                      "with them, so that a running crack does not meet coarse "
                      "cells at once. Unit: Model/Length scale.",
                      Double(0.));
    prm.add_parameter("Refinement lookahead",
                      refinement_lookahead,
                      "Where the tip of a crack meets coarse cells, those up "
                      "to this distance straight ahead of it are refined too, "
                      "within the margin. 0: off. Ignored in 3-d, where the "
                      "margin has to do. Unit: Model/Length scale.",
                      Double(0.));
    prm.add_parameter("Coarsening margin",
                      coarsening_margin,
                      "Whenever adaptation refines, intact cells (phi = 1) "
                      "that it refined before and that are farther than this "
                      "from damaged nodes become coarse again. Negative: they "
                      "stay. Unit: Model/Length scale.",
                      Double(-1.));
    prm.leave_subsection();
  }



  template <int dim>
  void
  MeshParameters<dim>::check(
    const std::optional<dealii::BoundingBox<dim>> &extent,
    const std::vector<std::string>                &names) const
  {
    regions.check(global_refinements, extent, names);
    if (adaptation == "none" && adaptive_levels > 0)
      throw InputError("Mesh/Adaptive levels is " +
                       std::to_string(adaptive_levels) +
                       "; it must be 0 when Mesh/Adaptation is 'none'.");
  }



  template struct MeshParameters<2>;
  template struct MeshParameters<3>;
} // namespace MixedCracks
