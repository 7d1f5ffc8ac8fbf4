// SPDX-License-Identifier: GPL-2.0-or-later
// Forces at vertices, with N_i the shape function that is 1 at the vertex i:
//
//   F_(id) += P_d(t) / b,   P in N, b the thickness (1 in 3-d)
//
// which is ( f, w ) for f = P delta(x - x_i). As dead loads they are part of
// all works and energies that tractions are part of.

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
  PointForces<dim>::reinit(const Fields<dim>               &fields,
                           const AffineConstraints<double> &hanging_nodes)
  {
    if (forces.empty())
      return;
    std::vector<VertexComponent<dim>> places;
    for (const PointForce<dim> &force : forces)
      places.push_back({force.point, force.component});
    owned_dofs = owned_of(
      dofs_at_vertices(fields.elastic, hanging_nodes, places, force_entry),
      fields.elastic_dofs.owned);
    std::vector<unsigned int> n_dofs;
    for (const VertexDofs &dofs : owned_dofs)
      n_dofs.push_back(static_cast<unsigned int>(dofs.size()));
    Utilities::MPI::sum(n_dofs, fields.communicator(), n_dofs);
    for (std::size_t i = 0; i < forces.size(); ++i)
      if (n_dofs[i] > 1)
        throw InputError(std::string(force_entry) + ": found the point " +
                         in_words(forces[i].point) +
                         ", where a slit has two vertices. Allowed are points "
                         "that are one vertex of the mesh.");
  }



  template <int dim>
  void
  PointForces<dim>::add(const double time, LinearAlgebra::Vector &nodal) const
  {
    if (forces.empty())
      return;
    together(nodal.get_mpi_communicator(), [&]() {
      for (std::size_t i = 0; i < forces.size(); ++i)
        for (const auto dof : owned_dofs[i])
        {
          forces[i].value->set_time(time);
          nodal(dof) +=
            forces[i].value->value(forces[i].point, forces[i].component) /
            thickness;
        }
    });
    nodal.compress(VectorOperation::add);
  }



  template class PointForces<2>;
  template class PointForces<3>;
} // namespace MixedCracks
