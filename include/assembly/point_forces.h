// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_point_forces_h
#define mixed_cracks_assembly_point_forces_h

#include <base/linear_algebra.h>

#include <deal.II/base/function.h>
#include <deal.II/lac/affine_constraints.h>

#include <discretization/fields.h>
#include <discretization/vertex_dofs.h>

#include <memory>
#include <vector>

namespace MixedCracks
{
  /// One component of a force at a vertex.
  template <int dim>
  struct PointForce
  {
    dealii::Point<dim> point; ///< mm
    unsigned int       component;
    /// N, on the whole body; of which `component` is asked
    std::shared_ptr<dealii::Function<dim>> value;
  };

  /// Forces on single vertices, dead loads.
  template <int dim>
  class PointForces
  {
  public:
    PointForces() = default;

    /// @p thickness: what forces are divided by to get those per mm of
    /// thickness; mm in 2-d, 1 in 3-d.
    PointForces(std::vector<PointForce<dim>> forces, double thickness);

    bool
    empty() const
    {
      return forces.empty();
    }

    /// To be called when the mesh changed. Throws InputError on all ranks for a
    /// point that is no vertex, or is two on a slit. Collective.
    void reinit(const Fields<dim>                       &fields,
                const dealii::AffineConstraints<double> &hanging_nodes);

    /// Add the nodal forces at @p time, N (2-d: N/mm), to @p nodal, without
    /// ghosts. Throws InputError on all ranks for a value that is not finite.
    /// Collective.
    void add(double time, LinearAlgebra::Vector &nodal) const;

  private:
    std::vector<PointForce<dim>> forces;
    double                       thickness = 1.;
    std::vector<VertexDofs>      owned_dofs; // none or one for each force
  };
} // namespace MixedCracks

#endif
