// SPDX-License-Identifier: GPL-2.0-or-later
// The volumetric part of the energy of rubber (M12), J = det F (no unit):
//
//   U(J) = lambda'/2 theta(J)^2   (MPa),      U' = lambda' theta theta'.
//
// In the mixed formulation p = lambda' theta is an unknown, and the potential
// W~ + p theta - p^2/(2 lambda') is quadratic in p whatever theta is:
//
//   form                          theta                            W~
//   coupled                       J - 1                            with ln J
//   isochoric, K/2 (J-1)^2        J - 1                            isochoric
//   isochoric, K/4 (J^2-1-2 lnJ)  sign(J-1) sqrt((J^2-1)/2 - ln J) isochoric
//
// lambda' = lambda - lambda_W is K for an isochoric W~, whose lambda_W is
// -2 mu/3. The pressure in the deformed body is p theta'(J): p itself but for
// the last form, which is here to compare
// with published figures.
//
// With e = J - 1 the last theta is e r, r^2 = q(e),
//
//   q = ((J^2-1)/2 - ln J)/e^2 = 1 - e/3 + e^2/4 - e^3/5 + ...,
//
// the series where the quotient cancels; theta' = r + e r' = (J+1)/(2 J r).

#include <model/volumetric_form.h>

#include <cmath>

namespace MixedCracks
{
  namespace
  {
    class LinearForm : public VolumetricForm
    {
    public:
      explicit LinearForm(const bool isochoric)
        : isochoric(isochoric)
      {}

      VolumeMeasure
      measure(const double volume_change) const override
      {
        return {volume_change, 1., 0.};
      }

      bool
      is_isochoric() const override
      {
        return isochoric;
      }

      bool
      is_linear() const override
      {
        return true;
      }

    private:
      const bool isochoric;
    };



    class LogarithmicForm : public VolumetricForm
    {
    public:
      VolumeMeasure
      measure(const double volume_change) const override
      {
        return std::abs(volume_change) < 0.02 ? near_one(volume_change)
                                              : elsewhere(volume_change);
      }

      bool
      is_isochoric() const override
      {
        return true;
      }

      bool
      is_linear() const override
      {
        return false;
      }

    private:
      static VolumeMeasure
      near_one(const double e)
      {
        double q = 1., first = 0., second = 0.; // of q by e
        double power = 1.;                      // (-e)^(k-2)
        for (int k = 1; k <= 12; ++k)
        {
          const double coefficient = 1. / (k + 2);
          if (k == 1)
          {
            q -= coefficient * e;
            first -= coefficient;
            continue;
          }
          q += coefficient * power * e * e;
          first += coefficient * k * power * e;
          second += coefficient * k * (k - 1) * power;
          power *= -e;
        }
        const double r        = std::sqrt(q);
        const double r_first  = 0.5 * first / r;
        const double r_second = (0.5 * second - r_first * r_first) / r;
        return {e * r, r + e * r_first, 2. * r_first + e * r_second};
      }

      // theta theta' = (J - 1/J)/2, and its derivative
      static VolumeMeasure
      elsewhere(const double e)
      {
        const double J = 1. + e;
        const double value =
          std::copysign(std::sqrt(e + 0.5 * e * e - std::log1p(e)), e);
        const double first = 0.5 * (J - 1. / J) / value;
        return {
          value, first, (0.5 * (1. + 1. / (J * J)) - first * first) / value};
      }
    };



    template <bool isochoric>
    std::unique_ptr<VolumetricForm>
    make_linear()
    {
      return std::make_unique<LinearForm>(isochoric);
    }
  } // namespace



  const Registry<VolumetricForm> &
  all_volumetric_forms()
  {
    static const Registry<VolumetricForm> list(
      "volumetric form",
      {{"coupled",
        "the energy of the law has a term in ln J, and (lambda - lambda_W)/2 "
        "(J-1)^2 comes on top",
        make_linear<false>},
       {"isochoric, K/2 (J-1)^2",
        "the law in the isochoric stretches J^(-1/3) lambda_a, and K/2 (J-1)^2",
        make_linear<true>},
       {"isochoric, K/4 (J^2-1-2 ln J)",
        "the same with K/4 (J^2 - 1 - 2 ln J)",
        []() -> std::unique_ptr<VolumetricForm> {
          return std::make_unique<LogarithmicForm>();
        }}});
    return list;
  }
} // namespace MixedCracks
