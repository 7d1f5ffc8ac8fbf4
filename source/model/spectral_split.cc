// SPDX-License-Identifier: GPL-2.0-or-later
// The spectral split (M4) of 2 mu eps [Miehe10a]: principal strains in tension
// open cracks,
//
//   eps = sum_a eps_a n_a (x) n_a,     eps+ = sum_a <eps_a> n_a (x) n_a,
//   sigma+ = 2 mu eps+,                sigma- = 2 mu (eps - eps+),
//
// from the energy mu eps+ : eps+ (MPa), whose derivative by eps is 2 mu eps+.
// With the pressure of the constraint, psi+ is lambda/2 <tr eps>^2 + mu eps+ :
// eps+, the energy of the paper, where the pressure law is 'degraded bulk' in
// the displacement formulation.
//
// Derivative of eps+ in the direction of a strain D, in the principal basis:
//
//   (d eps+ [D])_aa = H(eps_a) D_aa
//   (d eps+ [D])_ab = (<eps_a> - <eps_b>)/(eps_a - eps_b) D_ab,   a /= b:
//
// the first factor is the slope of <.>, the second the slope of its secant,
// from the rotation of the n_a. As a fourth-order tensor, with m_ab = sym(n_a
// (x) n_b),
//
//   C+/(2 mu) = sum_a H(eps_a) m_aa (x) m_aa
//             + sum_(a<b) 2 secant(eps_a, eps_b) m_ab (x) m_ab,
//
// symmetric (major symmetry), between 0 and the identity. The secant is 1 or 0
// where both strains have one sign, and where the signs differ its denominator
// is |eps_a| + |eps_b|: no division by a small difference, no perturbation of
// equal strains as in the formulas of the literature. At eps_a = 0 the slope is
// taken as 1/2, between its limits, which the intact body at rest has
// everywhere.
//
// Where all eps_a > 0, C+ = 2 mu 1; where all < 0, C+ = 0: regimes 1 and 0,
// whose matrices do not depend on the directions. Elsewhere C+ turns with the
// n_a: no two states share a tangent, tangent_regime() = -1.

#include <model/spectral_split.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using dealii::identity_tensor;
  using dealii::outer_product;
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    // Mohr's circle of a strain in the plane: with m = (eps_xx + eps_yy)/2, d =
    // (eps_xx - eps_yy)/2 and s = eps_xy, the principal strains are m +- r, r =
    // sqrt(d^2 + s^2), and the first direction is at half the angle of (d, s).
    struct Circle
    {
      explicit Circle(const SymmetricTensor<2, 2> &strain)
        : mean(0.5 * (strain[0][0] + strain[1][1]))
        , difference(0.5 * (strain[0][0] - strain[1][1]))
        , shear(strain[0][1])
        , radius(std::sqrt(difference * difference + shear * shear))
      {}

      std::array<double, 2>
      values() const
      {
        return {{mean + radius, mean - radius}};
      }

      const double mean, difference, shear, radius;
    };

    // 1 or -1: all principal strains are positive or negative; 0: neither
    int
    common_sign(const SymmetricTensor<2, 2> &strain)
    {
      const auto values = Circle(strain).values();
      return values[1] > 0. ? 1 : (values[0] < 0. ? -1 : 0);
    }

    // By the leading minors: eps is positive definite exactly when eps_xx > 0,
    // eps_xx eps_yy - eps_xy^2 > 0 and det(eps) > 0, and -eps in the same way.
    // This needs no principal strains. 0 as well where rounding could decide.
    int
    common_sign(const SymmetricTensor<2, 3> &strain)
    {
      constexpr double rounding = 1e-12;
      const double     sign     = trace(strain) > 0. ? 1. : -1.;
      const double     size     = std::abs(trace(strain));
      const double     first    = sign * strain[0][0];
      const double     second =
        strain[0][0] * strain[1][1] - strain[0][1] * strain[0][1];
      const double third = sign * determinant(strain);
      return first > rounding * size && second > rounding * size * size &&
                 third > rounding * size * size * size
               ? static_cast<int>(sign)
               : 0;
    }
  } // namespace



  // In closed form, and by square roots alone: a general algorithm takes ten
  // times as long, angles three times, and this is evaluated at every point
  // in every iteration.
  template <>
  PrincipalStrains<2>
  principal_strains(const SymmetricTensor<2, 2> &strain)
  {
    const Circle circle(strain);
    // cos(2t) = d/r and sin(2t) = s/r at the angle t of the first direction,
    // hence c = cos t = sqrt((1 + cos 2t)/2), s = sin t = sin(2t)/(2 c).
    // the first direction (c, s) is at half the angle on the circle, between
    // -90 and 90 degrees; the larger of the two first, which loses no digits
    double c = 1., s = 0.;
    if (circle.radius > 0.)
    {
      const double cosine = circle.difference / circle.radius;
      const double sine   = circle.shear / circle.radius;
      const double larger = std::sqrt(0.5 * (1. + std::abs(cosine)));
      if (cosine >= 0.)
      {
        c = larger;
        s = 0.5 * sine / larger;
      }
      else
      {
        c = 0.5 * std::abs(sine) / larger;
        s = std::copysign(larger, sine);
      }
    }
    return {circle.values(), {{Tensor<1, 2>({c, s}), Tensor<1, 2>({-s, c})}}};
  }



  template <>
  PrincipalStrains<3>
  principal_strains(const SymmetricTensor<2, 3> &strain)
  {
    // Jacobi's method: directions are orthonormal for equal strains as well
    const auto pairs =
      eigenvectors(strain, dealii::SymmetricTensorEigenvectorMethod::jacobi);
    PrincipalStrains<3> result;
    for (unsigned int a = 0; a < 3; ++a)
    {
      result.values[a]     = pairs[a].first;
      result.directions[a] = pairs[a].second;
    }
    return result;
  }



  namespace
  {
    // <a>
    double
    positive_part(const double a)
    {
      return std::max(a, 0.);
    }

    // d<a>/da
    double
    slope(const double a)
    {
      return a > 0. ? 1. : (a < 0. ? 0. : 0.5);
    }

    // (<a> - <b>)/(a - b): the slope where both have one sign, else
    // max(a,b)/(|a| + |b|), which the last line is, as a and b differ in sign
    double
    secant_slope(const double a, const double b)
    {
      if ((a > 0.) == (b > 0.) && (a < 0.) == (b < 0.))
        return slope(a);
      return (positive_part(a) - positive_part(b)) / (a - b);
    }

    template <int dim>
    SymmetricTensor<2, dim>
    dyad(const Tensor<1, dim> &a, const Tensor<1, dim> &b)
    {
      SymmetricTensor<2, dim> result;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          result[i][j] = 0.5 * (a[i] * b[j] + a[j] * b[i]);
      return result;
    }

    // adds eps+ to @p strain and C+/(2 mu) to @p tangent; the double sum over a
    // /= b has each pair once, hence the 2 (m_ab : m_ab = 1/2)
    template <int dim>
    void
    add_tension(const PrincipalStrains<dim> &principal,
                SymmetricTensor<2, dim>     &strain,
                SymmetricTensor<4, dim>     &tangent)
    {
      const auto &value = principal.values;
      for (unsigned int a = 0; a < dim; ++a)
      {
        const auto along =
          dyad(principal.directions[a], principal.directions[a]);
        strain += positive_part(value[a]) * along;
        tangent += slope(value[a]) * outer_product(along, along);
        for (unsigned int b = a + 1; b < dim; ++b)
        {
          const auto across =
            dyad(principal.directions[a], principal.directions[b]);
          tangent += 2. * secant_slope(value[a], value[b]) *
                     outer_product(across, across);
        }
      }
    }
  } // namespace



  template <int dim>
  SplitStress<dim>
  SpectralSplit<dim>::evaluate(const SymmetricTensor<2, dim> &strain,
                               const double                   mu) const
  {
    SplitStress<dim> result;
    // one sign: exactly everything or nothing, and no need of directions
    const int sign = common_sign(strain);
    if (sign > 0)
    {
      result.positive         = strain;
      result.positive_tangent = identity_tensor<dim>();
    }
    else if (sign == 0)
      add_tension(
        principal_strains(strain), result.positive, result.positive_tangent);
    result.positive *= 2. * mu;
    result.positive_tangent *= 2. * mu;
    result.negative = 2. * mu * strain - result.positive;
    result.negative_tangent =
      2. * mu * identity_tensor<dim>() - result.positive_tangent;
    return result;
  }



  template <int dim>
  StressParts<dim>
  SpectralSplit<dim>::parts(const SymmetricTensor<2, dim> &strain,
                            const double                   mu) const
  {
    StressParts<dim> result;
    const int        sign = common_sign(strain);
    if (sign > 0)
      result.positive = strain;
    else if (sign == 0)
    {
      const auto principal = principal_strains(strain);
      for (unsigned int a = 0; a < dim && principal.values[a] > 0.; ++a)
        result.positive += principal.values[a] * dyad(principal.directions[a],
                                                      principal.directions[a]);
    }
    result.positive *= 2. * mu;
    result.negative = 2. * mu * strain - result.positive;
    return result;
  }



  template <int dim>
  int
  SpectralSplit<dim>::tangent_regime(
    const SymmetricTensor<2, dim> &strain) const
  {
    const int sign = common_sign(strain);
    return sign == 0 ? -1 : (sign > 0 ? 1 : 0);
  }



  template class SpectralSplit<2>;
  template class SpectralSplit<3>;
} // namespace MixedCracks
