// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_crack_density_h
#define mixed_cracks_model_crack_density_h

#include <base/registry.h>

#include <algorithm>

namespace MixedCracks
{
  /// Crack surface density per unit volume (1/mm), see (M1) in doc/model.md:
  /// gamma(phi, grad phi) = a(phi)/l + b l |grad phi|^2, phi = 1 intact.
  class CrackDensity
  {
  public:
    virtual ~CrackDensity() = default;

    /// a(phi), dimensionless.
    virtual double local(double phi) const = 0;

    /// a'(phi).
    virtual double local_derivative(double phi) const = 0;

    /// a''(phi).
    virtual double local_second_derivative(double phi) const = 0;

    /// Smallest and largest a'' over 0 <= phi <= 1, exactly.
    struct Curvature
    {
      double smallest;
      double largest;
    };
    virtual Curvature curvature() const = 0;

    /// How far a is from convex: a + concavity() phi^2 / 2 is convex over
    /// 0 <= phi <= 1; not negative.
    double
    concavity() const
    {
      return std::max(0., -curvature().smallest);
    }

    /// Whether a'' is the same for every phi.
    bool
    is_quadratic() const
    {
      const Curvature range = curvature();
      return range.smallest == range.largest;
    }

    /// b, dimensionless.
    virtual double gradient_coefficient() const = 0;

    /// phi at the distance x = @p distance_over_length * l from a fully
    /// developed crack in 1-d; the integral of gamma over it is 1.
    virtual double optimal_profile(double distance_over_length) const = 0;

    /// Half the width of the damaged band divided by l; infinity for AT2.
    virtual double half_width() const = 0;
  };

  /// AT1, AT2 and Wu by name.
  const Registry<CrackDensity> &all_crack_densities();
} // namespace MixedCracks

#endif
