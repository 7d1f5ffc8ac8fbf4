// SPDX-License-Identifier: GPL-2.0-or-later
// The crack surface as an integral over the body.
//
// The surface of a crack is replaced by
//
//   integral of gamma(phi, grad phi) dx,   gamma = a(phi)/l + b l |grad phi|^2,
//
// a length per mm of thickness (in 3-d an area, mm^2); gamma in 1/mm, phi = 1
// where the material is intact and 0 where it is broken, l the length scale
// (mm), a(1) = 0; a and b have no unit. Times G_c it is the energy of the
// crack, the second term of (M1):
//
//   E(u, phi) = integral of  g(phi) psi+ + psi-  +  G_c gamma  dx.
//
// Across a straight crack, phi(0) = 0 and phi = 1 far away, the least integral
// is that of the profile for which both terms are equal,
//
//   a(phi)/l = b l (dphi/dx)^2,   that is   dphi/dx = sqrt(a(phi)/b) / l,
//
// and its value, with both sides of the crack,
//
//   2 integral_0^1 2 sqrt(a b) dphi = 4 sqrt(b) integral_0^1 sqrt(a(s)) ds.
//
// a and b are scaled such that this is 1: G_c is what a crack costs per
// surface.
//
//   name   a(phi)          b      phi at the distance x       band ends at
//   AT2    (1-phi)^2 / 2   1/2    1 - exp(-x/l)               nowhere
//   AT1    3 (1-phi) / 8   3/8    1 - (1 - x/(2l))^2          2 l
//   Wu     (1-phi^2) / pi  1/pi   sin(x/l)                    pi l / 2
//
// Where phi is the same everywhere, the phase-field equation says
//
//   g'(phi)/2 * 2 psi+  =  - a'(phi) G_c / l.
//
// With a'(1) < 0 (AT1, Wu) nothing breaks before 2 psi+ reaches -a'(1) G_c/l
// over g'(1)/2; with a'(1) = 0 (AT2) damage begins with the first load.
//
// What a'' is decides how hard the problem for phi is at given displacements:
// a'' > 0 convex (AT2), 0 (AT1), < 0 (Wu): there the operator can be
// indefinite.

#include <model/crack_density.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <limits>

namespace MixedCracks
{
  namespace
  {
    using dealii::numbers::PI;

    // [Bourdin00], the functional of Ambrosio and Tortorelli: quadratic and
    // convex,
    //
    //   a = (1-phi)^2/2,   a' = phi - 1,   a'' = 1,   b = 1/2.
    class AT2 : public CrackDensity
    {
    public:
      double
      local(const double phi) const override
      {
        return 0.5 * (1. - phi) * (1. - phi);
      }

      double
      local_derivative(const double phi) const override
      {
        return phi - 1.;
      }

      double
      local_second_derivative(const double) const override
      {
        return 1.;
      }

      Curvature
      curvature() const override
      {
        return {1., 1.};
      }

      double
      gradient_coefficient() const override
      {
        return 0.5;
      }

      double
      optimal_profile(const double distance_over_length) const override
      {
        return -std::expm1(-std::abs(distance_over_length));
      }

      double
      half_width() const override
      {
        return std::numeric_limits<double>::infinity();
      }
    };



    // [Bourdin14]: linear, so that there is an elastic stage,
    //
    //   a = 3/8 (1-phi),   a' = -3/8,   a'' = 0,   b = 3/8.
    class AT1 : public CrackDensity
    {
    public:
      double
      local(const double phi) const override
      {
        return 0.375 * (1. - phi);
      }

      double
      local_derivative(const double) const override
      {
        return -0.375;
      }

      double
      local_second_derivative(const double) const override
      {
        return 0.;
      }

      Curvature
      curvature() const override
      {
        return {0., 0.};
      }

      double
      gradient_coefficient() const override
      {
        return 0.375;
      }

      double
      optimal_profile(const double distance_over_length) const override
      {
        const double to_edge =
          1. - std::min(std::abs(distance_over_length) / half_width(), 1.);
        return 1. - to_edge * to_edge;
      }

      double
      half_width() const override
      {
        return 2.;
      }
    };



    // [Wu17]: his geometric function 2d - d^2 of the damage d = 1 - phi,
    //
    //   a = (1-phi^2)/pi,   a' = -2 phi/pi,   a'' = -2/pi,   b = 1/pi.
    //
    // This is not his cohesive zone model (PF-CZM). That one has a rational
    // degradation, whose parameters come from a softening law and from l, such
    // that the strength does not depend on l. With the quadratic degradation
    // the strength is sqrt(2/pi) sqrt(E G_c/l) and l is a constant of the
    // material, as with AT1. Its operator for phi is concave, which is why phi
    // >= 0 has to be imposed.
    class Wu : public CrackDensity
    {
    public:
      double
      local(const double phi) const override
      {
        return (1. - phi * phi) / PI;
      }

      double
      local_derivative(const double phi) const override
      {
        return -2. * phi / PI;
      }

      double
      local_second_derivative(const double) const override
      {
        return -2. / PI;
      }

      Curvature
      curvature() const override
      {
        return {-2. / PI, -2. / PI};
      }

      double
      gradient_coefficient() const override
      {
        return 1. / PI;
      }

      double
      optimal_profile(const double distance_over_length) const override
      {
        return std::sin(std::min(std::abs(distance_over_length), half_width()));
      }

      double
      half_width() const override
      {
        return 0.5 * PI;
      }
    };
  } // namespace



  const Registry<CrackDensity> &
  all_crack_densities()
  {
    using List = Registry<CrackDensity>;
    static const List list(
      "crack density",
      {{"Wu",
        "(2 (1-phi) - (1-phi)^2) / (pi l) + l/pi |grad phi|^2, with an "
        "elastic stage; band of half width pi l / 2; with the quadratic "
        "degradation this is not the PF-CZM",
        List::make_one<Wu>},
       {"AT1",
        "3/8 ((1-phi)/l + l |grad phi|^2), with an elastic stage; band of "
        "half width 2 l",
        List::make_one<AT1>},
       {"AT2",
        "(1-phi)^2 / (2 l) + l/2 |grad phi|^2, damage from the first load "
        "on; band without an edge",
        List::make_one<AT2>}});
    return list;
  }
} // namespace MixedCracks
