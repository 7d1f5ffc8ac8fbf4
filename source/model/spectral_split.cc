// SPDX-License-Identifier: GPL-2.0-or-later
#include <model/spectral_split.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using dealii::identity_tensor;
  using dealii::outer_product;
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  // In closed form: a general algorithm takes ten times as long, and this is
  // evaluated at every point in every iteration.
  template <>
  PrincipalStrains<2>
  principal_strains(const SymmetricTensor<2, 2> &strain)
  {
    const double mean       = 0.5 * (strain[0][0] + strain[1][1]);
    const double difference = 0.5 * (strain[0][0] - strain[1][1]);
    const double radius     = std::hypot(difference, strain[0][1]);
    const double angle      = 0.5 * std::atan2(strain[0][1], difference);
    const double c = std::cos(angle), s = std::sin(angle);
    return {{{mean + radius, mean - radius}},
            {{Tensor<1, 2>({c, s}), Tensor<1, 2>({-s, c})}}};
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

    // (<a> - <b>)/(a - b) and its limit, without a difference of nearly equal
    // numbers
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

    // eps+ and its derivative by eps
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
    const auto       principal = principal_strains(strain);
    const auto      &value     = principal.values;
    // one sign: exactly everything or nothing, and no need of directions
    if (value[dim - 1] > 0.)
    {
      result.positive         = strain;
      result.positive_tangent = identity_tensor<dim>();
    }
    else if (!(value[0] < 0.))
      add_tension(principal, result.positive, result.positive_tangent);
    result.positive *= 2. * mu;
    result.positive_tangent *= 2. * mu;
    result.negative = 2. * mu * strain - result.positive;
    result.negative_tangent =
      2. * mu * identity_tensor<dim>() - result.positive_tangent;
    return result;
  }



  template <int dim>
  int
  SpectralSplit<dim>::branch(const SymmetricTensor<2, dim> &strain) const
  {
    const auto value = principal_strains(strain).values;
    return value[dim - 1] > 0. ? 1 : (value[0] < 0. ? 0 : -1);
  }



  template class SpectralSplit<2>;
  template class SpectralSplit<3>;
} // namespace MixedCracks
