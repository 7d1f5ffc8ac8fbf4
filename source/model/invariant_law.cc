// SPDX-License-Identifier: GPL-2.0-or-later
// Laws of rubber in the invariants I1 = tr C and I2 = (I1^2 - tr C^2)/2 of
// C = F^T F (no unit), (M12):
//
//   W~ = f(I1) + h(I2) - m ln J,   m = 2 f'(3) + 4 h'(3)         "coupled"
//   W~ = f(J^(-2/3) I1) + h(J^(-4/3) I2)                         "isochoric"
//
// with f, h, m and W~ in MPa, f(3) = h(3) = 0. F, P and dW~/dF are 3 x 3, the
// tangent 3 x 3 x 3 x 3. Both forms are free of stress at F = I, the first
// through ln J. Derivatives:
//
//   dI1/dF = 2 F,                  d2I1/dF_iJ dF_kL = 2 d_ik d_JL
//   dI2/dF = 2 (I1 F - F C),
//   d2I2/dF_iJ dF_kL = 2 (2 F_iJ F_kL + I1 d_ik d_JL - d_ik C_JL
//                          - F_iL F_kJ - (F F^T)_ik d_JL)
//
// and for q = J^-n I, with G = d(ln J)/dF,
//
//   dq   = J^-n (dI - n I G)
//   d2q  = J^-n (d2I - n (dI (x) G + G (x) dI) + n^2 I G (x) G - n I d2 ln J).
//
// At F = I these give
//
//   mu = 2 (f' + h'),    lambda_W = 4 h' + 4 f''   (h'' = 0 there),
//
// and lambda_W = -2 mu/3 for the isochoric form.
//
// Beyond the stretch of use L, from I1* = L^2 + 2/L (uniaxial, incompressible)
// on, f is linear in I1, with its value and slope at I1*: neo-Hooke, convex in
// F, as f' > 0 is demanded of the constants. Once it is broken, a cell of a
// Yeoh law with g = 1e-4 would carry 190 MPa at a stretch of 50, and no
// degradation is a match for Gent's barrier.

#include <model/invariant_law.h>

#include <cmath>

namespace MixedCracks
{
  using dealii::Tensor;

  namespace
  {
    // an invariant, less 3, with its derivatives by F
    struct Invariant
    {
      double       excess;
      Tensor<2, 3> first;
      Tensor<4, 3> second;
    };

    // tangent += factor a_ik d_JL
    void
    add_left(Tensor<4, 3> &tangent, const double factor, const Tensor<2, 3> &a)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int j = 0; j < 3; ++j)
            tangent[i][j][k][j] += factor * a[i][k];
    }

    void
    add_identity(Tensor<4, 3> &tangent, const double factor)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          tangent[i][j][i][j] += factor;
    }

    double
    first_excess(const Deformation &deformation)
    {
      return 2. * trace(deformation.strain);
    }

    // with C = I + 2 E: I2 - 3 = 4 tr E + 2 ((tr E)^2 - E : E)
    double
    second_excess(const Deformation &deformation)
    {
      const double sum = trace(deformation.strain);
      return 4. * sum +
             2. * (sum * sum - deformation.strain * deformation.strain);
    }

    // q - 3 of q = J^-n I
    double
    unimodular_excess(const double       excess,
                      const double       n,
                      const Deformation &deformation)
    {
      const double exponent = -n * deformation.log_volume;
      return std::exp(exponent) * excess + 3. * std::expm1(exponent);
    }

    Invariant
    first_invariant(const Deformation &deformation, const bool with_second)
    {
      Invariant result{
        first_excess(deformation), 2. * deformation.gradient, {}};
      if (with_second)
        add_identity(result.second, 2.);
      return result;
    }

    Invariant
    second_invariant(const Deformation &deformation, const bool with_second)
    {
      const Tensor<2, 3> &F     = deformation.gradient;
      const Tensor<2, 3>  C     = transpose(F) * F;
      const double        trace = 3. + first_excess(deformation);
      Invariant           result{
        second_excess(deformation), 2. * (trace * F - F * C), {}};
      if (!with_second)
        return result;
      add_outer_product(result.second, 4., F, F);
      add_identity(result.second, 2. * trace);
      add_left(result.second, -2., F * transpose(F));
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int l = 0; l < 3; ++l)
          {
            result.second[i][j][i][l] -= 2. * C[j][l];
            for (unsigned int k = 0; k < 3; ++k)
              result.second[i][j][k][l] -= 2. * F[i][l] * F[k][j];
          }
      return result;
    }

    // J^-n I in place of I
    void
    make_unimodular(Invariant         &invariant,
                    const double       n,
                    const Deformation &deformation,
                    const bool         with_second)
    {
      const Tensor<2, 3> &G     = deformation.log_gradient;
      const double        value = 3. + invariant.excess;
      const double        scale = std::exp(-n * deformation.log_volume);
      invariant.excess = unimodular_excess(invariant.excess, n, deformation);
      if (with_second)
      {
        add_outer_product(invariant.second, -n, invariant.first, G);
        add_outer_product(invariant.second, -n, G, invariant.first);
        add_outer_product(invariant.second, n * n * value, G, G);
        add_second_log_derivative(invariant.second, -n * value, deformation);
        invariant.second *= scale;
      }
      invariant.first -= n * value * G;
      invariant.first *= scale;
    }

    // the function of an invariant, by the chain rule
    void
    add(HyperelasticResponse &response,
        const Curve          &function,
        const Invariant      &invariant,
        const bool            with_tangent)
    {
      response.energy += function.value;
      response.stress += function.first * invariant.first;
      if (!with_tangent)
        return;
      response.tangent += function.first * invariant.second;
      if (function.second != 0.)
        add_outer_product(
          response.tangent, function.second, invariant.first, invariant.first);
    }
  } // namespace



  InvariantLaw::InvariantLaw(const HyperelasticForm &form)
    : form(form)
    , reach_of_use(form.largest_stretch * form.largest_stretch +
                   2. / form.largest_stretch - 3.)
  {}



  Curve
  InvariantLaw::of_second(const double, const HyperelasticConstants &) const
  {
    return {0., 0., 0.};
  }



  Curve
  InvariantLaw::of_first_continued(const double                 excess,
                                   const HyperelasticConstants &constants) const
  {
    const double last = reach(constants);
    if (excess <= last)
      return of_first(excess, constants);
    const Curve end = of_first(last, constants);
    return {end.value + end.first * (excess - last), end.first, 0.};
  }



  double
  InvariantLaw::log_coefficient(const HyperelasticConstants &constants) const
  {
    return 2. * of_first(0., constants).first +
           4. * of_second(0., constants).first;
  }



  double
  InvariantLaw::mu(const HyperelasticConstants &constants) const
  {
    return 2. *
           (of_first(0., constants).first + of_second(0., constants).first);
  }



  double
  InvariantLaw::lambda(const HyperelasticConstants &constants) const
  {
    if (form.isochoric)
      return -2. / 3. * mu(constants);
    return 4. *
           (of_second(0., constants).first + of_first(0., constants).second);
  }



  double
  InvariantLaw::energy(const Deformation           &deformation,
                       const HyperelasticConstants &constants) const
  {
    double first  = first_excess(deformation);
    double second = has_second() ? second_excess(deformation) : 0.;
    if (form.isochoric)
    {
      first = unimodular_excess(first, 2. / 3., deformation);
      second =
        has_second() ? unimodular_excess(second, 4. / 3., deformation) : 0.;
    }
    const double energy =
      of_first_continued(first, constants).value +
      (has_second() ? of_second(second, constants).value : 0.);
    return form.isochoric
             ? energy
             : energy - log_coefficient(constants) * deformation.log_volume;
  }



  HyperelasticResponse
  InvariantLaw::response(const Deformation           &deformation,
                         const HyperelasticConstants &constants,
                         const bool                   with_tangent) const
  {
    HyperelasticResponse result;
    Invariant            first = first_invariant(deformation, with_tangent);
    if (form.isochoric)
      make_unimodular(first, 2. / 3., deformation, with_tangent);
    add(
      result, of_first_continued(first.excess, constants), first, with_tangent);
    if (has_second())
    {
      Invariant second = second_invariant(deformation, with_tangent);
      if (form.isochoric)
        make_unimodular(second, 4. / 3., deformation, with_tangent);
      add(result, of_second(second.excess, constants), second, with_tangent);
    }
    if (form.isochoric)
      return result;
    const double m = log_coefficient(constants);
    result.energy -= m * deformation.log_volume;
    result.stress -= m * deformation.log_gradient;
    if (with_tangent)
      add_second_log_derivative(result.tangent, -m, deformation);
    return result;
  }
} // namespace MixedCracks
