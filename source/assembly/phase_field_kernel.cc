// SPDX-License-Identifier: GPL-2.0-or-later
// The phase field on one cell for given displacements and pressures: the third
// line of the weak form (M5), for all psi that lead into the bounds,
//
//   ( g'(phi)/2 D + G_c/l a'(phi), psi )
//      + ( 2 b G_c l grad phi, grad psi )  >=  0,
//
// D = sigma+ : eps = 2 psi+(u, p) (MPa) at the quadrature points, from the
// elastic kernel. It is the derivative by phi of
//
//   integral of  g(phi) psi+ + G_c (a(phi)/l + b l |grad phi|^2)  dx.
//
// With g' = 2 (1-kappa) phi the first term is (1-kappa) phi D. Material has the
// integrands; what is here is the sum over the points of one cell of Q1 (4
// nodes in 2-d, 8 in 3-d; N_i, weights w_q):
//
//               u, p                phi
//           +-------------------+-----------+
//    w, q   |  ElasticKernel    |  0        |   phi~ is given, not unknown
//           +-------------------+-----------+
//    psi    |  (by D, explicit) |  H        |
//           +-------------------+-----------+
//
//   r_i    = sum_q w_q [ force N_i + gradient_stiffness grad phi . grad N_i ]
//   H_(ij) = sum_q w_q [ stiffness N_i N_j
//                        + gradient_stiffness grad N_i . grad N_j ]
//
//   force = g'/2 D + G_c/l a',  stiffness = g''/2 D + G_c/l a'',
//   gradient_stiffness = 2 b G_c l.
//
// H is symmetric; with Wu's a'' = -2/pi it is positive definite only where D is
// large enough, or where the nodes that are free lie in a band that is narrower
// than pi l. It does not depend on phi where g and a are quadratic: then one
// solution between the bounds is the end.

#include <assembly/phase_field_kernel.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  PhaseFieldKernel<dim>::PhaseFieldKernel(const FiniteElement<dim> &element,
                                          const Quadrature<dim>    &quadrature,
                                          const Material<dim>      &material)
    : material(material)
    , shapes(element, quadrature)
    , points(quadrature.size())
  {}



  template <int dim>
  void
  PhaseFieldKernel<dim>::reinit(const CellGeometry<dim> &new_geometry,
                                const CellConstants     &new_constants)
  {
    geometry  = &new_geometry;
    constants = new_constants;
    shapes.reinit(new_geometry);
  }



  template <int dim>
  void
  PhaseFieldKernel<dim>::interpolate(const Vector<double> &local,
                                     std::vector<double>  &values) const
  {
    values.assign(points.size(), 0.);
    for (unsigned int q = 0; q < points.size(); ++q)
      for (unsigned int i = 0; i < shapes.size(); ++i)
        values[q] += local(i) * shapes.value(i, q);
  }



  template <int dim>
  void
  PhaseFieldKernel<dim>::set_state(const Vector<double> &local,
                                   const double *const   driving_force)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      points[q] = {0., Tensor<1, dim>(), driving_force[q]};
      for (unsigned int i = 0; i < shapes.size(); ++i)
      {
        points[q].phase_field += local(i) * shapes.value(i, q);
        points[q].gradient += local(i) * shapes.gradient(i, q);
      }
    }
  }



  template <int dim>
  double
  PhaseFieldKernel<dim>::density_at(const unsigned int q) const
  {
    return material.crack_surface_density(points[q].phase_field,
                                          points[q].gradient.norm_square());
  }



  // sum_q w_q G_c gamma: what the crack has cost in this cell
  template <int dim>
  double
  PhaseFieldKernel<dim>::energy() const
  {
    double sum = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
      sum += geometry->weights[q] * constants[q].critical_energy_release_rate *
             density_at(q);
    return sum;
  }



  template <int dim>
  double
  PhaseFieldKernel<dim>::crack_surface() const
  {
    double sum = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
      sum += geometry->weights[q] * density_at(q);
    return sum;
  }



  template <int dim>
  void
  PhaseFieldKernel<dim>::residual(Vector<double> &result) const
  {
    result = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      const double gradient_stiffness =
        material.gradient_stiffness(constants[q]);
      const double force = material.phase_field_force(
        points[q].phase_field, points[q].driving_force, constants[q]);
      for (unsigned int i = 0; i < shapes.size(); ++i)
        result(i) +=
          (force * shapes.value(i, q) +
           gradient_stiffness * (points[q].gradient * shapes.gradient(i, q))) *
          geometry->weights[q];
    }
  }



  template <int dim>
  void
  PhaseFieldKernel<dim>::jacobian(FullMatrix<double> &result) const
  {
    result = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      const double gradient_stiffness =
        material.gradient_stiffness(constants[q]);
      const double stiffness = material.phase_field_stiffness(
        points[q].phase_field, points[q].driving_force, constants[q]);
      for (unsigned int i = 0; i < shapes.size(); ++i)
        for (unsigned int j = 0; j < shapes.size(); ++j)
          result(i, j) += (stiffness * shapes.value(i, q) * shapes.value(j, q) +
                           gradient_stiffness *
                             (shapes.gradient(i, q) * shapes.gradient(j, q))) *
                          geometry->weights[q];
    }
  }



  // m_i = integral of N_i: the row sums of the mass matrix, as the N_j add up
  // to 1. r_i/m_i is an energy density (MPa), a residual that does not depend
  // on h; where G_c varies, r_i over the integral of G_c N_i (1/mm).
  template <int dim>
  void
  PhaseFieldKernel<dim>::lumped_mass(Vector<double> &result) const
  {
    result = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
      for (unsigned int i = 0; i < shapes.size(); ++i)
        result(i) += shapes.value(i, q) * geometry->weights[q];
  }



  template <int dim>
  void
  PhaseFieldKernel<dim>::lumped_release_rate(Vector<double> &result) const
  {
    result = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
      for (unsigned int i = 0; i < shapes.size(); ++i)
        result(i) += constants[q].critical_energy_release_rate *
                     shapes.value(i, q) * geometry->weights[q];
  }



  template class PhaseFieldKernel<2>;
  template class PhaseFieldKernel<3>;
} // namespace MixedCracks
