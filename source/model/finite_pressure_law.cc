// SPDX-License-Identifier: GPL-2.0-or-later
// How shape and volume of damaged rubber fade. At a fixed degradation g the
// stress P (MPa, 3 x 3) and the constraint are derivatives of the potential
//
//   Pi(F, p) = a W~(F) + s p theta(J) - compliance p^2/2          (MPa)
//   P = dPi/dF = a dW~/dF + s p theta' dJ/dF,
//   dPi/dp = s theta - compliance p = 0,
//
// so that the matrix is symmetric for every law; p is positive in tension. It
// is the pressure of the undamaged part of the material: s p is transmitted.
//
//   law           where   a   s    compliance                 driving
//   relaxed bulk  fades   g   g    g^2/lambda' + g(1-g)/(c mu)   1      (M13)
//                 else    g   1    1/lambda'                     0
//   cubic         fades   g   b^2  b^2/lambda'                   3 b phi (M13b)
//                 else    g   1    1/lambda'                     0
//
//   g = (1-kappa) phi^2 + kappa,   b = (1-kappa) phi^3 + kappa.
//
// (M13) and (M13b) are written with the transmitted pressure s p (b p for the
// cubic law) and say the same at a point. As the continuous unknown this p does
// better: g falls by four orders of magnitude within a cell beside a crack, and
// so does s p, which linear elements cannot follow; in plane stress, where F_33
// depends on s p/g, that made the cells beside a crack collapse.
//
// It fades for both signs of p, or with the volumetric split where p > 0. What
// drives the crack (M15) is D = 2 W~ + driving p theta = 2 Psi+:
//
//   relaxed bulk   Psi+ = W~ + p theta/2, as at small strains (M8)
//   cubic          -d/dphi of aW~ + b (bp) theta - (bp)^2/(2 lambda') at a
//   fixed
//                  bp, over (1-kappa) phi: 2 W~ + 3 phi b p theta.
//
// (M13) has no source but (M8); (M13b) is that of I. Ang, N. Bouklas and B. Li,
// Int. J. Numer. Methods Engrg. 123 (2022).

#include <model/finite_pressure_law.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace
  {
    // With kappa = 0 there are points without any stiffness, and F_33 of plane
    // stress is not defined there. What is divided by g goes on from here as
    // if g were this.
    constexpr double smallest_degradation = 1e-12;

    class RelaxedBulk : public FinitePressureLaw
    {
    public:
      explicit RelaxedBulk(const FinitePressureConstants &constants)
        : relaxation(constants.relaxation)
      {}

      FinitePressureCoefficients
      coefficients(const FiniteModuli &moduli,
                   const double        degradation,
                   const bool          fades) const override
      {
        const double g      = std::max(degradation, smallest_degradation);
        const double intact = 1. / moduli.volumetric;
        if (!fades)
          return {g, 1., intact, 0.};
        return {
          g, g, g * (g * intact + (1. - g) / (relaxation * moduli.mu)), 1.};
      }

    private:
      const double relaxation;
    };



    class Cubic : public FinitePressureLaw
    {
    public:
      explicit Cubic(const FinitePressureConstants &constants)
        : kappa(constants.residual_stiffness)
      {}

      FinitePressureCoefficients
      coefficients(const FiniteModuli &moduli,
                   const double        degradation,
                   const bool          fades) const override
      {
        const double g      = std::max(degradation, smallest_degradation);
        const double intact = 1. / moduli.volumetric;
        if (!fades)
          return {g, 1., intact, 0.};
        const double phi =
          std::sqrt(std::max(degradation - kappa, 0.) / (1. - kappa));
        const double b = std::max((1. - kappa) * phi * phi * phi + kappa,
                                  smallest_degradation);
        return {g, b * b, b * b * intact, 3. * b * phi};
      }

    private:
      const double kappa;
    };
  } // namespace



  const Registry<FinitePressureLaw, FinitePressureConstants> &
  all_finite_pressure_laws()
  {
    using List = Registry<FinitePressureLaw, FinitePressureConstants>;
    static const List list(
      "pressure law at finite strain",
      {{"relaxed bulk",
        "g (J - 1, q) - (g^2/lambda' + g(1-g)/(c mu)) (p, q) = 0, the momentum "
        "balance carries g p; the volumetric constraint fades with the shear "
        "stiffness, so that cracks open",
        List::make_one<RelaxedBulk>},
       {"cubic",
        "b^2 (J - 1, q) - b^2/lambda' (p, q) = 0, the momentum balance carries "
        "b^2 p, b = (1-kappa) phi^3 + kappa (Ang, Li and Bouklas)",
        List::make_one<Cubic>}});
    return list;
  }
} // namespace MixedCracks
