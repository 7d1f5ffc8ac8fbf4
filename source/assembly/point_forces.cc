// SPDX-License-Identifier: GPL-2.0-or-later
// Forces at vertices, with N_i the shape function that is 1 at the vertex i:
//
//   F_(id) += P_d(t) / b,   P in N, b the thickness (1 in 3-d)
//
// which is ( f, w ) for f = P delta(x - x_i). As dead loads they are part of
// all works and energies that tractions are part of. A hanging vertex follows
// others, u_i = sum_j c_ij u_j: they get c_ij P, and the work is the same.

#include <assembly/point_forces.h>

#include <base/collective.h>

#include <deal.II/base/mpi.h>

#include <discretization/nearest_vertex.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const char *const force_entry = "Boundary conditions/Force at points";
  }



  template <int dim>
  PointForces<dim>::PointForces(std::vector<PointForce<dim>> forces,
                                const double                 thickness)
    : forces(std::move(forces))
    , thickness(thickness)
  {}



  template <int dim>
  void
  PointForces<dim>::require_one_vertex_each(
    const std::vector<VertexDofs> &owned,
    const MPI_Comm                 communicator) const
  {
    std::vector<unsigned int> n_dofs;
    for (const VertexDofs &here : owned)
      n_dofs.push_back(static_cast<unsigned int>(here.size()));
    Utilities::MPI::sum(n_dofs, communicator, n_dofs);
    for (std::size_t i = 0; i < forces.size(); ++i)
      if (n_dofs[i] > 1 && !forces[i].of_set)
        throw InputError(std::string(force_entry) + ": found the point " +
                         in_words(forces[i].point) +
                         ", where a slit has two vertices. Allowed are points "
                         "that are one vertex of the mesh, or a set of points, "
                         "which has both.");
  }



  template <int dim>
  void
  PointForces<dim>::reinit(const Fields<dim>               &fields,
                           const AffineConstraints<double> &hanging_nodes)
  {
    if (forces.empty())
      return;
    // those of sets are found where they hang, too
    std::vector<VertexComponent<dim>> single, of_sets;
    for (const PointForce<dim> &force : forces)
      (force.of_set ? of_sets : single)
        .push_back({force.point, force.component});
    const AffineConstraints<double> none;
    const std::vector<VertexDofs>   found =
      dofs_at_vertices(fields.elastic, hanging_nodes, single, force_entry);
    const std::vector<VertexDofs> found_of_sets =
      dofs_at_vertices(fields.elastic, none, of_sets, force_entry);
    std::vector<VertexDofs> all;
    auto                    next        = found.begin();
    auto                    next_of_set = found_of_sets.begin();
    for (const PointForce<dim> &force : forces)
      all.push_back(force.of_set ? *next_of_set++ : *next++);
    const auto owned = owned_of(all, fields.elastic_dofs.owned);
    require_one_vertex_each(owned, fields.communicator());
    dofs.assign(forces.size(), {});
    for (std::size_t i = 0; i < forces.size(); ++i)
      for (const auto dof : owned[i])
        if (hanging_nodes.is_constrained(dof))
          for (const auto &to : *hanging_nodes.get_constraint_entries(dof))
            dofs[i].push_back(to);
        else
          dofs[i].emplace_back(dof, 1.);
  }



  template <int dim>
  void
  PointForces<dim>::add(const double time, LinearAlgebra::Vector &nodal) const
  {
    if (forces.empty())
      return;
    together(nodal.get_mpi_communicator(), [&]() {
      for (std::size_t i = 0; i < forces.size(); ++i)
        for (const auto &[dof, weight] : dofs[i])
        {
          forces[i].value->set_time(time);
          nodal(dof) +=
            forces[i].value->value(forces[i].point, forces[i].component) *
            weight / thickness;
        }
    });
    nodal.compress(VectorOperation::add);
  }



  template class PointForces<2>;
  template class PointForces<3>;
} // namespace MixedCracks
