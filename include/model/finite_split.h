// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_finite_split_h
#define mixed_cracks_model_finite_split_h

#include <base/registry.h>

namespace MixedCracks
{
  /// What drives the crack and what fades with it at finite strain (M15).
  struct FiniteSplit
  {
    /// Only p > 0 fades (true) or every p (false).
    bool splits_pressure;
    /// Only p > 0 drives the crack (true) or every p (false).
    bool only_tension_drives;
    /// Only stretches above 1 drive the crack: for laws that are sums over
    /// stretches.
    bool only_stretches_drive;

    bool
    fades(const double pressure) const
    {
      return pressure > 0. || !splits_pressure;
    }

    bool
    drives(const double pressure) const
    {
      return pressure > 0. || !only_tension_drives;
    }
  };

  /// "none", "volumetric" and "principal stretches".
  const Registry<FiniteSplit> &all_finite_splits();
} // namespace MixedCracks

#endif
