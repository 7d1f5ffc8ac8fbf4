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
// has the numbers of the elastic dofs in rows and columns. A row is the same
// from whichever cell it is computed, as u is continuous.

#include <base/compat.h>

#include <deal.II/base/geometry_info.h>

#include <discretization/linear_displacements.h>

#include <map>

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
    make_constraints(fields, constraints);
    make_interpolation(fields, constraints);
  }



  template <int dim>
  void
  LinearDisplacements<dim>::get_dofs(
    const typename DoFHandler<dim>::active_cell_iterator &cell,
    Indices                                              &dofs) const
  {
    Indices all(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(all);
    dofs.clear();
    for (const unsigned int i : vertex_dofs)
      dofs.push_back(all[i]);
  }



  // The phase field is linear on the same mesh: its hanging nodes are those
  // of linear displacements.
  template <int dim>
  void
  LinearDisplacements<dim>::make_constraints(
    const Fields<dim>      &fields,
    const Constraints<dim> &all_constraints)
  {
    const IndexSet &owned = fields.elastic_dofs.owned;
    is_at_vertex.assign(owned.n_elements(), false);
    // first elastic dof of the vertex of a dof of the phase field; the
    // components follow each other
    std::map<types::global_dof_index, std::array<types::global_dof_index, dim>>
            of_phase_field;
    Indices elastic, phase_field(GeometryInfo<dim>::vertices_per_cell);
    auto    phase_field_cell = fields.phase_field.begin_active();
    for (const auto &cell : fields.elastic.active_cell_iterators())
    {
      if (!cell->is_artificial())
      {
        get_dofs(cell, elastic);
        phase_field_cell->get_dof_indices(phase_field);
        for (unsigned int v = 0; v < phase_field.size(); ++v)
          for (unsigned int d = 0; d < dim; ++d)
          {
            const auto dof                    = elastic[dim * v + d];
            of_phase_field[phase_field[v]][d] = dof;
            if (owned.is_element(dof))
              is_at_vertex[owned.index_within_set(dof)] = true;
          }
      }
      ++phase_field_cell;
    }

    Compat::reinit(linear_constraints, owned, fields.elastic_dofs.relevant);
    const auto &hanging    = all_constraints.phase_field_hanging_nodes();
    const auto &prescribed = all_constraints.elastic_corrections();
    for (const auto &[vertex, dofs] : of_phase_field)
      for (unsigned int d = 0; d < dim; ++d)
        if (const auto *entries = hanging.get_constraint_entries(vertex))
        {
          linear_constraints.add_line(dofs[d]);
          for (const auto &[other, weight] : *entries)
            linear_constraints.add_entry(
              dofs[d], of_phase_field.at(other)[d], weight);
        }
        else if (prescribed.is_constrained(dofs[d]))
          linear_constraints.add_line(dofs[d]);
    linear_constraints.close();
  }



  template <int dim>
  void
  LinearDisplacements<dim>::make_interpolation(
    const Fields<dim>      &fields,
    const Constraints<dim> &all_constraints)
  {
    const FiniteElement<dim> &element = fields.elastic.get_fe();
    const IndexSet           &owned   = fields.elastic_dofs.owned;
    const auto &constrained           = all_constraints.elastic_corrections();
    std::vector<std::map<types::global_dof_index, double>> rows(
      owned.n_elements());
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
        auto &row = rows[owned.index_within_set(all[i])];
        if (!row.empty())
          continue;
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
      }
    }

    LinearAlgebra::SparsityPattern pattern(
      owned, owned, fields.communicator(), 1u << dim);
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const auto &entry : rows[i])
        pattern.add(owned.nth_index_in_set(i), entry.first);
    pattern.compress();
    interpolation_matrix.reinit(pattern);
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const auto &[vertex, weight] : rows[i])
        interpolation_matrix.set(owned.nth_index_in_set(i), vertex, weight);
    interpolation_matrix.compress(VectorOperation::insert);
  }



  template class LinearDisplacements<2>;
  template class LinearDisplacements<3>;
} // namespace MixedCracks
