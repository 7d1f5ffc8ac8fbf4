// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_degradation_h
#define mixed_cracks_model_degradation_h

namespace MixedCracks
{
  /// Quadratic degradation g(phi) = (1 - kappa) phi^2 + kappa [model.md, 1].
  class Degradation
  {
  public:
    /// @p kappa: residual stiffness, dimensionless, 0 <= kappa < 1.
    explicit Degradation(const double kappa)
      : kappa(kappa)
    {}

    double
    value(const double phi) const
    {
      return (1. - kappa) * phi * phi + kappa;
    }

    double
    derivative(const double phi) const
    {
      return 2. * (1. - kappa) * phi;
    }

    double
    second_derivative() const
    {
      return 2. * (1. - kappa);
    }

  private:
    double kappa;
  };
} // namespace MixedCracks

#endif
