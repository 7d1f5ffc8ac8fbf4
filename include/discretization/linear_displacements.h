// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_linear_displacements_h
#define mixed_cracks_discretization_linear_displacements_h

#include <discretization/constraints.h>

namespace MixedCracks
{
  /// Among quadratic displacements those that are (multi)linear on each cell:
  /// the coarse space of multigrid. Their unknowns are the displacements of
  /// the vertices, in the numbering of the elastic fields, so that a matrix
  /// of theirs has empty rows elsewhere.
  template <int dim>
  class LinearDisplacements
  {
  public:
    using Indices = std::vector<dealii::types::global_dof_index>;

    /// To be called when the mesh changed. Collective.
    void reinit(const Fields<dim> &fields, const Constraints<dim> &constraints);

    /// One entry per owned elastic dof: whether it belongs to a vertex.
    const std::vector<bool> &
    at_vertices() const
    {
      return is_at_vertex;
    }

    /// Of a cell of the elastic fields the dofs of its vertices, component by
    /// component for each vertex.
    void
    get_dofs(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
             Indices &dofs) const;

    /// Linear between the vertices at hanging ones, 0 where the displacement
    /// is prescribed.
    const dealii::AffineConstraints<double> &
    constraints() const
    {
      return linear_constraints;
    }

    /// From the displacements of vertices to those of all nodes. Rows of
    /// constrained dofs and of pressures are empty.
    const LinearAlgebra::SparseMatrix &
    interpolation() const
    {
      return interpolation_matrix;
    }

  private:
    void make_constraints(const Fields<dim>      &fields,
                          const Constraints<dim> &all_constraints);

    void make_interpolation(const Fields<dim>      &fields,
                            const Constraints<dim> &all_constraints);

    std::vector<unsigned int>         vertex_dofs; // local
    std::vector<bool>                 is_at_vertex;
    dealii::AffineConstraints<double> linear_constraints;
    LinearAlgebra::SparseMatrix       interpolation_matrix;
  };
} // namespace MixedCracks

#endif
