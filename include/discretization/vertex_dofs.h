// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_vertex_dofs_h
#define mixed_cracks_discretization_vertex_dofs_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// A component of a field at a vertex of the mesh.
  template <int dim>
  struct VertexComponent
  {
    dealii::Point<dim> point; ///< mm
    unsigned int       component;
    bool               may_hang = false; ///< then it has no dofs
  };

  /// Dofs of one place: one, or on a slit one for each face of it.
  using VertexDofs = std::vector<dealii::types::global_dof_index>;

  /// The dofs of each place, ascending, as far as this rank knows them: those
  /// of cells that it owns and of ghosts. Throws InputError on all ranks,
  /// beginning with the name of the entry, for a point that is no vertex, or
  /// one that @p constraints constrains (a hanging one). Collective.
  template <int dim>
  std::vector<VertexDofs>
  dofs_at_vertices(const dealii::DoFHandler<dim>           &dofs,
                   const dealii::AffineConstraints<double> &constraints,
                   const std::vector<VertexComponent<dim>> &places,
                   const std::string                       &entry);

  /// Those of @p places that are in @p owned, the dofs of this rank.
  std::vector<VertexDofs> owned_of(const std::vector<VertexDofs> &places,
                                   const dealii::IndexSet        &owned);
} // namespace MixedCracks

#endif
