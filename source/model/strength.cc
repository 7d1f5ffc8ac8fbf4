// SPDX-License-Identifier: GPL-2.0-or-later
#include <model/strength.h>

#include <cmath>

namespace MixedCracks
{
  Strength
  relative_strength(const CrackDensity &density)
  {
    // the maximum is flat, so that this is exact to 6 digits
    constexpr unsigned int n_samples = 1000;
    double                 largest = 0., at = 1.;
    for (unsigned int i = 1; i <= n_samples; ++i)
    {
      const double phi    = static_cast<double>(i) / n_samples;
      const double square = -density.local_derivative(phi) * phi * phi * phi;
      if (square > largest)
      {
        largest = square;
        at      = phi;
      }
    }
    return {std::sqrt(largest), std::sqrt(largest) / (at * at)};
  }
} // namespace MixedCracks
