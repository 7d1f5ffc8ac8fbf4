// SPDX-License-Identifier: GPL-2.0-or-later
// What loads along the normal of boundaries share: the loop over the faces, and
// the integral of their forces. Gauss points: one more in each direction than
// the degree of u.
#ifndef mixed_cracks_assembly_loaded_faces_h
#define mixed_cracks_assembly_loaded_faces_h

#include <assembly/normal_loads.h>

#include <base/collective.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <functional>

namespace MixedCracks
{
  /// Add up what @p fill puts into @p local, a vector or a matrix that is 0
  /// then, for each owned face of the boundaries, from its values and function;
  /// what it may throw is thrown on all ranks. The ranks have summed up then.
  template <int dim, typename Local, typename Global>
  void
  add_loaded_faces(const Fields<dim>                       &fields,
                   const BoundaryFunctions<dim>            &functions,
                   const dealii::UpdateFlags                flags,
                   const dealii::AffineConstraints<double> &constraints,
                   Local                                   &local,
                   Global                                  &result,
                   const std::function<void(const dealii::FEFaceValues<dim> &,
                                            dealii::Function<dim> &)> &fill)
  {
    dealii::FEFaceValues<dim> values(
      fields.mapping,
      fields.elastic.get_fe(),
      dealii::QGauss<dim - 1>(fields.elastic.get_fe().degree + 1),
      flags | dealii::update_values | dealii::update_JxW_values |
        dealii::update_normal_vectors | dealii::update_quadrature_points);
    std::vector<dealii::types::global_dof_index> indices(values.dofs_per_cell);
    together(fields.communicator(), [&]() {
      for (const auto &cell : fields.elastic.active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const unsigned int face : cell->face_indices())
            if (cell->face(face)->at_boundary())
            {
              const auto found =
                functions.find(cell->face(face)->boundary_id());
              if (found == functions.end())
                continue;
              values.reinit(cell, face);
              local = 0.;
              fill(values, *found->second);
              cell->get_dof_indices(indices);
              constraints.distribute_local_to_global(local, indices, result);
            }
    });
    result.compress(dealii::VectorOperation::add);
  }



  /// Of the displacement (below dim) or the pressure that a shape function is
  /// of.
  template <int dim>
  unsigned int
  component_of(const dealii::FEFaceValues<dim> &values, const unsigned int i)
  {
    return values.get_fe().system_to_component_index(i).first;
  }



  /// += factor * integral of pressure a . N_i
  template <int dim>
  void
  add_pressure(const dealii::FEFaceValues<dim>           &values,
               const std::vector<double>                 &pressures,
               const std::vector<dealii::Tensor<1, dim>> &areas,
               const double                               factor,
               dealii::Vector<double>                    &local)
  {
    for (unsigned int i = 0; i < values.dofs_per_cell; ++i)
      if (const unsigned int c = component_of(values, i); c < dim)
        for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
          local(i) += factor * pressures[q] * areas[q][c] *
                      values.shape_value(i, q) * values.JxW(q);
  }
} // namespace MixedCracks

#endif
