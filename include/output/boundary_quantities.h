// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_boundary_quantities_h
#define mixed_cracks_output_boundary_quantities_h

#include <deal.II/base/tensor.h>

#include <discretization/constraints.h>
#include <discretization/fields.h>

#include <utility>

namespace MixedCracks
{
  /// Forces and displacements on the boundary.
  template <int dim>
  class BoundaryQuantities
  {
  public:
    /// @p force_boundary: where the reaction is summed; none: at the
    /// prescribed points that move, or at all points where none does.
    BoundaryQuantities(const Fields<dim>      &fields,
                       const Constraints<dim> &constraints,
                       BoundaryIds             force_boundary)
      : fields(fields)
      , constraints(constraints)
      , boundary(std::move(force_boundary))
    {}

    /// To be called when the mesh changed.
    void reinit();

    /// Consistent reaction: the residual summed over the nodes of the force
    /// boundary, N per mm thickness. Signs by the outward normal of the
    /// boundary (of the axis nearest to it): positive in tension. At points as
    /// it acts on the body, in the directions of the axes.
    dealii::Tensor<1, dim> force(const LinearAlgebra::Vector &reaction) const;

    /// Mean prescribed displacement magnitude of the boundary or point that
    /// is moved most, mm.
    double displacement(double time) const;

  private:
    double largest_point_displacement(double time) const;

    void reinit_at_boundary();

    void reinit_at_points();

    const Fields<dim>      &fields;
    const Constraints<dim> &constraints;
    const BoundaryIds       boundary;

    std::array<dealii::IndexSet, dim> owned_dofs;
    double                            sign = 1.;
  };
} // namespace MixedCracks

#endif
