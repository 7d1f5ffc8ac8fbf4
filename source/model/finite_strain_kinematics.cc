// SPDX-License-Identifier: GPL-2.0-or-later
// F (3 x 3, no unit) of rubber at one point, (M11): grad u + I, and F_33 = 1 in
// plane strain. In plane stress F_33 > 0 is that for which (M14), MPa,
//
//   P_33 = a dW~/dF_33 + s p theta' J_2 = 0,               p given, or
//   P_33 = a dW~/dF_33 + s^2/c theta theta' J_2 = 0,       p = s theta/c,
//
// with J = J_2 F_33, J_2 the determinant of the part in the plane (a, s, c,
// theta as in finite_strain.cc; plane_stress.cc solves). No F where J_2 <= 0
// or there is no root. In damaged material gamma(g) grad u stands for grad u
// throughout (energy_interpolation.cc).

#include <model/energy_interpolation.h>
#include <model/finite_strain.h>
#include <model/gradient_in_space.h>
#include <model/plane_stress.h>

namespace MixedCracks
{
  using dealii::Tensor;

  // Contact of the sides of a crack is what a split of the pressure is for:
  // such material keeps its law however broken it is.
  template <int dim>
  double
  FiniteStrain<dim>::share_of_law(const double g) const
  {
    return resists_closure ? 1. : nonlinear_share(g);
  }



  template <int dim>
  double
  FiniteStrain<dim>::determinant(const Gradient &gradient, const double g) const
  {
    return determinant_of<dim>(share_of_law(g) * gradient);
  }



  // F_33 from P_33 = 0 where p is given: in closed form for neo-Hooke, from
  // which the search for other laws starts
  template <int dim>
  double
  FiniteStrain<dim>::stretch_at_pressure(const Gradient       &gradient,
                                         const double          pressure,
                                         const double          g,
                                         const PointConstants &at) const
  {
    const double                     area       = determinant_of(gradient);
    const HyperelasticConstants      constants  = law_constants(at);
    const FinitePressureCoefficients now        = coefficients(pressure, g, at);
    const double                     transverse = now.volume * pressure * area;
    const double                     start =
      neo_hooke_thickness(now.distortion * law->mu(constants), transverse);
    if (law->is_neo_hooke() && form->is_linear())
      return start;
    return thickness_stretch(
      [&](const double stretch) {
        const Deformation   here(gradient_in_space(gradient, stretch));
        const VolumeMeasure theta = form->measure(here.volume_change);
        const auto          shape = law->out_of_plane(here, constants);
        return OutOfPlaneDerivatives{
          now.distortion * shape.first + transverse * theta.first,
          now.distortion * shape.second + transverse * area * theta.second};
      },
      start);
  }



  // F_33 where p = s theta/c. The sign of theta decides on s and c: for
  // neo-Hooke it is that of J_2 - 1, since P_33 at J = 1 is a mu (1/J_2 - J_2).
  template <int dim>
  double
  FiniteStrain<dim>::stretch_at_constraint(const Gradient       &gradient,
                                           const double          g,
                                           const PointConstants &at) const
  {
    const double                area      = determinant_of(gradient);
    const HyperelasticConstants constants = law_constants(at);
    const auto bulk = [](const FinitePressureCoefficients &now) {
      return now.volume * now.volume / now.compliance;
    };
    const FinitePressureCoefficients expected = coefficients(area - 1., g, at);
    const double                     start    = neo_hooke_thickness(
      expected.distortion * law->mu(constants), bulk(expected), area);
    if (law->is_neo_hooke() && form->is_linear())
      return start;
    return thickness_stretch(
      [&](const double stretch) {
        const Deformation   here(gradient_in_space(gradient, stretch));
        const VolumeMeasure theta = form->measure(here.volume_change);
        const auto          now   = coefficients(theta.value, g, at);
        const auto          shape = law->out_of_plane(here, constants);
        const double        K     = bulk(now);
        return OutOfPlaneDerivatives{
          now.distortion * shape.first + K * theta.value * theta.first * area,
          now.distortion * shape.second +
            K * (theta.first * theta.first + theta.value * theta.second) *
              area * area};
      },
      start);
  }



  template <int dim>
  std::optional<Deformation>
  FiniteStrain<dim>::at_pressure(const Gradient       &gradient,
                                 const double          pressure,
                                 const double          g,
                                 const PointConstants &at) const
  {
    if (!(determinant(gradient, g) > 0.))
      return {};
    const Gradient scaled = share_of_law(g) * gradient;
    const double   stretch =
      plane_stress ? stretch_at_pressure(scaled, pressure, g, at) : 1.;
    if (!(stretch > 0.))
      return {};
    return Deformation(gradient_in_space(scaled, stretch));
  }



  template <int dim>
  std::optional<Deformation>
  FiniteStrain<dim>::at_constraint(const Gradient       &gradient,
                                   const double          g,
                                   const PointConstants &at) const
  {
    if (!(determinant(gradient, g) > 0.))
      return {};
    const Gradient scaled = share_of_law(g) * gradient;
    const double   stretch =
      plane_stress ? stretch_at_constraint(scaled, g, at) : 1.;
    if (!(stretch > 0.))
      return {};
    return Deformation(gradient_in_space(scaled, stretch));
  }



#define INSTANTIATE(dim)                                                   \
  template double FiniteStrain<dim>::share_of_law(double) const;           \
  template double FiniteStrain<dim>::determinant(const Tensor<2, dim> &,   \
                                                 double) const;            \
  template double FiniteStrain<dim>::stretch_at_pressure(                  \
    const Tensor<2, dim> &, double, double, const PointConstants &) const; \
  template double FiniteStrain<dim>::stretch_at_constraint(                \
    const Tensor<2, dim> &, double, const PointConstants &) const;         \
  template std::optional<Deformation> FiniteStrain<dim>::at_pressure(      \
    const Tensor<2, dim> &, double, double, const PointConstants &) const; \
  template std::optional<Deformation> FiniteStrain<dim>::at_constraint(    \
    const Tensor<2, dim> &, double, const PointConstants &) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
