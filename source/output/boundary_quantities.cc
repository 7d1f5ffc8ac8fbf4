// SPDX-License-Identifier: GPL-2.0-or-later
// Force on a boundary B, with the residual r = internal - external forces
// (State::reaction, N per mm of thickness), shape functions N_i,
//
//   F_d = s sum_(i on B) r_(i,d),
//   r_(i,d) = integral of sigma : eps(N_i e_d) - external force on (i, d),
//
// what the supports of B give, in balance with all others to the accuracy of
// the solver. An integral of sigma n over the faces is in balance up to the
// error of discretisation only, and converges more slowly.
//
// s = -1 where the largest component of the mean outward normal is negative,
// for all components: a pulled left side has a positive F_x. F is then the
// force across a section, which the part at larger coordinates exerts on the
// other; in balance, opposite sides have the same F, in shear as well. Points:
// s = 1.
//
// Displacement: max over boundaries b of (integral over b of |u_b|) / |b| with
// the prescribed u_b (components not prescribed 0), and over points of |u_b|.

#include <base/collective.h>
#include <base/ranges.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_values.h>

#include <output/boundary_quantities.h>

#include <algorithm>
#include <map>

namespace MixedCracks
{
  using namespace dealii;



  template <int dim>
  void
  BoundaryQuantities<dim>::reinit()
  {
    if (!boundary.empty())
      reinit_at_boundary();
    else
      reinit_at_points();
  }



  template <int dim>
  void
  BoundaryQuantities<dim>::reinit_at_points()
  {
    const auto &points = constraints.prescribed_points();
    const auto  moves  = [&points](const Point<dim> &position) {
      return any_of(points, [&position](const auto &entry) {
        return entry.moves && entry.point == position;
      });
    };
    const bool any =
      any_of(points, [](const auto &entry) { return entry.moves; });
    for (IndexSet &dofs : owned_dofs)
      dofs = IndexSet(fields.elastic.n_dofs());
    for (std::size_t i = 0; i < points.size(); ++i)
      for (const auto dof : constraints.dofs_of_points()[i])
        if (fields.elastic_dofs.owned.is_element(dof) &&
            (!any || moves(points[i].point)))
          owned_dofs[points[i].component].add_index(dof);
    sign = 1.;
  }



  template <int dim>
  void
  BoundaryQuantities<dim>::reinit_at_boundary()
  {
    for (unsigned int d = 0; d < dim; ++d)
    {
      std::vector<bool> mask(fields.elastic.get_fe().n_components(), false);
      mask[d]       = true;
      owned_dofs[d] = DoFTools::extract_boundary_dofs(
                        fields.elastic, ComponentMask(mask), boundary) &
                      fields.elastic_dofs.owned;
    }

    Tensor<1, dim>    normal;
    FEFaceValues<dim> face_values(fields.mapping,
                                  fields.phase_field.get_fe(),
                                  QGauss<dim - 1>(2),
                                  update_normal_vectors | update_JxW_values);
    for (const auto &cell : fields.phase_field.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int face : cell->face_indices())
          if (cell->face(face)->at_boundary() &&
              boundary.contains(cell->face(face)->boundary_id()))
          {
            face_values.reinit(cell, face);
            for (unsigned int q = 0; q < face_values.n_quadrature_points; ++q)
              normal += face_values.normal_vector(q) * face_values.JxW(q);
          }
    normal            = Utilities::MPI::sum(normal, fields.communicator());
    unsigned int axis = 0;
    for (unsigned int d = 1; d < dim; ++d)
      if (std::abs(normal[d]) > std::abs(normal[axis]))
        axis = d;
    sign = normal[axis] < 0. ? -1. : 1.;
  }



  template <int dim>
  Tensor<1, dim>
  BoundaryQuantities<dim>::force(const LinearAlgebra::Vector &reaction) const
  {
    Tensor<1, dim> sum;
    for (unsigned int d = 0; d < dim; ++d)
      for (const auto dof : owned_dofs[d])
        sum[d] += reaction(dof);
    return sign * Utilities::MPI::sum(sum, fields.communicator());
  }



  namespace
  {
    // to the integral of the magnitude over a face, and to the area
    template <int dim>
    void
    add_displacement(
      const FEFaceValues<dim>                             &face_values,
      const std::vector<const PrescribedComponent<dim> *> &entries,
      double                                              *sums)
    {
      for (unsigned int q = 0; q < face_values.n_quadrature_points; ++q)
      {
        Tensor<1, dim> value;
        for (const auto *entry : entries)
          value[entry->component] = entry->value->value(
            face_values.quadrature_point(q), entry->component);
        sums[0] += value.norm() * face_values.JxW(q);
        sums[1] += face_values.JxW(q);
      }
    }
  } // namespace



  // Two numbers per boundary, integral and area. An expression may fail in a
  // point of one rank: together() throws on all, before the sum, or they would
  // deadlock.
  template <int dim>
  double
  BoundaryQuantities<dim>::displacement(const double time) const
  {
    std::map<BoundaryIds, std::vector<const PrescribedComponent<dim> *>>
      by_boundary;
    for (const auto &entry : constraints.prescribed_components())
    {
      entry.value->set_time(time);
      by_boundary[entry.boundary].push_back(&entry);
    }
    // integral of the magnitude and area per boundary, in the map's order
    std::vector<double> sums(2 * by_boundary.size(), 0.);
    FEFaceValues<dim>   face_values(fields.mapping,
                                  fields.phase_field.get_fe(),
                                  QGauss<dim - 1>(2),
                                  update_quadrature_points | update_JxW_values);
    together(fields.communicator(), [&]() {
      for (const auto &cell : fields.phase_field.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int face : cell->face_indices())
          {
            if (!cell->face(face)->at_boundary())
              continue;
            const auto  id = cell->face(face)->boundary_id();
            std::size_t at = 0;
            for (const auto &[ids, entries] : by_boundary)
            {
              if (ids.contains(id))
              {
                face_values.reinit(cell, face);
                add_displacement(face_values, entries, &sums[at]);
              }
              at += 2;
            }
          }
    });
    Utilities::MPI::sum(sums, fields.communicator(), sums);
    double largest = 0.;
    for (std::size_t i = 0; i < sums.size(); i += 2)
      if (sums[i + 1] > 0.)
        largest = std::max(largest, sums[i] / sums[i + 1]);
    for (const Tensor<1, dim> &period :
         constraints.periodic().sides().periods())
      largest = std::max(
        largest, (constraints.periodic().strain_at(time) * period).norm());
    return std::max(largest, largest_point_displacement(time));
  }



  template <int dim>
  double
  BoundaryQuantities<dim>::largest_point_displacement(const double time) const
  {
    double largest = 0.;
    for (const auto &entry : constraints.prescribed_points())
    {
      Tensor<1, dim> value;
      for (const auto &other : constraints.prescribed_points())
        if (other.point == entry.point)
        {
          other.value->set_time(time);
          value[other.component] =
            other.value->value(other.point, other.component);
        }
      largest = std::max(largest, value.norm());
    }
    return largest;
  }



  template class BoundaryQuantities<2>;
  template class BoundaryQuantities<3>;
} // namespace MixedCracks
