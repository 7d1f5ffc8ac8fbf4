// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_finite_pressure_law_h
#define mixed_cracks_model_finite_pressure_law_h

#include <base/registry.h>

namespace MixedCracks
{
  /// What a pressure law says at one point at finite strain, for one g and one
  /// sign of p: the potential is distortion W~ + volume p theta(J) -
  /// compliance p^2/2.
  struct FinitePressureCoefficients
  {
    double distortion; ///< a, dimensionless
    double volume;     ///< s, dimensionless
    double compliance; ///< s^2/lambda_d, 1/MPa
    double driving;    ///< p drives the crack with D = ... + driving p theta
  };

  /// The moduli it needs; MPa.
  struct FiniteModuli
  {
    double mu;
    double volumetric; ///< lambda' = lambda - lambda_W
  };

  /// How volume and shape fade with the degradation at finite strain.
  class FinitePressureLaw
  {
  public:
    virtual ~FinitePressureLaw() = default;

    /// @p g: degradation in [0, 1]. @p fades: p is degraded here, because it
    /// is positive or the energy split does not distinguish.
    virtual FinitePressureCoefficients
    coefficients(const FiniteModuli &moduli, double g, bool fades) const = 0;
  };

  /// What a law is made with.
  struct FinitePressureConstants
  {
    double relaxation;         ///< c of 1/lambda' + (1-g)/(g c mu)
    double residual_stiffness; ///< kappa
  };

  /// "relaxed bulk" (M13) and "cubic" (M13b).
  const Registry<FinitePressureLaw, FinitePressureConstants> &
  all_finite_pressure_laws();
} // namespace MixedCracks

#endif
