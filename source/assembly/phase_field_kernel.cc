// SPDX-License-Identifier: GPL-2.0-or-later
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
  PhaseFieldKernel<dim>::lumped_toughness(Vector<double> &result) const
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
