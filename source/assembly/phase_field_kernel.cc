// SPDX-License-Identifier: GPL-2.0-or-later
#include <assembly/phase_field_kernel.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  PhaseFieldKernel<dim>::PhaseFieldKernel(const FiniteElement<dim> &element,
                                          const Mapping<dim>       &mapping,
                                          const Quadrature<dim>    &quadrature,
                                          const Material<dim>      &material)
    : material(material)
    , fe_values(mapping,
                element,
                quadrature,
                update_values | update_gradients | update_JxW_values)
    , points(quadrature.size())
  {}



  template <int dim>
  void
  PhaseFieldKernel<dim>::reinit(
    const typename Triangulation<dim>::cell_iterator &cell)
  {
    fe_values.reinit(cell);
  }



  template <int dim>
  void
  PhaseFieldKernel<dim>::interpolate(const Vector<double> &local,
                                     std::vector<double>  &values) const
  {
    values.assign(points.size(), 0.);
    for (unsigned int q = 0; q < points.size(); ++q)
      for (unsigned int i = 0; i < fe_values.dofs_per_cell; ++i)
        values[q] += local(i) * fe_values.shape_value(i, q);
  }



  template <int dim>
  void
  PhaseFieldKernel<dim>::set_state(const Vector<double>      &local,
                                   const std::vector<double> &driving_force)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      points[q] = {0., Tensor<1, dim>(), driving_force[q]};
      for (unsigned int i = 0; i < fe_values.dofs_per_cell; ++i)
      {
        points[q].phase_field += local(i) * fe_values.shape_value(i, q);
        points[q].gradient += local(i) * fe_values.shape_grad(i, q);
      }
    }
  }



  template <int dim>
  double
  PhaseFieldKernel<dim>::energy() const
  {
    const MaterialDescription &constants = material.description();
    const CrackDensity        &density   = material.crack_density();
    double                     sum       = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
      sum += fe_values.JxW(q) * constants.critical_energy_release_rate *
             (density.local(points[q].phase_field) / constants.length_scale +
              density.gradient_coefficient() * constants.length_scale *
                points[q].gradient.norm_square());
    return sum;
  }



  template <int dim>
  void
  PhaseFieldKernel<dim>::residual(Vector<double> &result) const
  {
    const MaterialDescription &constants = material.description();
    const CrackDensity        &density   = material.crack_density();
    const double toughness = constants.critical_energy_release_rate;
    const double gradient_factor =
      2. * density.gradient_coefficient() * toughness * constants.length_scale;
    result = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      const double local =
        0.5 * material.degradation().derivative(points[q].phase_field) *
          points[q].driving_force +
        toughness / constants.length_scale *
          density.local_derivative(points[q].phase_field);
      for (unsigned int i = 0; i < fe_values.dofs_per_cell; ++i)
        result(i) += (local * fe_values.shape_value(i, q) +
                      gradient_factor *
                        (points[q].gradient * fe_values.shape_grad(i, q))) *
                     fe_values.JxW(q);
    }
  }



  template <int dim>
  void
  PhaseFieldKernel<dim>::jacobian(FullMatrix<double> &result) const
  {
    const MaterialDescription &constants = material.description();
    const CrackDensity        &density   = material.crack_density();
    const double toughness = constants.critical_energy_release_rate;
    const double gradient_factor =
      2. * density.gradient_coefficient() * toughness * constants.length_scale;
    result = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      const double local =
        0.5 * material.degradation().second_derivative() *
          points[q].driving_force +
        toughness / constants.length_scale *
          density.local_second_derivative(points[q].phase_field);
      for (unsigned int i = 0; i < fe_values.dofs_per_cell; ++i)
        for (unsigned int j = 0; j < fe_values.dofs_per_cell; ++j)
          result(i, j) +=
            (local * fe_values.shape_value(i, q) * fe_values.shape_value(j, q) +
             gradient_factor *
               (fe_values.shape_grad(i, q) * fe_values.shape_grad(j, q))) *
            fe_values.JxW(q);
    }
  }



  template <int dim>
  void
  PhaseFieldKernel<dim>::lumped_mass(Vector<double> &result) const
  {
    result = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
      for (unsigned int i = 0; i < fe_values.dofs_per_cell; ++i)
        result(i) += fe_values.shape_value(i, q) * fe_values.JxW(q);
  }



  template class PhaseFieldKernel<2>;
  template class PhaseFieldKernel<3>;
} // namespace MixedCracks
