// SPDX-License-Identifier: GPL-2.0-or-later
// A bar at finite strain, from the energy of the law alone: along
// incompressible states the pressure does no work, so that the nominal stress
// is dW/ds, taken by differences.
//
// Strength with kappa = 0, phi the same everywhere:
//
//   g'(phi) W(s) = - a'(phi) G_c/l,   P = g(phi) W'(s),   maximal over phi.
//
// At small strains W = E eps^2/2, and P is that of model/strength.h. Where the
// material is intact up to the strength, as with AT1 and Wu and g = phi^2, phi
// = 1 there: W = 3/16 G_c/l and G_c/(pi l).

#include <simulation/rubber_bar.h>

#include <cmath>

namespace MixedCracks
{
  namespace
  {
    // Beyond, 1/sqrt(s) is lost in F_22 - 1; every law goes on as neo-Hooke
    // there, W in proportion to s^2.
    constexpr double farthest_stretch = 1e4;
  } // namespace



  double
  RubberBar::energy(const double stretch) const
  {
    if (stretch > farthest_stretch)
    {
      const double factor = stretch / farthest_stretch;
      return energy(farthest_stretch) * factor * factor;
    }
    dealii::Tensor<2, 3> gradient;
    gradient[0][0] = stretch - 1.;
    gradient[1][1] = 1. / std::sqrt(stretch) - 1.;
    gradient[2][2] = gradient[1][1];
    return law.elastic_energy(gradient, 0., 1., constants);
  }



  double
  RubberBar::nominal_stress(const double stretch) const
  {
    const double h = 1e-5 * stretch;
    return (energy(stretch + h) - energy(stretch - h)) / (2. * h);
  }



  double
  RubberBar::stretch_of_energy(const double wanted) const
  {
    const double most = energy(farthest_stretch);
    if (!(wanted < most))
      return farthest_stretch * std::sqrt(wanted / most);
    double below = 0., above = std::log(farthest_stretch);
    for (unsigned int i = 0; i < 50; ++i)
    {
      const double middle = 0.5 * (below + above);
      (energy(std::exp(middle)) < wanted ? below : above) = middle;
    }
    return std::exp(0.5 * (below + above));
  }



  std::optional<double>
  RubberBar::stretch_of_decline(const double largest) const
  {
    constexpr unsigned int n_samples = 200;
    constexpr double       rounding  = 1e-6;
    double                 before    = 0.;
    for (unsigned int i = 1; i <= n_samples; ++i)
    {
      const double stretch = 1. + (largest - 1.) * i / n_samples;
      const double now     = nominal_stress(stretch);
      if (now < before * (1. - rounding))
        return stretch;
      before = now;
    }
    return {};
  }



  RubberStrength
  rubber_strength(const RubberBar    &bar,
                  const CrackDensity &density,
                  const Degradation  &degradation,
                  const double        energy)
  {
    constexpr unsigned int n_samples = 100;
    RubberStrength         result{0., 1.};
    for (unsigned int i = 1; i <= n_samples; ++i)
    {
      const double phi     = static_cast<double>(i) / n_samples;
      const double stretch = bar.stretch_of_energy(
        -density.local_derivative(phi) * energy / degradation.derivative(phi));
      if (!std::isfinite(stretch))
        continue;
      const double stress =
        degradation.value(phi) * bar.nominal_stress(stretch);
      // equal ones of a flat maximum: the last, of the least damage
      if (stress >= result.stress * (1. - 1e-9))
        result = {stress, stretch};
    }
    return result;
  }
} // namespace MixedCracks
