// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_phase_field_points_h
#define mixed_cracks_simulation_phase_field_points_h

#include <discretization/constraints.h>
#include <discretization/vertex_dofs.h>

#include <problem/boundary_conditions.h>

#include <map>

namespace MixedCracks
{
  /// The phase field that is prescribed at vertices.
  template <int dim>
  class PhaseFieldPoints
  {
  public:
    explicit PhaseFieldPoints(const BoundaryConditions<dim> &conditions)
      : entries(conditions.point_phase_fields())
    {}

    /// To be called when the mesh changed. Throws InputError on all ranks for a
    /// point that is no vertex. Collective.
    void reinit(const Fields<dim> &fields, const Constraints<dim> &constraints);

    /// Add the values at @p time of the dofs that this rank owns, where none is
    /// given. Throws InputError on all ranks for a value that is not within 0
    /// and 1. Collective.
    void add(double                                             time,
             std::map<dealii::types::global_dof_index, double> &values) const;

  private:
    std::vector<PointEntry<dim>> entries;
    std::vector<VertexDofs>      owned_dofs;
    MPI_Comm                     communicator = MPI_COMM_SELF;
  };
} // namespace MixedCracks

#endif
