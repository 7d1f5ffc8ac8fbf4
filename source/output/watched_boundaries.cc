// SPDX-License-Identifier: GPL-2.0-or-later
// Of a boundary B with the nodes i (position X_i, displacement u_i), t the
// thickness (1 in 3-d), r the reaction of supports (State::reaction) and f the
// nodal forces of the loads on B,
//
//   F = t sum_i (r_i + f_i),                      N
//   M = t sum_i (x_i - c) x (r_i + f_i),          N mm
//   u = (integral over B of u) / |B|,             mm
//
// x_i = X_i at small, X_i + u_i at finite strain. As the shape functions add up
// to 1 and interpolate X, F and M of a traction are its integrals without an
// error of their own. A reaction at a node where B meets another boundary that
// holds its component is of B where B holds it as well: where no such nodes are
// shared, F adds up to 0 over all boundaries, with body forces.
//
// The nodes of B are those of its faces. A support at a hanging node on B (3-d)
// has its reaction at the nodes it follows, on B as well.

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_values.h>

#include <base/ranges.h>

#include <output/watched_boundaries.h>

#include <map>
#include <set>

namespace MixedCracks
{
  using namespace dealii;



  template <int dim>
  std::vector<std::string>
  WatchedBoundaries<dim>::column_names() const
  {
    std::vector<std::string> result;
    for (const WatchedBoundary<dim> &boundary : boundaries)
      for (const std::string &name : boundary.column_names())
        result.push_back(name);
    return result;
  }



  // The dofs of components that this boundary does not hold, but others do.
  template <int dim>
  std::array<IndexSet, dim>
  WatchedBoundaries<dim>::held_by_others(const BoundaryIds &boundary) const
  {
    std::array<IndexSet, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
    {
      std::set<types::boundary_id> holders;
      for (const auto &entry : constraints.prescribed_components())
        if (entry.component == d)
          holders.insert(entry.boundary.begin(), entry.boundary.end());
      result[d] = IndexSet(fields.elastic.n_dofs());
      std::vector<bool> mask(fields.elastic.get_fe().n_components(), false);
      mask[d] = true;
      if (!holders.empty() && !any_of(boundary, [&](const auto id) {
            return holders.count(id) > 0;
          }))
        result[d] = DoFTools::extract_boundary_dofs(
          fields.elastic, ComponentMask(mask), holders);
    }
    return result;
  }



  // Nodes of a face that is not on this rank may be owned by it: faces of ghost
  // cells are looked at, too.
  template <int dim>
  std::vector<typename WatchedBoundaries<dim>::Node>
  WatchedBoundaries<dim>::nodes_of(const BoundaryIds &boundary) const
  {
    const FiniteElement<dim>               &element = fields.elastic.get_fe();
    const FiniteElement<dim>               &scalar  = element.base_element(0);
    FEValues<dim>                           values(fields.mapping,
                         scalar,
                         scalar.get_unit_support_points(),
                         update_quadrature_points);
    std::vector<types::global_dof_index>    indices(element.n_dofs_per_cell());
    const std::array<IndexSet, dim>         others = held_by_others(boundary);
    std::map<types::global_dof_index, Node> found; // by the first dof
    for (const auto &cell : fields.elastic.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
      {
        if (cell->is_artificial() || !cell->face(f)->at_boundary() ||
            !boundary.contains(cell->face(f)->boundary_id()))
          continue;
        values.reinit(typename Triangulation<dim>::active_cell_iterator(cell));
        cell->get_dof_indices(indices);
        for (unsigned int k = 0; k < scalar.n_dofs_per_cell(); ++k)
          if (scalar.has_support_on_face(k, f))
          {
            Node node;
            for (unsigned int d = 0; d < dim; ++d)
            {
              node.dofs[d] = indices[element.component_to_system_index(d, k)];
              node.is_held[d] = !others[d].is_element(node.dofs[d]);
            }
            node.position = values.quadrature_point(k);
            if (fields.elastic_dofs.owned.is_element(node.dofs[0]))
              found[node.dofs[0]] = node;
          }
      }
    std::vector<Node> result;
    for (const auto &entry : found)
      result.push_back(entry.second);
    return result;
  }



  template <int dim>
  void
  WatchedBoundaries<dim>::reinit()
  {
    nodes.clear();
    for (const WatchedBoundary<dim> &boundary : boundaries)
      nodes.push_back(nodes_of(boundary.ids));
  }



  // force, and the moment if it is asked for
  template <int dim>
  std::vector<double>
  WatchedBoundaries<dim>::resultant(const std::size_t boundary,
                                    const State      &state) const
  {
    LinearAlgebra::Vector forces = fields.owned_vector(fields.elastic_dofs);
    if (loads)
      for (const types::boundary_id id : boundaries[boundary].ids)
        forces += loads(id, state);
    const auto  &about = boundaries[boundary].about;
    Tensor<1, 3> force, moment;
    for (const Node &node : nodes[boundary])
    {
      Tensor<1, 3> at_node, arm;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double reaction =
          node.is_held[d] ? double(state.reaction(node.dofs[d])) : 0.;
        const double load         = forces(node.dofs[d]);
        const double displacement = state.elastic(node.dofs[d]);
        at_node[d]                = reaction + load;
        if (about)
          arm[d] = node.position[d] - (*about)[d] +
                   (finite_strain ? displacement : 0.);
      }
      force += at_node;
      moment += cross_product_3d(arm, at_node);
    }
    force  = thickness * Utilities::MPI::sum(force, fields.communicator());
    moment = thickness * Utilities::MPI::sum(moment, fields.communicator());
    std::vector<double> result;
    for (unsigned int d = 0; d < dim; ++d)
      result.push_back(force[d]);
    if (about)
      for (unsigned int d = dim == 2 ? 2 : 0; d < 3; ++d)
        result.push_back(moment[d]);
    return result;
  }



  template <int dim>
  std::vector<double>
  WatchedBoundaries<dim>::mean_displacement(const std::size_t boundary,
                                            const State      &state) const
  {
    FEFaceValues<dim> values(
      fields.mapping,
      fields.elastic.get_fe(),
      QGauss<dim - 1>(fields.elastic.get_fe().degree + 1),
      update_values | update_JxW_values);
    std::vector<Tensor<1, dim>> displacements(values.n_quadrature_points);
    std::vector<double>         sums(dim + 1, 0.); // the last one: the area
    for (const auto &cell : fields.elastic.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
        {
          if (!cell->face(f)->at_boundary() ||
              !boundaries[boundary].ids.contains(cell->face(f)->boundary_id()))
            continue;
          values.reinit(cell, f);
          values[fields.displacement].get_function_values(state.elastic,
                                                          displacements);
          for (unsigned int q = 0; q < displacements.size(); ++q)
          {
            for (unsigned int d = 0; d < dim; ++d)
              sums[d] += displacements[q][d] * values.JxW(q);
            sums[dim] += values.JxW(q);
          }
        }
    Utilities::MPI::sum(sums, fields.communicator(), sums);
    for (unsigned int d = 0; d < dim; ++d)
      sums[d] /= sums[dim];
    sums.pop_back();
    return sums;
  }



  template <int dim>
  std::vector<double>
  WatchedBoundaries<dim>::evaluate(const State &state) const
  {
    std::vector<double> result;
    for (std::size_t b = 0; b < boundaries.size(); ++b)
      for (const auto &values :
           {resultant(b, state), mean_displacement(b, state)})
        append(result, values);
    return result;
  }



  template class WatchedBoundaries<2>;
  template class WatchedBoundaries<3>;
} // namespace MixedCracks
