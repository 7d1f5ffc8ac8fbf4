// SPDX-License-Identifier: GPL-2.0-or-later
// Broken cells at finite strain. With g near kappa they carry nothing, are
// stretched a hundredfold and distorted at will, and Newton's method does not
// get past them: -g mu ln J is infinite where a cell turns inside out, however
// small g is, so that every step ends at the first quadrature point with
// det F = 0. Their energy is therefore interpolated (F. Wang, B. S. Lazarov,
// O. Sigmund, J. S. Jensen, Comput. Methods Appl. Mech. Engrg. 276 (2014), who
// do it for the void of topology optimisation),
//
//   Pi(H, p) -> Pi(gamma H, p) + (1 - gamma^2) g mu/2 |H|^2,   H = grad u,
//
// MPa, with gamma(g) from 1 down to 0: the law of (M12) and (M13) where the
// material is damaged but whole, g mu/2 |H|^2 where it is broken, convex and
// finite for every H. At large stretches both are g mu/2 |F|^2. What must
// remain positive is det(I + gamma H).
//
//   gamma = x^2 (3 - 2x),   x = (g - 0.04)/(0.25 - 0.04) within [0, 1]:
//
// phi from 0.2 to 0.5. doc/model.md has what this does and what was measured.

#include <model/energy_interpolation.h>

#include <algorithm>

namespace MixedCracks
{
  namespace
  {
    constexpr double g_of_broken = 0.04;
    constexpr double g_of_whole  = 0.25;
  } // namespace



  double
  nonlinear_share(const double degradation)
  {
    const double x = std::clamp(
      (degradation - g_of_broken) / (g_of_whole - g_of_broken), 0., 1.);
    return x * x * (3. - 2. * x);
  }
} // namespace MixedCracks
