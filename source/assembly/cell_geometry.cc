// SPDX-License-Identifier: GPL-2.0-or-later
// The map of one cell from the unit cell, x = x(xi), J = dx/dxi:
//
//   integral over the cell of f dx = sum_q w_q f(x_q),  w_q = weight_q |J(x_q)|
//   grad N(x) = J^-T grad_xi N(xi):  dN/dx_j = sum_i dN/dxi_i dxi_i/dx_j.
//
// w_q (mm^dim) and J^-1 = dxi/dx (1/mm) depend on the mesh only, dN/dxi on the
// element only: the product of the two is what a cell costs, and no FEValues.

#include <assembly/cell_geometry.h>

#include <numeric>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  double
  CellGeometry<dim>::volume() const
  {
    return std::accumulate(weights.begin(), weights.end(), 0.);
  }



  template <int dim>
  GeometryEvaluator<dim>::GeometryEvaluator(const Mapping<dim>    &mapping,
                                            const Quadrature<dim> &quadrature)
    : fe_values(mapping,
                no_shapes,
                quadrature,
                update_JxW_values | update_inverse_jacobians)
  {}



  template <int dim>
  CellGeometry<dim>
  GeometryEvaluator<dim>::operator()(
    const typename Triangulation<dim>::cell_iterator &cell)
  {
    fe_values.reinit(cell);
    CellGeometry<dim> result;
    result.weights = fe_values.get_JxW_values();
    for (const auto &inverse : fe_values.get_inverse_jacobians())
      result.inverse_jacobians.push_back(Tensor<2, dim>(inverse));
    return result;
  }



  template <int dim>
  ScalarShapes<dim>::ScalarShapes(const FiniteElement<dim> &element,
                                  const Quadrature<dim>    &quadrature)
    : n_shapes(element.n_dofs_per_cell())
  {
    for (const Point<dim> &point : quadrature.get_points())
      for (unsigned int i = 0; i < n_shapes; ++i)
      {
        values.push_back(element.shape_value(i, point));
        reference_gradients.push_back(element.shape_grad(i, point));
      }
    gradients.resize(reference_gradients.size());
  }



  // (row vector) * J^-1: sum_i dN/dxi_i dxi_i/dx_j, see above
  template <int dim>
  void
  ScalarShapes<dim>::reinit(const CellGeometry<dim> &geometry)
  {
    for (unsigned int q = 0; q < geometry.weights.size(); ++q)
      for (unsigned int i = q * n_shapes; i < (q + 1) * n_shapes; ++i)
        gradients[i] = reference_gradients[i] * geometry.inverse_jacobians[q];
  }



  template struct CellGeometry<2>;
  template struct CellGeometry<3>;
  template class GeometryEvaluator<2>;
  template class GeometryEvaluator<3>;
  template class ScalarShapes<2>;
  template class ScalarShapes<3>;
} // namespace MixedCracks
