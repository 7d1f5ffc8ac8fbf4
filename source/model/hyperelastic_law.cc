// SPDX-License-Identifier: GPL-2.0-or-later
// The laws of rubber of (M12), W~(F) in MPa, F = I + grad u (3 x 3, no unit):
//
//   law            f(I1) + h(I2)                        mu             lambda_W
//   neo-Hooke      (mu/2)(I1-3)                         mu             0
//   Mooney-Rivlin  C10 (I1-3) + C01 (I2-3)              2 (C10+C01)    4 C01
//   Yeoh           C10 x + C20 x^2 + C30 x^3, x = I1-3  2 C10          8 C20
//   Gent           -(mu Jm/2) ln(1 - (I1-3)/Jm)         mu             2 mu/Jm
//   Ogden          sum mu_i/alpha_i (lambda_a^alpha_i - 1)             0
//
// each with - m ln J that makes F = I free of stress, or in the isochoric form
// (invariant_law.cc, ogden_law.cc). Sources: M. Mooney, J. Appl. Phys. 11
// (1940); R. S. Rivlin, Phil. Trans. R. Soc. A 241 (1948); O. H. Yeoh, Rubber
// Chem. Technol. 66 (1993); A. N. Gent, Rubber Chem. Technol. 69 (1996);
// R. W. Ogden, Proc. R. Soc. A 326 (1972).
//
// Beyond the stretch of use L every law goes on as neo-Hooke, continuous with
// its slope. Those of f: linear in I1 beyond I1* = L^2 + 2/L; Gent's already
// beyond 95 % of its barrier, where its stiffness is 20 mu, if that comes
// first. h of Mooney-Rivlin: linear in |cof F| = sqrt(I2) beyond the I2* of the
// equibiaxial stretch L, L^4 + 2/L^2. I2 grows with the fourth power of a
// biaxial stretch, |cof F| with the second, as neo-Hooke; it is a norm of
// cof F, hence convex in it, and so is h: quadratic, then a tangent to the
// quadratic. I2 of the uniaxial stretch would be too early: an equibiaxial one
// has it at 1.8.

#include <model/hyperelastic_law.h>
#include <model/invariant_law.h>
#include <model/ogden_law.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  OutOfPlaneDerivatives
  HyperelasticLaw::out_of_plane(const Deformation           &deformation,
                                const HyperelasticConstants &constants) const
  {
    const HyperelasticResponse all = response(deformation, constants, true);
    return {all.stress[2][2], all.tangent[2][2][2][2]};
  }



  double
  HyperelasticLaw::tensile_energy(const Deformation &,
                                  const HyperelasticConstants &) const
  {
    Assert(false, dealii::ExcMessage("This law is no sum over stretches."));
    return 0.;
  }



  namespace
  {
    std::string
    not_positive(const std::string &name)
    {
      return name + " must be above 0";
    }

    // Linear in I1, so that its continuation is itself.
    class NeoHooke : public InvariantLaw
    {
    public:
      using InvariantLaw::InvariantLaw;

      std::vector<std::string>
      constant_names() const override
      {
        return {"mu"};
      }

      std::string
      problem(const HyperelasticConstants &constants) const override
      {
        return constants[0] > 0. ? "" : not_positive("mu");
      }

      bool
      is_sum_over_stretches() const override
      {
        return true;
      }

      bool
      is_neo_hooke() const override
      {
        return !form.isochoric;
      }

      // w(lambda) = (mu/2)(lambda^2 - 1) - mu ln lambda, with lambda
      // J^(-1/3) in the isochoric form, whose logarithms cancel in the sum
      double
      tensile_energy(const Deformation           &deformation,
                     const HyperelasticConstants &constants) const override
      {
        const double mean = form.isochoric ? deformation.log_volume / 3. : 0.;
        double       sum  = 0.;
        for (const double log : PrincipalStretches(deformation).logarithms)
        {
          const double x = std::max(log - mean, 0.);
          sum += constants[0] * (0.5 * std::expm1(2. * x) - x);
        }
        return sum;
      }

    protected:
      Curve
      of_first(const double                 excess,
               const HyperelasticConstants &constants) const override
      {
        return {0.5 * constants[0] * excess, 0.5 * constants[0], 0.};
      }
    };



    // C10, C01 not negative: with a negative one the energy is not convex, in
    // the sense of Ball, at large stretches.
    class MooneyRivlin : public InvariantLaw
    {
    public:
      explicit MooneyRivlin(const HyperelasticForm &form)
        : InvariantLaw(form)
        , last_second(std::pow(form.largest_stretch, 4) +
                      2. / std::pow(form.largest_stretch, 2))
      {}

      std::vector<std::string>
      constant_names() const override
      {
        return {"C10", "C01"};
      }

      std::string
      problem(const HyperelasticConstants &constants) const override
      {
        if (!(constants[0] >= 0. && constants[1] >= 0.))
          return "neither C10 nor C01 may be negative";
        return constants[0] + constants[1] > 0. ? ""
                                                : not_positive("C10 + C01");
      }

    protected:
      Curve
      of_first(const double                 excess,
               const HyperelasticConstants &constants) const override
      {
        return {constants[0] * excess, constants[0], 0.};
      }

      Curve
      of_second(const double                 excess,
                const HyperelasticConstants &constants) const override
      {
        const double C01 = constants[1];
        if (excess + 3. <= last_second)
          return {C01 * excess, C01, 0.};
        const double last  = std::sqrt(last_second);
        const double root  = std::sqrt(excess + 3.);
        const double first = C01 * last / root;
        return {C01 * (last_second - 3. + 2. * last * (root - last)),
                first,
                -0.5 * first / (root * root)};
      }

      bool
      has_second() const override
      {
        return true;
      }

    private:
      const double last_second;
    };



    // The slope f' = C10 + 2 C20 x + 3 C30 x^2 has to stay positive up to the
    // stretch of use, in its continuation it is constant.
    class Yeoh : public InvariantLaw
    {
    public:
      using InvariantLaw::InvariantLaw;

      std::vector<std::string>
      constant_names() const override
      {
        return {"C10", "C20", "C30"};
      }

      std::string
      problem(const HyperelasticConstants &constants) const override
      {
        if (!(constants[0] > 0.))
          return not_positive("C10");
        double smallest = of_first(reach_of_use, constants).first;
        if (constants[2] != 0.)
        {
          const double lowest = -constants[1] / (3. * constants[2]);
          if (lowest > 0. && lowest < reach_of_use)
            smallest = std::min(smallest, of_first(lowest, constants).first);
        }
        return smallest > 0.
                 ? ""
                 : "C10 + 2 C20 x + 3 C30 x^2 must be above 0 for all x = I1 - "
                   "3 up to the largest stretch";
      }

    protected:
      Curve
      of_first(const double                 x,
               const HyperelasticConstants &constants) const override
      {
        const auto [C10, C20, C30, a, b, c] = constants;
        (void)a, (void)b, (void)c;
        return {x * (C10 + x * (C20 + x * C30)),
                C10 + x * (2. * C20 + x * 3. * C30),
                2. * C20 + 6. * C30 * x};
      }
    };



    class Gent : public InvariantLaw
    {
    public:
      using InvariantLaw::InvariantLaw;

      std::vector<std::string>
      constant_names() const override
      {
        return {"mu", "Jm"};
      }

      std::string
      problem(const HyperelasticConstants &constants) const override
      {
        if (!(constants[0] > 0.))
          return not_positive("mu");
        return constants[1] > 0. ? "" : not_positive("Jm");
      }

    protected:
      Curve
      of_first(const double                 excess,
               const HyperelasticConstants &constants) const override
      {
        const double mu = constants[0], limit = constants[1];
        const double left = 1. - excess / limit;
        return {-0.5 * mu * limit * std::log1p(-excess / limit),
                0.5 * mu / left,
                0.5 * mu / (limit * left * left)};
      }

      double
      reach(const HyperelasticConstants &constants) const override
      {
        return std::min(reach_of_use, 0.95 * constants[1]);
      }
    };
  } // namespace



  const Registry<HyperelasticLaw, HyperelasticForm> &
  all_hyperelastic_laws()
  {
    using List = Registry<HyperelasticLaw, HyperelasticForm>;
    static const List list(
      "hyperelastic law",
      {{"neo-Hooke", "mu/2 (I1 - 3)", List::make_one<NeoHooke>},
       {"Mooney-Rivlin",
        "C10 (I1 - 3) + C01 (I2 - 3), mu = 2 (C10 + C01)",
        List::make_one<MooneyRivlin>},
       {"Yeoh",
        "C10 (I1 - 3) + C20 (I1 - 3)^2 + C30 (I1 - 3)^3, mu = 2 C10",
        List::make_one<Yeoh>},
       {"Gent", "-mu Jm/2 ln(1 - (I1 - 3)/Jm)", List::make_one<Gent>},
       {"Ogden",
        "sum of mu_i/alpha_i (lambda_1^alpha_i + lambda_2^alpha_i + "
        "lambda_3^alpha_i - 3), up to three terms, mu = 1/2 sum of mu_i "
        "alpha_i",
        List::make_one<OgdenLaw>}});
    return list;
  }
} // namespace MixedCracks
