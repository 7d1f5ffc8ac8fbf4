// SPDX-License-Identifier: GPL-2.0-or-later
// The strength that follows from G_c, l, the crack density and the degradation
// with kappa = 0. A bar of Young's modulus E (MPa) under uniaxial stress, phi
// the same everywhere, all of its energy degraded: D = 2 psi+ = E eps^2, and
// the phase-field equation g'/2 D = - a'(phi) G_c/l gives
//
//   eps = sqrt(-2 a'(phi)/g'(phi)) sqrt(G_c/(E l)),    sigma = g(phi) E eps.
//
// The strength is the maximum of sigma over 0 <= phi <= 1; with g = phi^2 of
// sqrt(-a' phi^3):
//
//   AT1   -a' = 3/8         phi = 1     sqrt(3/8)     = 0.612
//   AT2   -a' = 1 - phi     phi = 3/4   sqrt(27/256)  = 0.325  (= 3 sqrt(3)/16)
//   Wu    -a' = 2 phi/pi    phi = 1     sqrt(2/pi)    = 0.798
//
// times sqrt(E G_c/l): the length scale is a constant of the material, l =
// (value)^2 E G_c/sigma_c^2.

#include <model/strength.h>

#include <cmath>

namespace MixedCracks
{
  Strength
  relative_strength(const CrackDensity &density, const Degradation &degradation)
  {
    // the maximum is flat, so that this is exact to 6 digits
    constexpr unsigned int n_samples = 1000;
    Strength               result{0., 0.};
    for (unsigned int i = 1; i <= n_samples; ++i)
    {
      const double phi    = static_cast<double>(i) / n_samples;
      const double strain = std::sqrt(-2. * density.local_derivative(phi) /
                                      degradation.derivative(phi));
      const double stress = degradation.value(phi) * strain;
      if (stress > result.stress)
        result = {stress, strain};
    }
    return result;
  }
} // namespace MixedCracks
