// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_pressure_law_h
#define mixed_cracks_model_pressure_law_h

#include <base/registry.h>

#include <model/point_constants.h>

namespace MixedCracks
{
  /// What a pressure law says at one point, for one degradation g and one
  /// sign of p. Every law is linear in p between its sign changes.
  struct PressureCoefficients
  {
    /// The momentum balance carries stress * p (dimensionless).
    double stress;
    /// The constraint is divergence * tr(eps) - compliance * p = 0.
    double divergence;
    /// 1/MPa.
    double compliance;
    /// The undegraded pressure that drives the crack is driving * p.
    double driving;

    /// Stiffness of the eliminated pressure: the momentum balance carries
    /// this times tr(eps) in the displacement formulation; MPa.
    double
    eliminated_stiffness() const
    {
      return stress * divergence / compliance;
    }
  };

  /// How the pressure fades inside the damaged zone [model.md, 3].
  class PressureLaw
  {
  public:
    virtual ~PressureLaw() = default;

    /// @p relaxation: c of 1/lambda + (1-g)/(g c mu), dimensionless. @p g:
    /// degradation in [0, 1].
    /// @p tension: p is degraded here, because it is positive or the energy
    /// split does not distinguish.
    virtual PressureCoefficients coefficients(const PointConstants &at,
                                              double                relaxation,
                                              double                g,
                                              bool tension) const = 0;

    /// Whether stress and divergence agree for every g and sign, so that the
    /// tangent of the mixed formulation is symmetric.
    virtual bool is_symmetric() const = 0;
  };

  /// Pressure laws by name: "relaxed bulk" (M8), "degraded divergence" (M7),
  /// and "degraded bulk" (true pressure, stress g<p>, the classical law of
  /// the displacement formulation).
  const Registry<PressureLaw> &all_pressure_laws();
} // namespace MixedCracks

#endif
