// SPDX-License-Identifier: GPL-2.0-or-later
// Plane stress at finite strain (M14): F_33 (no unit) from P_33 = 0 (MPa) at
// each point. J_2 is the determinant of the part in the plane, J = J_2 F_33.
//
// Neo-Hooke with theta = J - 1, p given, q = s p J_2:
//
//   a mu (F_33 - 1/F_33) + q = 0
//   F_33 = 2 a mu/(q + R) = (R - q)/(2 a mu),    R = sqrt(q^2 + 4 a^2 mu^2),
//
// the first for q > 0, the second for q < 0: neither cancels. With p
// eliminated, p = s (J - 1)/compliance and K = s^2/compliance,
//
//   (a mu + K J_2^2) F_33^2 - K J_2 F_33 - a mu = 0.
//
// All other laws and forms: Newton's method for P_33(F_33) = 0, kept between
// bounds. P_33 goes from -infinity (F_33 -> 0, ln J) up to +infinity, though
// not always up on the way: Ogden's law with negative alpha, a softening Yeoh.
// The bounds always have P_33 < 0 on the left and > 0 on the right, so that
// the root between them is passed upwards. A step that leaves them, or comes
// from a slope that is not positive, is replaced by the geometric mean.

#include <model/plane_stress.h>

#include <cmath>
#include <limits>

namespace MixedCracks
{
  double
  neo_hooke_thickness(const double shear, const double transverse)
  {
    const double root = std::hypot(transverse, 2. * shear);
    return transverse > 0. ? 2. * shear / (transverse + root)
                           : (root - transverse) / (2. * shear);
  }



  double
  neo_hooke_thickness(const double shear, const double bulk, const double area)
  {
    const double linear    = bulk * area;
    const double quadratic = shear + bulk * area * area;
    return (linear + std::sqrt(linear * linear + 4. * shear * quadratic)) /
           (2. * quadratic);
  }



  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    struct Bounds
    {
      double lower = 0.;
      double upper = infinity;

      void
      narrow(const double at, const double stress)
      {
        (stress > 0. ? upper : lower) = at;
      }

      // beyond @p at where there is no bound on that side yet
      double
      middle(const double at) const
      {
        if (upper == infinity)
          return 4. * at;
        return lower > 0. ? std::sqrt(lower * upper) : 0.25 * at;
      }
    };
  } // namespace



  double
  thickness_stretch(const TransverseStress &stress, const double start)
  {
    constexpr unsigned int n_steps   = 200;
    constexpr double       tolerance = 1e-14; // some roundings of P_33
    Bounds                 bounds;
    double                 at = start, last_change = infinity;
    for (unsigned int step = 0; step < n_steps; ++step)
    {
      const OutOfPlaneDerivatives here = stress(at);
      if (!std::isfinite(here.first))
        break;
      const double change = -here.first / here.second;
      if (here.second > 0. && std::abs(change) <= tolerance * at)
        return at + change;
      bounds.narrow(at, here.first);
      double next = at + change;
      // slow: less than a halving of the change in each step
      const bool is_slow = std::abs(change) > 0.5 * last_change &&
                           bounds.lower > 0. && bounds.upper < infinity;
      if (!(here.second > 0.) || !(next > bounds.lower) ||
          !(next < bounds.upper) || is_slow)
        next = bounds.middle(at);
      if (next == at || bounds.upper - bounds.lower <= tolerance * at)
        return here.second > 0. ? at : std::nan("");
      last_change = std::abs(next - at);
      at          = next;
    }
    return std::nan("");
  }
} // namespace MixedCracks
