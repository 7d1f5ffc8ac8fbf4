// SPDX-License-Identifier: GPL-2.0-or-later
#include <model/pressure_law.h>

#include <algorithm>

namespace MixedCracks
{
  namespace
  {
    // With kappa = 0 there are points without any stiffness. What the law
    // divides by g goes on from here as if g were this: p vanishes then, to
    // rounding, and stays a number.
    constexpr double smallest_degradation = 1e-12;

    // (M8): p is what the material transmits; its constraint fades instead
    class RelaxedBulk : public PressureLaw
    {
    public:
      PressureCoefficients
      coefficients(const PointConstants &at,
                   const double          relaxation,
                   const double          g,
                   const bool            tension) const override
      {
        const double intact_compliance = 1. / at.lambda;
        if (!tension)
          return {1., 1., intact_compliance, 1.};
        const double added_compliance = 1. / (relaxation * at.mu);
        const double inverse_g        = 1. / std::max(g, smallest_degradation);
        return {1.,
                1.,
                intact_compliance + (inverse_g - 1.) * added_compliance,
                inverse_g};
      }

      bool
      is_symmetric() const override
      {
        return true;
      }
    };



    // (M7), as printed in [Mang21]
    class DegradedDivergence : public PressureLaw
    {
    public:
      PressureCoefficients
      coefficients(const PointConstants &at,
                   const double,
                   const double g,
                   const bool   tension) const override
      {
        return {tension ? g : 1., g, 1. / at.lambda, 1.};
      }

      bool
      is_symmetric() const override
      {
        return false; // in compression
      }
    };



    // p is the pressure of the undamaged material, its stress is degraded
    class DegradedBulk : public PressureLaw
    {
    public:
      PressureCoefficients
      coefficients(const PointConstants &at,
                   const double,
                   const double g,
                   const bool   tension) const override
      {
        return {tension ? g : 1., 1., 1. / at.lambda, 1.};
      }

      bool
      is_symmetric() const override
      {
        return false; // in tension
      }
    };



    template <typename Law>
    std::unique_ptr<PressureLaw>
    make()
    {
      return std::make_unique<Law>();
    }
  } // namespace



  const Registry<PressureLaw> &
  all_pressure_laws()
  {
    static const Registry<PressureLaw> list(
      "pressure law",
      {{"relaxed bulk",
        "(div u, q) - (1/lambda + (1-g)/(g c mu)) (p, q) = 0 in tension, the "
        "momentum balance carries p; the volumetric constraint fades with the "
        "shear stiffness, so that cracks open",
        make<RelaxedBulk>},
       {"degraded divergence",
        "g (div u, q) - 1/lambda (p, q) = 0, the momentum balance carries g p "
        "in tension; the law of Mang et al. (2021)",
        make<DegradedDivergence>},
       {"degraded bulk",
        "(div u, q) - 1/lambda (p, q) = 0, the momentum balance carries g p "
        "in tension; in the displacement formulation the classical law",
        make<DegradedBulk>}});
    return list;
  }
} // namespace MixedCracks
