// SPDX-License-Identifier: GPL-2.0-or-later
// Energies and what else is said about one point of rubber, (M11) to (M15);
// the symbols are those of finite_strain.cc, energies in MPa:
//
//   p            = s theta/c,               theta with the F_33 of P_33 = 0
//   D            = 2 Psi+ = 2 W~ + driving p theta                      (M15)
//   psi          = a W~ + c p^2/2
//   psi(grad u)  = a W~ + s^2 theta^2/(2 c), p eliminated
//   sigma        = P F^T/J
//
// and the parts a W~, s theta and c of Pi for a line search, which eliminates
// p in the discrete space.

#include <model/energy_interpolation.h>
#include <model/finite_strain.h>
#include <model/gradient_in_space.h>

#include <cmath>
#include <limits>

namespace MixedCracks
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    const double not_a_value = std::numeric_limits<double>::quiet_NaN();
  }



  template <int dim>
  double
  FiniteStrain<dim>::pressure(const Gradient       &gradient,
                              const double          g,
                              const PointConstants &at) const
  {
    const auto deformation = at_constraint(gradient, g, at);
    if (!deformation)
      return not_a_value;
    const double theta = form->measure(deformation->volume_change).value;
    const FinitePressureCoefficients now = coefficients(theta, g, at);
    return now.volume * theta / now.compliance;
  }



  // (1 - gamma^2) mu_L/2 |H|^2: of broken material, without its g
  template <int dim>
  double
  FiniteStrain<dim>::linear_energy(const Gradient       &gradient,
                                   const double          g,
                                   const PointConstants &at) const
  {
    const double share = share_of_law(g);
    return share == 1. ? 0.
                       : 0.5 * (1. - share * share) *
                           linear_modulus(*law, law_constants(at)) *
                           gradient.norm_square();
  }



  // Of the law wherever there is an F, however broken the material: what drives
  // a crack while its cells still carry something is (M15), and only what is
  // turned inside out has the energy that is interpolated.
  template <int dim>
  double
  FiniteStrain<dim>::driving_force(const Gradient       &gradient,
                                   const double          pressure,
                                   const double          g,
                                   const PointConstants &at) const
  {
    const auto by_law = [&](const Deformation &deformation) {
      const HyperelasticConstants constants = law_constants(at);
      double                      force     = 2. * (split->only_stretches_drive
                                                      ? law->tensile_energy(deformation, constants)
                                                      : law->energy(deformation, constants));
      if (split->drives(pressure))
        force += coefficients(pressure, g, at).driving * pressure *
                 form->measure(deformation.volume_change).value;
      return force;
    };
    if (determinant_of(gradient) > 0.)
    {
      const double stretch =
        plane_stress ? stretch_at_pressure(gradient, pressure, g, at) : 1.;
      if (stretch > 0.)
        return by_law(Deformation(gradient_in_space(gradient, stretch)));
    }
    const auto scaled = at_pressure(gradient, pressure, g, at);
    return scaled ? by_law(*scaled) + 2. * linear_energy(gradient, g, at)
                  : not_a_value;
  }



  template <int dim>
  double
  FiniteStrain<dim>::elastic_energy(const Gradient       &gradient,
                                    const double          pressure,
                                    const double          g,
                                    const PointConstants &at) const
  {
    const Potential parts = potential(gradient, pressure, g, at);
    return parts.distortion + 0.5 * parts.compliance * pressure * pressure;
  }



  // The discrete p solves the constraint in the mean only. In plane stress it
  // changes by as much as the pressures that the constraint gives at this
  // point, which differ through F_33 too; else by the ratio of the stiffnesses,
  // since J - 1 at a point of nearly incompressible material is not p/lambda.
  template <int dim>
  double
  FiniteStrain<dim>::pressure_after(const double          pressure,
                                    const double          g_before,
                                    const double          g_after,
                                    const PointConstants &at,
                                    const Gradient       &gradient) const
  {
    if (g_before == g_after || pressure == 0.)
      return pressure;
    if (plane_stress)
    {
      const double change = this->pressure(gradient, g_after, at) -
                            this->pressure(gradient, g_before, at);
      return std::isfinite(change) ? pressure + change : pressure;
    }
    const FinitePressureCoefficients before =
      coefficients(pressure, g_before, at);
    const FinitePressureCoefficients after =
      coefficients(pressure, g_after, at);
    const double stiffness = before.volume / before.compliance;
    return stiffness > 0.
             ? pressure * (after.volume / after.compliance) / stiffness
             : 0.;
  }



  template <int dim>
  typename FiniteStrain<dim>::Potential
  FiniteStrain<dim>::potential(const Gradient       &gradient,
                               const double          pressure,
                               const double          g,
                               const PointConstants &at) const
  {
    const auto deformation = at_pressure(gradient, pressure, g, at);
    if (!deformation)
      return {not_a_value, not_a_value, not_a_value};
    const FinitePressureCoefficients now = coefficients(pressure, g, at);
    return {now.distortion * law->energy(*deformation, law_constants(at)) +
              now.distortion * linear_energy(gradient, g, at),
            now.volume * form->measure(deformation->volume_change).value,
            now.compliance};
  }



  template <int dim>
  double
  FiniteStrain<dim>::eliminated_energy(const Gradient       &gradient,
                                       const double          g,
                                       const PointConstants &at) const
  {
    const auto deformation = at_constraint(gradient, g, at);
    if (!deformation)
      return std::numeric_limits<double>::infinity();
    const double theta = form->measure(deformation->volume_change).value;
    const FinitePressureCoefficients now    = coefficients(theta, g, at);
    const double                     volume = now.volume * theta;
    return now.distortion * (law->energy(*deformation, law_constants(at)) +
                             linear_energy(gradient, g, at)) +
           0.5 * volume * volume / now.compliance;
  }



  template <int dim>
  double
  FiniteStrain<dim>::volume_ratio(const Gradient       &gradient,
                                  const double          pressure,
                                  const double          g,
                                  const PointConstants &at) const
  {
    const auto deformation = at_pressure(gradient, pressure, g, at);
    return deformation ? 1. + deformation->volume_change : not_a_value;
  }



  template <int dim>
  Tensor<2, 3>
  FiniteStrain<dim>::deformation_gradient(const Gradient       &gradient,
                                          const double          pressure,
                                          const double          g,
                                          const PointConstants &at) const
  {
    const auto deformation = at_pressure(gradient, pressure, g, at);
    if (deformation)
      return deformation->gradient;
    Tensor<2, 3> result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        result[i][j] = not_a_value;
    return result;
  }



  template <int dim>
  SymmetricTensor<2, 3>
  FiniteStrain<dim>::cauchy_stress(const Gradient       &gradient,
                                   const double          pressure,
                                   const double          g,
                                   const PointConstants &at) const
  {
    const auto deformation = at_pressure(gradient, pressure, g, at);
    if (!deformation)
      return not_a_value * dealii::unit_symmetric_tensor<3>();
    const Full full = in_space(
      *deformation, pressure, coefficients(pressure, g, at), at, false);
    return symmetrize(full.stress * transpose(deformation->gradient)) /
           (1. + deformation->volume_change);
  }



#define INSTANTIATE(dim)                                                    \
  template double FiniteStrain<dim>::pressure(                              \
    const Tensor<2, dim> &, double, const PointConstants &) const;          \
  template double FiniteStrain<dim>::driving_force(                         \
    const Tensor<2, dim> &, double, double, const PointConstants &) const;  \
  template double FiniteStrain<dim>::elastic_energy(                        \
    const Tensor<2, dim> &, double, double, const PointConstants &) const;  \
  template double FiniteStrain<dim>::pressure_after(                        \
    double, double, double, const PointConstants &, const Tensor<2, dim> &) \
    const;                                                                  \
  template FiniteStrain<dim>::Potential FiniteStrain<dim>::potential(       \
    const Tensor<2, dim> &, double, double, const PointConstants &) const;  \
  template double FiniteStrain<dim>::eliminated_energy(                     \
    const Tensor<2, dim> &, double, const PointConstants &) const;          \
  template double FiniteStrain<dim>::volume_ratio(                          \
    const Tensor<2, dim> &, double, double, const PointConstants &) const;  \
  template Tensor<2, 3> FiniteStrain<dim>::deformation_gradient(            \
    const Tensor<2, dim> &, double, double, const PointConstants &) const;  \
  template SymmetricTensor<2, 3> FiniteStrain<dim>::cauchy_stress(          \
    const Tensor<2, dim> &, double, double, const PointConstants &) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
