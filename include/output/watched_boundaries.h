// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_watched_boundaries_h
#define mixed_cracks_output_watched_boundaries_h

#include <discretization/constraints.h>
#include <discretization/fields.h>
#include <discretization/state.h>

#include <output/watched_boundaries_parameters.h>

#include <functional>
#include <utility>

namespace MixedCracks
{
  /// Force, moment and mean displacement of boundaries that are watched.
  template <int dim>
  class WatchedBoundaries
  {
  public:
    /// Nodal forces (N/mm, per mm thickness in 2-d) of the loads on a boundary.
    using Loads =
      std::function<LinearAlgebra::Vector(dealii::types::boundary_id,
                                          const State &)>;

    /// @p thickness: mm, 1 in 3-d. @p finite_strain: moments have the arms of
    /// the deformed body.
    WatchedBoundaries(const Fields<dim>                &fields,
                      const Constraints<dim>           &constraints,
                      std::vector<WatchedBoundary<dim>> boundaries,
                      const double                      thickness,
                      const bool                        finite_strain)
      : fields(fields)
      , constraints(constraints)
      , boundaries(std::move(boundaries))
      , thickness(thickness)
      , finite_strain(finite_strain)
    {}

    /// Where the loads are asked for.
    void
    set_loads(Loads new_loads)
    {
      loads = std::move(new_loads);
    }

    /// To be called when the mesh changed.
    void reinit();

    /// In the order of column_names(); the same on all ranks. Collective.
    std::vector<double> evaluate(const State &state) const;

    std::vector<std::string> column_names() const;

  private:
    /// A node of a boundary that this rank owns.
    struct Node
    {
      std::array<dealii::types::global_dof_index, dim> dofs;
      /// whether a reaction there is one of this boundary
      std::array<bool, dim> is_held;
      dealii::Point<dim>    position;
    };

    std::vector<double> resultant(std::size_t  boundary,
                                  const State &state) const;

    std::vector<double> mean_displacement(std::size_t  boundary,
                                          const State &state) const;

    std::vector<Node> nodes_of(const BoundaryIds &boundary) const;

    std::array<dealii::IndexSet, dim>
    held_by_others(const BoundaryIds &boundary) const;

    const Fields<dim>                      &fields;
    const Constraints<dim>                 &constraints;
    const std::vector<WatchedBoundary<dim>> boundaries;
    const double                            thickness;
    const bool                              finite_strain;
    Loads                                   loads;
    std::vector<std::vector<Node>>          nodes; // by boundary
  };
} // namespace MixedCracks

#endif
