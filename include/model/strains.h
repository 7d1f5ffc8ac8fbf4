// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_strains_h
#define mixed_cracks_model_strains_h

namespace MixedCracks
{
  /// How the strain is measured.
  enum class Strains
  {
    small,
    finite
  };
} // namespace MixedCracks

#endif
