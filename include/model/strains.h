// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_strains_h
#define mixed_cracks_model_strains_h

namespace MixedCracks
{
  /// Which measure of strain the material knows: the symmetric gradient of the
  /// displacement (M1) to (M10), or the deformation gradient F = I + grad u
  /// (M11) to (M15).
  enum class Strains
  {
    small,
    finite
  };
} // namespace MixedCracks

#endif
