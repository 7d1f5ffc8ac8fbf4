// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_tests_unit_automatic_differentiation_h
#define mixed_cracks_tests_unit_automatic_differentiation_h

#include <Sacado.hpp>

#include <functional>
#include <vector>

namespace MixedCracks
{
  namespace Testing
  {
    /// A number that carries its first and second derivatives.
    using Active = Sacado::Fad::DFad<Sacado::Fad::DFad<double>>;

    struct Derivatives
    {
      double                           value;
      std::vector<double>              first;
      std::vector<std::vector<double>> second;
    };

    /// Value, gradient and second derivatives of @p function at @p point.
    inline Derivatives
    differentiate(
      const std::function<Active(const std::vector<Active> &)> &function,
      const std::vector<double>                                &point)
    {
      const int           n = static_cast<int>(point.size());
      std::vector<Active> variables;
      for (int i = 0; i < n; ++i)
        variables.emplace_back(n, i, Sacado::Fad::DFad<double>(n, i, point[i]));
      const Active result = function(variables);

      Derivatives derivatives{result.val().val(), {}, {}};
      for (int i = 0; i < n; ++i)
      {
        derivatives.first.push_back(result.dx(i).val());
        derivatives.second.emplace_back();
        for (int j = 0; j < n; ++j)
          derivatives.second.back().push_back(result.dx(i).dx(j));
      }
      return derivatives;
    }

    /// max(x, 0).
    inline Active
    positive_part(const Active &x)
    {
      return x.val().val() > 0. ? x : Active(0.);
    }
  } // namespace Testing
} // namespace MixedCracks

#endif
