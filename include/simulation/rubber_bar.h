// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_rubber_bar_h
#define mixed_cracks_simulation_rubber_bar_h

#include <model/crack_density.h>
#include <model/degradation.h>
#include <model/finite_strain.h>

#include <optional>

namespace MixedCracks
{
  /// An incompressible bar of a hyperelastic law, pulled along its axis: F =
  /// diag(s, s^(-1/2), s^(-1/2)) at the stretch s.
  class RubberBar
  {
  public:
    /// @p description: at finite strain, of a material that is the same
    /// everywhere.
    explicit RubberBar(const MaterialDescription &description)
      : law(description)
      , constants(description.constants.value())
    {}

    /// W of the undamaged bar per undeformed volume, MPa.
    double energy(double stretch) const;

    /// dW/ds, force per undeformed area, MPa.
    double nominal_stress(double stretch) const;

    /// The stretch at which W is @p energy (MPa).
    double stretch_of_energy(double energy) const;

    /// The stretch from which on the nominal stress declines, if there is one
    /// up to @p largest.
    std::optional<double> stretch_of_decline(double largest) const;

  private:
    FiniteStrain<3> law;
    PointConstants  constants;
  };

  /// The largest nominal stress an even bar bears, and where.
  struct RubberStrength
  {
    double stress;  ///< MPa
    double stretch; ///< 1
  };

  /// As relative_strength(), for any law: phi is the same everywhere, and
  /// g'(phi) W(s) = -a'(phi) G_c/l. @p degradation: of kappa = 0; @p energy:
  /// G_c/l, MPa.
  RubberStrength rubber_strength(const RubberBar    &bar,
                                 const CrackDensity &density,
                                 const Degradation  &degradation,
                                 double              energy);
} // namespace MixedCracks

#endif
