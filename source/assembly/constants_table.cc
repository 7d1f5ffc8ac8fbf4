// SPDX-License-Identifier: GPL-2.0-or-later
// lambda, mu (MPa) and G_c (N/mm) at x_q of every owned cell, where they vary:
// an expression is evaluated once per point and mesh instead of in each of some
// hundred assemblies. The integrals are exact only as far as the quadrature is:
// a jump within a cell is seen by the points on its two sides.

#include <assembly/constants_table.h>

#include <base/collective.h>

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  ConstantsTable<dim>::ConstantsTable(
    const Fields<dim>                   &fields,
    const std::optional<PointConstants> &everywhere,
    const ConstantsFunction<dim>        &constants_at)
    : varies(static_cast<bool>(constants_at))
    , n_points(fields.quadrature.size())
  {
    if (varies)
      for_each_quadrature_point<dim>(
        fields, [&](const Point<dim> &point, const types::material_id id) {
          values.push_back(constants_at(point, id));
        });
    else
      values.push_back(everywhere.value());
  }



  template <int dim>
  void
  for_each_quadrature_point(
    const Fields<dim>                                                 &fields,
    const std::function<void(const Point<dim> &, types::material_id)> &body)
  {
    const FE_Nothing<dim> no_shapes;
    FEValues<dim>         fe_values(
      fields.mapping, no_shapes, fields.quadrature, update_quadrature_points);
    together(fields.communicator(), [&]() {
      for (const auto &cell :
           fields.elastic.get_triangulation().active_cell_iterators())
        if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          for (const Point<dim> &point : fe_values.get_quadrature_points())
            body(point, cell->material_id());
        }
    });
  }



  template class ConstantsTable<2>;
  template class ConstantsTable<3>;
  template void for_each_quadrature_point<2>(
    const Fields<2> &,
    const std::function<void(const Point<2> &, types::material_id)> &);
  template void for_each_quadrature_point<3>(
    const Fields<3> &,
    const std::function<void(const Point<3> &, types::material_id)> &);
} // namespace MixedCracks
