// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_linear_displacements_h
#define mixed_cracks_discretization_linear_displacements_h

#include <discretization/constraints.h>

#include <Epetra_CrsMatrix.h>

#include <memory>

namespace MixedCracks
{
  /// Among quadratic displacements those that are (multi)linear on each cell:
  /// the coarse space of multigrid. Their unknowns are the displacements of
  /// the vertices, in the order of the elastic dofs but numbered without gaps.
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

    /// Numbers of coarse unknowns.
    const DofSets &
    dofs() const
    {
      return coarse_dofs;
    }

    /// Of a cell of the elastic fields the unknowns of its vertices, component
    /// by component for each vertex.
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

    /// From the displacements of vertices to the elastic dofs. Rows of
    /// constrained dofs and of pressures are empty.
    const Epetra_CrsMatrix &
    interpolation() const
    {
      return *interpolation_matrix;
    }

  private:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    /// Elastic dofs of the vertices of a cell.
    void get_elastic_dofs(const Cell &cell, Indices &dofs) const;

    void number(const Fields<dim> &fields);

    dealii::types::global_dof_index
    coarse_number(const dealii::types::global_dof_index elastic) const
    {
      return numbers[relevant.index_within_set(elastic)];
    }

    void make_constraints(const Fields<dim>      &fields,
                          const Constraints<dim> &all_constraints);

    void make_interpolation(const Fields<dim>      &fields,
                            const Constraints<dim> &all_constraints);

    std::vector<unsigned int>         vertex_dofs; // local
    std::vector<bool>                 is_at_vertex;
    dealii::IndexSet                  relevant; // elastic dofs ...
    Indices                           numbers;  // ... and what they are here
    DofSets                           coarse_dofs;
    dealii::AffineConstraints<double> linear_constraints;
    std::unique_ptr<Epetra_CrsMatrix> interpolation_matrix;
  };
} // namespace MixedCracks

#endif
