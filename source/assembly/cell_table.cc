// SPDX-License-Identifier: GPL-2.0-or-later
// From cells to vectors and back, by position instead of by global number:
//
//   read   local_i = v[ position(cell, i) ]
//   add    s[ position(cell, i) ] += local_i
//
// with s a vector that has room for the dofs of other ranks, which end_sum()
// sends to their owners and adds up there. Cells with constrained dofs (hanging
// nodes, a few) go through AffineConstraints instead, which needs global
// numbers.

#include <assembly/cell_table.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  CellDofs<dim>::CellDofs(const DoFHandler<dim> &handler, const DofSets &sets)
    : dofs_per_cell(handler.get_fe().n_dofs_per_cell())
    , sums(sets.owned, sets.relevant, handler.get_communicator())
    , indices(dofs_per_cell)
  {
    // vectors with ghosts store the relevant dofs in ascending order
    global.assign(sets.relevant.begin(), sets.relevant.end());
    for (const auto &cell : handler.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(indices);
        for (const auto index : indices)
          positions.push_back(sets.relevant.index_within_set(index));
      }
    const LinearAlgebra::Vector owned(sets.owned, handler.get_communicator());
    exporter = std::make_unique<Epetra_Export>(sums.trilinos_vector().Map(),
                                               owned.trilinos_vector().Map());
  }



  template <int dim>
  void
  CellDofs<dim>::read(const unsigned int           cell,
                      const LinearAlgebra::Vector &ghosted,
                      dealii::Vector<double>      &local) const
  {
    const double *const       values = ghosted.begin();
    const unsigned int *const first  = &positions[cell * dofs_per_cell];
    for (unsigned int i = 0; i < dofs_per_cell; ++i)
      local(i) = values[first[i]];
  }



  template <int dim>
  void
  CellDofs<dim>::global_indices(
    const unsigned int                    cell,
    std::vector<types::global_dof_index> &result) const
  {
    for (unsigned int i = 0; i < dofs_per_cell; ++i)
      result[i] = global[positions[cell * dofs_per_cell + i]];
  }



  template <int dim>
  void
  CellDofs<dim>::begin_sum(LinearAlgebra::Vector &result)
  {
    result = 0.;
    // deal.II does not write to vectors with ghosts
    sums.trilinos_vector().PutScalar(0.);
  }



  template <int dim>
  bool
  CellDofs<dim>::is_constrained(const unsigned int cell,
                                const Constraints &constraints) const
  {
    for (unsigned int i = 0; i < dofs_per_cell; ++i)
      if (constraints.is_constrained(
            global[positions[cell * dofs_per_cell + i]]))
        return true;
    return false;
  }



  template <int dim>
  void
  CellDofs<dim>::add(const unsigned int            cell,
                     const dealii::Vector<double> &local,
                     const Constraints            &constraints,
                     LinearAlgebra::Vector        &result)
  {
    if (is_constrained(cell, constraints))
    {
      global_indices(cell, indices);
      constraints.distribute_local_to_global(local, indices, result);
      return;
    }
    double *const             values = sums.trilinos_vector()[0];
    const unsigned int *const first  = &positions[cell * dofs_per_cell];
    for (unsigned int i = 0; i < dofs_per_cell; ++i)
      values[first[i]] += local(i);
  }



  template <int dim>
  void
  CellDofs<dim>::end_sum(LinearAlgebra::Vector &result)
  {
    result.compress(VectorOperation::add);
    // a vector of its own: the export replaces what its target holds
    LinearAlgebra::Vector shared(result);
    const int             error =
      shared.trilinos_vector().Export(sums.trilinos_vector(), *exporter, Add);
    AssertThrow(error == 0, ExcMessage("the sum over the ranks failed"));
    result.add(1., shared);
  }



  template <int dim>
  CellTable<dim>::CellTable(const Fields<dim> &fields)
    : elastic(fields.elastic, fields.elastic_dofs)
    , phase_field(fields.phase_field, fields.phase_field_dofs)
  {
    GeometryEvaluator<dim> geometry_of(fields.mapping, fields.quadrature);
    for (const auto &cell :
         fields.elastic.get_triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
      {
        geometries.push_back(geometry_of(cell));
        active_indices.push_back(cell->active_cell_index());
        materials.push_back(cell->material_id());
      }
  }



  template class CellDofs<2>;
  template class CellDofs<3>;
  template class CellTable<2>;
  template class CellTable<3>;
} // namespace MixedCracks
