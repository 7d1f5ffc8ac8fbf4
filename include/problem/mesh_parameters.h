// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_mesh_parameters_h
#define mixed_cracks_problem_mesh_parameters_h

#include <problem/refined_regions.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// Subsection "Mesh": how the coarse mesh of the geometry is refined.
  template <int dim>
  struct MeshParameters
  {
    unsigned int        global_refinements = 0;
    RefinedRegions<dim> regions;
    std::string         adaptation      = "none";
    unsigned int        adaptive_levels = 0;
    /// rho of [HWW15]: cells with a smaller phase field are refined.
    double phase_field_threshold = 0.7;
    /// Cells this near to damaged ones are refined with them; in length
    /// scales.
    double refinement_margin = 3.;
    /// The same straight ahead of a tip, in length scales.
    double refinement_lookahead = 16.;
    /// How near to damage refined cells stay; in length scales.
    double coarsening_margin = -1.;

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError, see RefinedRegions::check().
    void check(const std::optional<dealii::BoundingBox<dim>> &extent,
               const std::vector<std::string>                &names) const;

    /// Level of the finest cells that adaptation makes.
    unsigned int
    finest_adaptive_level() const
    {
      return global_refinements + adaptive_levels;
    }
  };
} // namespace MixedCracks

#endif
