// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_point_forces_h
#define mixed_cracks_assembly_point_forces_h

#include <base/linear_algebra.h>

#include <deal.II/base/function.h>
#include <deal.II/lac/affine_constraints.h>

#include <discretization/fields.h>
#include <discretization/vertex_dofs.h>

#include <memory>
#include <utility>
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
    /// a vertex of a set: it may hang, and be two on a slit, each with the
    /// force
    bool of_set = false;
  };

  /// Forces on single vertices, dead loads. That on a hanging vertex goes to
  /// the nodes it follows, with its weights.
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
    /// point that is no vertex, and for a single one that hangs or is two on a
    /// slit. Collective.
    void reinit(const Fields<dim>                       &fields,
                const dealii::AffineConstraints<double> &hanging_nodes);

    /// Add the nodal forces at @p time, N (2-d: N/mm), to @p nodal, without
    /// ghosts. Throws InputError on all ranks for a value that is not finite.
    /// Collective.
    void add(double time, LinearAlgebra::Vector &nodal) const;

  private:
    using WeightedDofs =
      std::vector<std::pair<dealii::types::global_dof_index, double>>;

    void require_one_vertex_each(const std::vector<VertexDofs> &owned,
                                 MPI_Comm communicator) const;

    std::vector<PointForce<dim>> forces;
    double                       thickness = 1.;
    // of each force those of its vertices that this rank owns
    std::vector<WeightedDofs> dofs;
  };
} // namespace MixedCracks

#endif
