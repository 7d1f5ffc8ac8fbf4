// SPDX-License-Identifier: GPL-2.0-or-later
// Broken cells at finite strain. With g near kappa they carry nothing, are
// stretched a hundredfold and distorted at will, and Newton's method does not
// get past them: -g mu ln J is infinite where a cell turns inside out, however
// small g is, so that every step ends at the first quadrature point with
// det F = 0. Their energy is therefore interpolated (F. Wang, B. S. Lazarov,
// O. Sigmund, J. S. Jensen, Comput. Methods Appl. Mech. Engrg. 276 (2014), who
// do it for the void of topology optimisation),
//
//   Pi(H, p) -> Pi(gamma H, p) + (1 - gamma^2) g mu_L/2 |H|^2,   H = grad u,
//
// MPa, with gamma(g) from 1 down to 0: the law of (M12) and (M13) where the
// material is damaged but whole, g mu_L/2 |H|^2 where it is broken, convex and
// finite for every H. What must remain positive is det(I + gamma H). At the
// stretches of a crack's tip the linear part should be as stiff as the law,
// whose onset it would shift: mu_L is that of the neo-Hookean bar with the
// stress that an incompressible one of the law has at L = 5, in tension,
//
//   mu_L (L - 1/L^2) = P_11 - P_22 L^(-3/2),   P = dW~/dF.
//
//   gamma = x^2 (3 - 2x),   x = (g - 0.04)/(0.25 - 0.04) within [0, 1]:
//
// phi from 0.2 to 0.5. doc/model.md has what this does and what was measured.

#include <model/energy_interpolation.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace
  {
    constexpr double g_of_broken = 0.04;
    constexpr double g_of_whole  = 0.25;

    // L
    constexpr double stretch_of_tip = 5.;
  } // namespace



  double
  nonlinear_share(const double degradation)
  {
    const double x = std::clamp(
      (degradation - g_of_broken) / (g_of_whole - g_of_broken), 0., 1.);
    return x * x * (3. - 2. * x);
  }



  double
  linear_modulus(const HyperelasticLaw       &law,
                 const HyperelasticConstants &constants)
  {
    dealii::Tensor<2, 3> F;
    F[0][0] = stretch_of_tip;
    F[1][1] = F[2][2] = 1. / std::sqrt(stretch_of_tip);
    const auto P      = law.response(Deformation(F), constants, false).stress;
    return (P[0][0] - P[1][1] * F[1][1] / F[0][0]) /
           (F[0][0] - F[1][1] * F[1][1] / F[0][0]);
  }
} // namespace MixedCracks
