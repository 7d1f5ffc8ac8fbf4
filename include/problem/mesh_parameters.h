// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_mesh_parameters_h
#define mixed_cracks_problem_mesh_parameters_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <optional>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A box in which cells are refined beyond the rest; mm.
  template <int dim>
  struct RefinedBox
  {
    dealii::Point<dim> lower;
    dealii::Point<dim> upper;
    unsigned int       levels;
  };

  /// Subsection "Mesh": how the coarse mesh of the geometry is refined.
  template <int dim>
  struct MeshParameters
  {
    unsigned int global_refinements = 0;
    std::string  boxes;
    std::string  adaptation      = "none";
    unsigned int adaptive_levels = 0;
    /// rho of [HWW15]: cells with a smaller phase field are refined.
    double phase_field_threshold = 0.7;
    /// Cells this near to damaged ones are refined with them; in length
    /// scales.
    double refinement_margin = 3.;

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError, also for a refined box that misses the domain, of
    /// @p extent (mm; none: not known yet).
    void
    check(const std::optional<dealii::BoundingBox<dim>> &extent = {}) const;

    /// Level of the finest cells that adaptation makes.
    unsigned int
    finest_adaptive_level() const
    {
      return global_refinements + adaptive_levels;
    }

    /// The entry "Refined boxes". Throws InputError.
    std::vector<RefinedBox<dim>> refined_boxes() const;
  };
} // namespace MixedCracks

#endif
