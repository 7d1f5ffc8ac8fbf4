// SPDX-License-Identifier: GPL-2.0-or-later
// How the pressure fades in damaged material. Intact, with tension positive,
//
//   p = lambda tr eps   (MPa).                                            (M2)
//
// Every law is linear in p between the signs of p and is written with four
// coefficients, for one degradation g:
//
//   momentum     sigma = ... + stress * p I
//   constraint   divergence * tr eps - compliance * p = 0
//   phase field  D = ... + driving * <p> tr eps
//
//   law                  where    stress  divergence  compliance        driving
//   relaxed bulk         p > 0    1       1           1/lambda_d        1/g
//                        else     1       1           1/lambda          1
//   degraded divergence  p > 0    g       g           1/lambda          1
//                        else     1       g           1/lambda          1
//   degraded bulk        p > 0    g       1           1/lambda          1
//                        else     1       1           1/lambda          1
//
//   1/lambda_d = 1/lambda + (1-g)/(g c mu),   c: Model/Relaxation constant
//
// With p eliminated, sigma has stress * divergence/compliance * tr eps:
// lambda_d (M8), g^2 lambda (M7), g lambda ('degraded bulk') where p > 0.
//
// Why it matters: lambda/mu is large, 1000 for rubber. With 'degraded bulk' a
// cell with g = 0.01 still has the bulk modulus of 10 mu: the two sides of the
// crack stay together, as the constraint holds them. In (M8) the bulk modulus
// of a broken cell falls to c mu g/(1-g), with the shear modulus g mu: a crack
// opens. The tangent of the mixed formulation is symmetric exactly where stress
// equals divergence, for every g and sign.

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

    // (M8), derived in doc/model.md, section 3: p is the pressure that the
    // material transmits, and its constraint fades,
    //
    //   (tr eps, q) - (p/lambda_d, q) = 0,   sigma = ... + p I.
    //
    // The undegraded pressure is p/g, which is what drives the crack.
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



    // (M7) [Mang21]:  (g tr eps, q) - (p/lambda, q) = 0,  sigma = ... + g <p> I
    // + (p - <p>) I. g stays in the constraint under compression, too.
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



    // (tr eps, q) - (p/lambda, q) = 0,  sigma = ... + g <p> I + (p - <p>) I: p
    // is the pressure of undamaged material with this strain. With p eliminated
    // the usual degraded energy, the only one of the three that is derived from
    // a potential in u and phi together.
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
  } // namespace



  const Registry<PressureLaw> &
  all_pressure_laws()
  {
    using List = Registry<PressureLaw>;
    static const List list(
      "pressure law",
      {{"relaxed bulk",
        "(div u, q) - (1/lambda + (1-g)/(g c mu)) (p, q) = 0 in tension, the "
        "momentum balance carries p; the volumetric constraint fades with the "
        "shear stiffness, so that cracks open",
        List::make_one<RelaxedBulk>},
       {"degraded divergence",
        "g (div u, q) - 1/lambda (p, q) = 0, the momentum balance carries g p "
        "in tension; the law of Mang et al. (2021)",
        List::make_one<DegradedDivergence>},
       {"degraded bulk",
        "(div u, q) - 1/lambda (p, q) = 0, the momentum balance carries g p "
        "in tension; in the displacement formulation the classical law",
        List::make_one<DegradedBulk>}});
    return list;
  }
} // namespace MixedCracks
