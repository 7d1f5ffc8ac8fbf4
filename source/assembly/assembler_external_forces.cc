// SPDX-License-Identifier: GPL-2.0-or-later
// Dead loads, the right-hand side of the first line of (M5):
//
//   F_(ad) = integral of f_d N_a dx + integral over the boundary of t_d N_a ds,
//
// f a body force (N/mm^3), t a traction (MPa) on boundaries by name; N/mm, per
// mm of thickness. They do not depend on u (small strains). Gauss points, in
// cells and on faces: one more in each direction than the degree of u.

#include <assembly/assembler.h>

#include <base/collective.h>

#include <deal.II/base/quadrature_lib.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // integral of a vector-valued load times the shape functions of u
    template <int dim>
    void
    add_load(const FEValuesBase<dim> &fe_values,
             const Function<dim>     &load,
             dealii::Vector<double>  &local)
    {
      for (unsigned int q = 0; q < fe_values.n_quadrature_points; ++q)
        for (unsigned int i = 0; i < fe_values.dofs_per_cell; ++i)
        {
          const unsigned int component =
            fe_values.get_fe().system_to_component_index(i).first;
          if (component < dim)
            local(i) += load.value(fe_values.quadrature_point(q), component) *
                        fe_values.shape_value(i, q) * fe_values.JxW(q);
        }
    }
  } // namespace



  template <int dim>
  void
  Assembler<dim>::external_forces(
    const Function<dim>                                       *body_force,
    const std::map<types::boundary_id, const Function<dim> *> &tractions,
    const Constraints                                         &constraints,
    Vector                                                    &forces) const
  {
    const UpdateFlags flags =
      update_values | update_JxW_values | update_quadrature_points;
    const FiniteElement<dim> &element = fields.elastic.get_fe();
    FEValues<dim>             cell_values(
      fields.mapping, element, fields.quadrature, flags);
    FEFaceValues<dim> face_values(
      fields.mapping, element, QGauss<dim - 1>(element.degree + 1), flags);
    dealii::Vector<double>               local(element.n_dofs_per_cell());
    std::vector<types::global_dof_index> indices(local.size());

    together(fields.communicator(), [&]() {
      for (const Cell &cell : fields.elastic.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          local = 0.;
          if (body_force != nullptr)
          {
            cell_values.reinit(cell);
            add_load(cell_values, *body_force, local);
          }
          for (const unsigned int face : cell->face_indices())
            if (cell->face(face)->at_boundary())
            {
              const auto traction =
                tractions.find(cell->face(face)->boundary_id());
              if (traction == tractions.end())
                continue;
              face_values.reinit(cell, face);
              add_load(face_values, *traction->second, local);
            }
          cell->get_dof_indices(indices);
          constraints.distribute_local_to_global(local, indices, forces);
        }
    });
    forces.compress(VectorOperation::add);
  }



  template void Assembler<2>::external_forces(
    const Function<2> *,
    const std::map<types::boundary_id, const Function<2> *> &,
    const Constraints &,
    Vector &) const;
  template void Assembler<3>::external_forces(
    const Function<3> *,
    const std::map<types::boundary_id, const Function<3> *> &,
    const Constraints &,
    Vector &) const;
} // namespace MixedCracks
