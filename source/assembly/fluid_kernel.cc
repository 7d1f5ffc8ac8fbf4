// SPDX-License-Identifier: GPL-2.0-or-later
// The work of a given fluid pressure p_f (MPa) on the crack faces of one cell
// [MikWW15], (M10):
//
//   E_f(u, phi) = - integral of p_f u . grad(phi^2) dx
//               = - 2 integral of p_f phi u . grad phi dx.
//
// Across a crack phi^2 falls from 1 to 0 and rises to 1 again: grad(phi^2)
// integrated over one side is the normal that points into the body, and E_f is
// minus p_f times the volume between the faces, so that p_f > 0 opens. It uses
// phi^2 whatever the degradation is: it marks where the solid is, not how
// stiff.
//
// What the two fields get, with N_a and N_i the shape functions of u and phi:
//
//   force on the nodes   f_(ad) = - dE_f/du = 2 sum_q w_q p_f phi dphi/dx_d N_a
//                        does not depend on u: no part in the elastic matrix;
//                        evaluated with phi~
//   phase field          r_i = dE_f/dphi_i, H_(ij) = dr_i/dphi_j:
//
//       r_i    = - 2 sum_q w_q p_f u . (N_i grad phi + phi grad N_i)
//       H_(ij) = - 2 sum_q w_q p_f u . (N_i grad N_j + N_j grad N_i)
//
// f in N/mm, r in N, both per mm of thickness. H is symmetric and of either
// sign: within the body it acts like 2/(1-kappa) (p_f div u + grad p_f . u)
// added to D, for the quadratic g.

#include <assembly/fluid_kernel.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  FluidKernel<dim>::FluidKernel(const FiniteElement<dim> &elastic,
                                const FiniteElement<dim> &phase_field,
                                const Quadrature<dim>    &quadrature)
    : displacement_shapes(elastic.base_element(0), quadrature)
    , phase_field_shapes(phase_field, quadrature)
    , points(quadrature.size())
    , displacement_dofs(displacement_shapes.size())
  {
    for (unsigned int i = 0; i < elastic.n_dofs_per_cell(); ++i)
    {
      const auto [component, node] = elastic.system_to_component_index(i);
      if (component < dim)
        displacement_dofs[node][component] = i;
    }
  }



  template <int dim>
  void
  FluidKernel<dim>::reinit(const CellGeometry<dim> &new_geometry)
  {
    geometry = &new_geometry;
    phase_field_shapes.reinit(new_geometry);
  }



  template <int dim>
  void
  FluidKernel<dim>::set_pressure(const double *const first)
  {
    pressure = first;
  }



  template <int dim>
  void
  FluidKernel<dim>::set_phase_field(const Vector<double> &local)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      points[q].phase_field = 0.;
      points[q].gradient    = Tensor<1, dim>();
      for (unsigned int i = 0; i < phase_field_shapes.size(); ++i)
      {
        points[q].phase_field += local(i) * phase_field_shapes.value(i, q);
        points[q].gradient += local(i) * phase_field_shapes.gradient(i, q);
      }
    }
  }



  template <int dim>
  void
  FluidKernel<dim>::set_displacement(const Vector<double> &local)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      points[q].displacement = Tensor<1, dim>();
      for (unsigned int a = 0; a < displacement_dofs.size(); ++a)
        for (unsigned int d = 0; d < dim; ++d)
          points[q].displacement[d] +=
            local(displacement_dofs[a][d]) * displacement_shapes.value(a, q);
    }
  }



  template <int dim>
  double
  FluidKernel<dim>::energy() const
  {
    double sum = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
      sum -= 2. * geometry->weights[q] * pressure[q] * points[q].phase_field *
             (points[q].displacement * points[q].gradient);
    return sum;
  }



  template <int dim>
  void
  FluidKernel<dim>::nodal_forces(Vector<double> &result) const
  {
    result = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      const Tensor<1, dim> force = 2. * geometry->weights[q] * pressure[q] *
                                   points[q].phase_field * points[q].gradient;
      for (unsigned int a = 0; a < displacement_dofs.size(); ++a)
        for (unsigned int d = 0; d < dim; ++d)
          result(displacement_dofs[a][d]) +=
            force[d] * displacement_shapes.value(a, q);
    }
  }



  template <int dim>
  void
  FluidKernel<dim>::phase_field_residual(Vector<double> &result) const
  {
    result = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      const Tensor<1, dim> load =
        -2. * geometry->weights[q] * pressure[q] * points[q].displacement;
      const double along_gradient = load * points[q].gradient;
      for (unsigned int i = 0; i < phase_field_shapes.size(); ++i)
        result(i) +=
          along_gradient * phase_field_shapes.value(i, q) +
          points[q].phase_field * (load * phase_field_shapes.gradient(i, q));
    }
  }



  template <int dim>
  void
  FluidKernel<dim>::phase_field_jacobian(FullMatrix<double> &result) const
  {
    const ScalarShapes<dim> &shapes = phase_field_shapes;
    result                          = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      const Tensor<1, dim> load =
        -2. * geometry->weights[q] * pressure[q] * points[q].displacement;
      for (unsigned int i = 0; i < shapes.size(); ++i)
        for (unsigned int j = 0; j < shapes.size(); ++j)
          result(i, j) += load * (shapes.value(i, q) * shapes.gradient(j, q) +
                                  shapes.value(j, q) * shapes.gradient(i, q));
    }
  }



  template class FluidKernel<2>;
  template class FluidKernel<3>;
} // namespace MixedCracks
