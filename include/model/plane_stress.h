// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_plane_stress_h
#define mixed_cracks_model_plane_stress_h

#include <model/hyperelastic_law.h>

#include <functional>

namespace MixedCracks
{
  /// F_33 > 0 for which (M14) a mu (F_33 - 1/F_33) + @p transverse = 0:
  /// neo-Hooke where p is given. @p shear: a mu > 0, MPa; @p transverse: s p
  /// J_2, MPa.
  double neo_hooke_thickness(double shear, double transverse);

  /// F_33 > 0 for which a mu (F_33 - 1/F_33) + K (J_2 F_33 - 1) J_2 = 0:
  /// neo-Hooke where p is eliminated. @p shear: a mu, MPa; @p bulk: K = s^2 /
  /// compliance, MPa; @p area: J_2 > 0.
  double neo_hooke_thickness(double shear, double bulk, double area);

  /// Value and slope of P_33 (MPa) for a F_33 > 0.
  using TransverseStress = std::function<OutOfPlaneDerivatives(double)>;

  /// The F_33 at which P_33 passes through 0 upwards, the first one found from
  /// @p start > 0 on; NaN where there is none, or with a slope that is not
  /// positive.
  double thickness_stretch(const TransverseStress &stress, double start);
} // namespace MixedCracks

#endif
