// SPDX-License-Identifier: GPL-2.0-or-later
// The linear displacements on a mesh of quadratic ones, coarse space V_1 of the
// two-level preconditioner in V_2,
//
//   V_1 = { u continuous, linear (bilinear, trilinear) on each cell },  in V_2,
//   u_i = sum_v L_v(xi_i) U_v        for node i of a cell, v its vertices,
//
// L_v(xi_i) = 1 at a vertex, 1/2 in the middle of an edge, 1/4 of a face, 1/8
// of a hexahedron. Its unknowns U_v are the vertices that do not hang; a
// hanging vertex is U_h = sum of c_hv U_v with the constraints of linear
// elements, which are those of the phase field. Supports: U_v = 0 where u is
// held at the vertex.
//
//   P_(iv) = L_v(xi_i), with hanging U_h replaced by the U_v they depend on
//
// has the elastic dofs in its rows and the coarse ones in its columns. A row is
// the same from whichever cell it is computed, as u is continuous.

#include <base/compat.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <discretization/linear_displacements.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    constexpr double negligible = 1e-12;
  }



  template <int dim>
  void
  LinearDisplacements<dim>::reinit(const Fields<dim>      &fields,
                                   const Constraints<dim> &constraints)
  {
    const FiniteElement<dim> &element = fields.elastic.get_fe();
    vertex_dofs.clear();
    for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
      for (unsigned int d = 0; d < dim; ++d)
        vertex_dofs.push_back(element.component_to_system_index(d, v));
    number(fields);
    make_constraints(fields, constraints);
    make_interpolation(fields, constraints);
  }



  template <int dim>
  void
  LinearDisplacements<dim>::get_elastic_dofs(const Cell &cell,
                                             Indices    &dofs) const
  {
    Indices all(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(all);
    dofs.clear();
    for (const unsigned int i : vertex_dofs)
      dofs.push_back(all[i]);
  }



  template <int dim>
  void
  LinearDisplacements<dim>::get_dofs(const Cell &cell, Indices &dofs) const
  {
    get_elastic_dofs(cell, dofs);
    for (types::global_dof_index &dof : dofs)
      dof = coarse_number(dof);
  }



  // Owned ones after those of the ranks before; others by way of a vector with
  // ghosts, whose doubles hold numbers up to 2^53.
  template <int dim>
  void
  LinearDisplacements<dim>::number(const Fields<dim> &fields)
  {
    const IndexSet &owned = fields.elastic_dofs.owned;
    relevant              = fields.elastic_dofs.relevant;
    is_at_vertex.assign(owned.n_elements(), false);
    Indices elastic;
    for (const auto &cell : fields.elastic.active_cell_iterators())
      if (!cell->is_artificial())
      {
        get_elastic_dofs(cell, elastic);
        for (const types::global_dof_index dof : elastic)
          if (owned.is_element(dof))
            is_at_vertex[owned.index_within_set(dof)] = true;
      }
    const types::global_dof_index n_owned =
      std::count(is_at_vertex.begin(), is_at_vertex.end(), true);
    const std::vector<types::global_dof_index> of_ranks =
      Utilities::MPI::all_gather(fields.communicator(), n_owned);
    const unsigned int rank =
      Utilities::MPI::this_mpi_process(fields.communicator());
    const auto first = std::accumulate(
      of_ranks.begin(), of_ranks.begin() + rank, types::global_dof_index(0));
    const auto n_all =
      std::accumulate(of_ranks.begin() + rank, of_ranks.end(), first);

    // 0: not a vertex
    LinearAlgebra::Vector own = fields.owned_vector(fields.elastic_dofs);
    for (std::size_t i = 0, next = first; i < is_at_vertex.size(); ++i)
      if (is_at_vertex[i])
        own.begin()[i] = 1. + next++;
    LinearAlgebra::Vector all = fields.ghosted_vector(fields.elastic_dofs);
    all                       = own;
    numbers.assign(relevant.n_elements(), dealii::numbers::invalid_dof_index);
    coarse_dofs.owned.clear();
    coarse_dofs.owned.set_size(n_all);
    coarse_dofs.owned.add_range(first, first + n_owned);
    coarse_dofs.relevant = coarse_dofs.owned;
    const double *value  = all.begin(); // in the order of the relevant ones
    for (types::global_dof_index &number : numbers)
      if (const double found = *value++; found > 0.)
      {
        number = static_cast<types::global_dof_index>(found) - 1;
        coarse_dofs.relevant.add_index(number);
      }
    coarse_dofs.relevant.compress();
  }



  // The phase field is linear on the same mesh: its hanging nodes are those
  // of linear displacements.
  template <int dim>
  void
  LinearDisplacements<dim>::make_constraints(
    const Fields<dim>      &fields,
    const Constraints<dim> &all_constraints)
  {
    // first elastic dof of the vertex of a dof of the phase field; the
    // components follow each other
    const IndexSet &vertices = fields.phase_field_dofs.relevant;
    std::vector<std::array<types::global_dof_index, dim>> of_vertex(
      vertices.n_elements());
    std::vector<bool> is_known(of_vertex.size(), false);
    Indices elastic, phase_field(GeometryInfo<dim>::vertices_per_cell);
    auto    phase_field_cell = fields.phase_field.begin_active();
    for (const auto &cell : fields.elastic.active_cell_iterators())
    {
      if (!cell->is_artificial())
      {
        get_elastic_dofs(cell, elastic);
        phase_field_cell->get_dof_indices(phase_field);
        for (unsigned int v = 0; v < phase_field.size(); ++v)
        {
          const auto at = vertices.index_within_set(phase_field[v]);
          is_known[at]  = true;
          for (unsigned int d = 0; d < dim; ++d)
            of_vertex[at][d] = elastic[dim * v + d];
        }
      }
      ++phase_field_cell;
    }

    Compat::reinit(linear_constraints, coarse_dofs.owned, coarse_dofs.relevant);
    const auto &hanging    = all_constraints.phase_field_hanging_nodes();
    const auto &prescribed = all_constraints.elastic_corrections();
    for (std::size_t at = 0; at < of_vertex.size(); ++at)
      for (unsigned int d = 0; d < dim && is_known[at]; ++d)
      {
        const auto elastic_dof = of_vertex[at][d];
        if (const auto *entries =
              hanging.get_constraint_entries(vertices.nth_index_in_set(at)))
        {
          const auto number = coarse_number(elastic_dof);
          linear_constraints.add_line(number);
          for (const auto &[other, weight] : *entries)
            linear_constraints.add_entry(
              number,
              coarse_number(of_vertex[vertices.index_within_set(other)][d]),
              weight);
        }
        else if (prescribed.is_constrained(elastic_dof))
          linear_constraints.add_line(coarse_number(elastic_dof));
      }
    linear_constraints.close();
  }



  // Row by row, in the order in which cells come to them; then as a matrix, in
  // which each row takes what it needs and no more.
  template <int dim>
  void
  LinearDisplacements<dim>::make_interpolation(
    const Fields<dim>      &fields,
    const Constraints<dim> &all_constraints)
  {
    const FiniteElement<dim> &element = fields.elastic.get_fe();
    const IndexSet           &owned   = fields.elastic_dofs.owned;
    const auto &constrained           = all_constraints.elastic_corrections();
    struct Row
    {
      std::size_t first  = 0;
      int         length = 0;
    };
    std::vector<Row>                          rows(owned.n_elements());
    std::vector<int>                          columns;
    std::vector<double>                       weights;
    std::map<types::global_dof_index, double> row;
    Indices all(element.n_dofs_per_cell()), vertices;
    for (const auto &cell : fields.elastic.active_cell_iterators())
    {
      if (cell->is_artificial())
        continue;
      cell->get_dof_indices(all);
      get_dofs(cell, vertices);
      for (unsigned int i = 0; i < all.size(); ++i)
      {
        const unsigned int d = element.system_to_component_index(i).first;
        if (d >= dim || !owned.is_element(all[i]) ||
            constrained.is_constrained(all[i]))
          continue;
        Row &place = rows[owned.index_within_set(all[i])];
        if (place.length > 0)
          continue;
        row.clear();
        for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
        {
          const double share = GeometryInfo<dim>::d_linear_shape_function(
            element.unit_support_point(i), v);
          const auto vertex = vertices[dim * v + d];
          if (share < negligible)
            continue;
          if (!linear_constraints.is_constrained(vertex))
            row[vertex] += share;
          else if (const auto *entries =
                     linear_constraints.get_constraint_entries(vertex))
            for (const auto &[other, weight] : *entries)
              row[other] += share * weight;
        }
        place = {columns.size(), static_cast<int>(row.size())};
        for (const auto &[vertex, weight] : row)
        {
          columns.push_back(vertex);
          weights.push_back(weight);
        }
      }
    }

    std::vector<int> lengths;
    for (const Row &place : rows)
      lengths.push_back(place.length);
    const Epetra_Map row_map =
      owned.make_trilinos_map(fields.communicator(), false);
    const Epetra_Map column_map =
      coarse_dofs.owned.make_trilinos_map(fields.communicator(), false);
    interpolation_matrix = std::make_unique<Epetra_CrsMatrix>(
      Copy, row_map, lengths.data(), /*StaticProfile=*/true);
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (rows[i].length > 0)
        interpolation_matrix->InsertGlobalValues(
          static_cast<int>(owned.nth_index_in_set(i)),
          rows[i].length,
          &weights[rows[i].first],
          &columns[rows[i].first]);
    interpolation_matrix->FillComplete(column_map, row_map);
    interpolation_matrix->OptimizeStorage();
  }



  template class LinearDisplacements<2>;
  template class LinearDisplacements<3>;
} // namespace MixedCracks
