// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_degradation_h
#define mixed_cracks_model_degradation_h

#include <base/registry.h>

namespace MixedCracks
{
  /// How much stiffness is left: the factor g(phi) of the stress sigma+, with
  /// g(1) = 1 (intact), g(0) = kappa (broken), growing with phi, and g'(0) = 0,
  /// so that nothing drives broken material.
  class Degradation
  {
  public:
    virtual ~Degradation() = default;

    /// g(phi), dimensionless.
    virtual double value(double phi) const = 0;

    /// g'(phi).
    virtual double derivative(double phi) const = 0;

    /// g''(phi).
    virtual double second_derivative(double phi) const = 0;

    /// Whether g'' is the same for every phi.
    virtual bool is_quadratic() const = 0;
  };

  /// Degradations by name; the argument is kappa, the residual stiffness,
  /// dimensionless, 0 <= kappa < 1.
  const Registry<Degradation, double> &all_degradations();
} // namespace MixedCracks

#endif
