// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_volumetric_form_h
#define mixed_cracks_model_volumetric_form_h

#include <base/registry.h>

namespace MixedCracks
{
  /// theta(J) with its derivatives by J; dimensionless.
  struct VolumeMeasure
  {
    double value;
    double first;
    double second;
  };

  /// How the energy depends on the volume: U = lambda'/2 theta(J)^2 with
  /// theta(1) = 0, theta'(1) = 1, and lambda' = lambda - lambda_W, which is K
  /// for an isochoric W~.
  class VolumetricForm
  {
  public:
    virtual ~VolumetricForm() = default;

    /// @p volume_change: J - 1 > -1.
    virtual VolumeMeasure measure(double volume_change) const = 0;

    /// Whether W~ is to be isochoric.
    virtual bool is_isochoric() const = 0;

    /// Whether theta = J - 1.
    virtual bool is_linear() const = 0;
  };

  /// The forms of (M12) by name.
  const Registry<VolumetricForm> &all_volumetric_forms();
} // namespace MixedCracks

#endif
