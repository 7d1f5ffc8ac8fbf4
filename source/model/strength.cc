// SPDX-License-Identifier: GPL-2.0-or-later
// The strength that follows from G_c, l and the crack density with the
// quadratic degradation, kappa = 0. A bar of Young's modulus E (MPa) under
// uniaxial stress, phi the same everywhere, all of its energy degraded: D = 2
// psi+ = E eps^2, and the phase-field equation g'/2 D = - a'(phi) G_c/l with g
// = phi^2 gives
//
//   phi E eps^2 = - a'(phi) G_c/l,
//   sigma = phi^2 E eps = sqrt(- a'(phi) phi^3) sqrt(E G_c/l),
//   eps = sigma/(phi^2 E).
//
// The strength is the maximum over 0 <= phi <= 1:
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
  relative_strength(const CrackDensity &density)
  {
    // the maximum is flat, so that this is exact to 6 digits
    constexpr unsigned int n_samples = 1000;
    double                 largest = 0., at = 1.;
    for (unsigned int i = 1; i <= n_samples; ++i)
    {
      const double phi    = static_cast<double>(i) / n_samples;
      const double square = -density.local_derivative(phi) * phi * phi * phi;
      if (square > largest)
      {
        largest = square;
        at      = phi;
      }
    }
    return {std::sqrt(largest), std::sqrt(largest) / (at * at)};
  }
} // namespace MixedCracks
