// SPDX-License-Identifier: GPL-2.0-or-later
// What is made of the state of one cell besides residual and Jacobian, per mm
// of thickness:
//
//   energy    sum_q w_q 1/2 sigma : eps, or W g + p^2/(2 lambda_d) at finite
//             strain; N
//   scales    the sizes of the terms that cancel in the residual
//   averages  of stress and energy density, for the output; MPa

#include <assembly/elastic_kernel.h>

#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // At finite strain a stress is what is left of terms of the size of the
    // moduli, known to some 1e-16 of them: that is to be within a Newton
    // tolerance of 1e-8.
    constexpr double strain_floor = 1e-7;

    // A gradient is a sum of nodal displacements over h, known to some 1e-15 of
    // their size over h whatever the strain: of a body that is moved or turned
    // as a whole nothing else is left. Of products and the inverse of F some
    // ten times as much.
    constexpr double rounding = 1e-6, rounding_at_finite_strain = 1e-5;
  } // namespace



  // sum_q w_q 1/2 sigma : eps with the p that the state has.
  template <int dim>
  double
  ElasticKernel<dim>::energy() const
  {
    double sum = 0.;
    for (unsigned int q = 0; q < states.size(); ++q)
      sum +=
        geometry->weights[q] * material.elastic_energy(states[q].gradient,
                                                       states[q].pressure,
                                                       states[q].degradation,
                                                       constants[q]);
    return sum;
  }



  // A point that is broken with the lagged phase field may be turned inside
  // out: where it would have an infinite energy with a phase field that is a
  // little larger, it counts as broken.
  template <int dim>
  double
  ElasticKernel<dim>::degradation_for_energy(const ElasticPoint<dim> &point,
                                             const double phase_field) const
  {
    const double g = degradation(phase_field);
    return material.is_finite() &&
               !(material.finite().determinant(point.gradient, g) > 0.)
             ? point.degradation
             : g;
  }



  // The same strains with another phase field: p follows from the constraint
  // with the new g, which keeps u, and E(u, phi) of the energy balance is
  // evaluated with phi and not with phi~.
  template <int dim>
  double
  ElasticKernel<dim>::energy(const std::vector<double> &phase_field) const
  {
    double sum = 0.;
    for (unsigned int q = 0; q < states.size(); ++q)
    {
      const ElasticPoint<dim> &point = states[q];
      const double g = degradation_for_energy(point, phase_field[q]);
      sum +=
        geometry->weights[q] *
        material.elastic_energy(
          point.gradient,
          material.pressure_after(
            point.pressure, point.degradation, g, constants[q], point.gradient),
          g,
          constants[q]);
    }
    return sum;
  }



  // What would be there without cancellation. A nodal force is the integral of
  // sigma grad N, and grad N is of the order of 1/h:  s_u = (integral of
  // |sigma|)/h, and the constraint is of the order of  s_p = integral of |eps|,
  // h = V^(1/dim). Newton's method compares |R_u| with the root of the sum of
  // s_u^2, |R_p| with that of s_p^2. To |eps| is added what rounding leaves of
  // it, for a tolerance of 1e-8, and to |sigma| what that strain makes:
  //
  //   eps_0 = 1e-6 max |u|/h, at finite strain 1e-5 max |u|/h + 1e-7
  template <int dim>
  std::pair<double, double>
  ElasticKernel<dim>::squared_scale() const
  {
    // a stress times the gradient of a shape function, of the order of 1/h
    const double h = std::pow(geometry->volume(), 1. / dim);
    const double floor =
      material.is_finite()
        ? rounding_at_finite_strain * largest_displacement / h + strain_floor
        : rounding * largest_displacement / h;
    double stress = 0., strain = 0.;
    for (unsigned int q = 0; q < states.size(); ++q)
    {
      const double          weight = geometry->weights[q];
      const Tensor<2, dim> &here   = responses[q].stress;
      strain += (size_of_strain(states[q].gradient) + floor) * weight;
      stress +=
        (material.is_finite() ? here.norm() : symmetrize(here).norm()) * weight;
      stress += floor * states[q].degradation *
                (2. * constants[q].mu + (mixed ? 0. : constants[q].lambda)) *
                weight;
    }
    std::pair<double, double> result;
    result.first  = (stress / h) * (stress / h);
    result.second = strain * strain;
    return result;
  }



  template <int dim>
  double
  ElasticKernel<dim>::driving_force(const ElasticPoint<dim> &point,
                                    const PointConstants    &at) const
  {
    return material.driving_force(
      point.gradient, point.pressure, point.degradation, at);
  }



  // (sum_q w_q sigma_q)/V and the energy over V
  template <int dim>
  typename ElasticKernel<dim>::CellAverages
  ElasticKernel<dim>::averages(const std::vector<double> &phase_field) const
  {
    CellAverages result{{}, 0., 0., 0.};
    const double volume = geometry->volume();
    for (unsigned int q = 0; q < states.size(); ++q)
      if (material.is_finite())
        add_finite(q, result);
      else
        result.stress += geometry->weights[q] * symmetrize(responses[q].stress);
    result.stress /= volume;
    result.largest_stretch =
      material.is_finite() ? result.largest_stretch / volume : 1.;
    result.volume_ratio =
      material.is_finite() ? result.volume_ratio / volume : 1.;
    result.energy_density = energy(phase_field) / volume;
    return result;
  }



#define INSTANTIATE(dim)                                                  \
  template double ElasticKernel<dim>::energy() const;                     \
  template double ElasticKernel<dim>::energy(const std::vector<double> &) \
    const;                                                                \
  template std::pair<double, double> ElasticKernel<dim>::squared_scale()  \
    const;                                                                \
  template double ElasticKernel<dim>::driving_force(                      \
    const ElasticPoint<dim> &, const PointConstants &) const;             \
  template ElasticKernel<dim>::CellAverages ElasticKernel<dim>::averages( \
    const std::vector<double> &) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
