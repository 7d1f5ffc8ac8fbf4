// SPDX-License-Identifier: GPL-2.0-or-later
// Dead loads along the normal of a boundary: with n dA of the undeformed body,
// n outward, w a test function, f a function and s a factor (1 for tractions,
// -1 for pressures),
//
//   F(w) = integral of s f n . w dA.

#include <assembly/loaded_faces.h>
#include <assembly/normal_loads.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  void
  add_normal_forces(const Fields<dim>               &fields,
                    const BoundaryFunctions<dim>    &functions,
                    const double                     factor,
                    const AffineConstraints<double> &constraints,
                    LinearAlgebra::Vector           &forces)
  {
    if (functions.empty())
      return;
    dealii::Vector<double> local(fields.elastic.get_fe().n_dofs_per_cell());
    add_loaded_faces<dim>(
      fields,
      functions,
      update_default,
      constraints,
      local,
      forces,
      [&](const auto &values, Function<dim> &function) {
        std::vector<double>         tractions;
        std::vector<Tensor<1, dim>> normals;
        for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
        {
          tractions.push_back(function.value(values.quadrature_point(q), 0));
          normals.push_back(values.normal_vector(q));
        }
        add_pressure(values, tractions, normals, factor, local);
      });
  }



#define INSTANTIATE(dim)                                             \
  template void add_normal_forces(const Fields<dim> &,               \
                                  const BoundaryFunctions<dim> &,    \
                                  double,                            \
                                  const AffineConstraints<double> &, \
                                  LinearAlgebra::Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
