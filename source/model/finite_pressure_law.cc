// SPDX-License-Identifier: GPL-2.0-or-later
// How shape and volume of damaged rubber fade. At a fixed degradation g the
// stress P (MPa, 3 x 3) and the constraint are derivatives of the potential
//
//   Pi(F, p) = a W~(F) + s p theta(J) - compliance p^2/2          (MPa)
//   P = dPi/dF = a dW~/dF + s p theta' dJ/dF,
//   dPi/dp = s theta - compliance p = 0,
//
// so that the matrix is symmetric for every law; p is positive in tension.
//
//   law           where   a   s   compliance               driving
//   relaxed bulk  fades   g   1   1/lambda' + (1-g)/(g c mu)   1/g       (M13)
//                 else    g   1   1/lambda'                    0
//   cubic         fades   g   b   1/lambda'                    3 phi     (M13b)
//                 else    g   1   1/lambda'                    0
//
//   g = (1-kappa) phi^2 + kappa,   b = (1-kappa) phi^3 + kappa.
//
// It fades for both signs of p, or with the volumetric split where p > 0. What
// drives the crack (M15) is D = 2 W~ + driving p theta = 2 Psi+:
//
//   relaxed bulk   Psi+ = W~ + p theta/(2 g), as at small strains (M8)
//   cubic          -d/dphi of Pi, over (1-kappa) phi: 2 W~ + 3 phi p theta.
//
// (M13) has no source but (M8); (M13b) is that of Y.-S. Ang, B. Li and
// N. Bouklas.

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
          g, 1., intact + (1. / g - 1.) / (relaxation * moduli.mu), 1. / g};
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
        return {g, (1. - kappa) * phi * phi * phi + kappa, intact, 3. * phi};
      }

    private:
      const double kappa;
    };



    template <typename Law>
    std::unique_ptr<FinitePressureLaw>
    make(const FinitePressureConstants constants)
    {
      return std::make_unique<Law>(constants);
    }
  } // namespace



  const Registry<FinitePressureLaw, FinitePressureConstants> &
  all_finite_pressure_laws()
  {
    static const Registry<FinitePressureLaw, FinitePressureConstants> list(
      "pressure law at finite strain",
      {{"relaxed bulk",
        "(J - 1, q) - (1/lambda' + (1-g)/(g c mu)) (p, q) = 0, the momentum "
        "balance carries p; the volumetric constraint fades with the shear "
        "stiffness, so that cracks open",
        make<RelaxedBulk>},
       {"cubic",
        "b (J - 1, q) - 1/lambda' (p, q) = 0, the momentum balance carries b "
        "p, b = (1-kappa) phi^3 + kappa (Ang, Li and Bouklas)",
        make<Cubic>}});
    return list;
  }
} // namespace MixedCracks
