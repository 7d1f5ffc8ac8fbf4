// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_strength_h
#define mixed_cracks_model_strength_h

#include <model/crack_density.h>

namespace MixedCracks
{
  /// What an even bar bears: the largest stress on its way to phi = 0, and the
  /// strain it comes at.
  struct Strength
  {
    double stress; ///< sigma_c over sqrt(E G_c / l)
    double strain; ///< epsilon_c over sqrt(G_c / (E l))
  };

  /// Where phi is the same everywhere and g = phi^2 (the quadratic degradation,
  /// kappa = 0), the phase-field equation g'/2 E eps^2 = -a'(phi) G_c / l gives
  /// the stress phi^2 E eps = sqrt(-a'(phi) phi^3 E G_c / l), whose largest
  /// value over 0 <= phi <= 1 this is: sqrt(3/8) for AT1, sqrt(27/256) for AT2,
  /// sqrt(2/pi) for Wu.
  Strength relative_strength(const CrackDensity &density);
} // namespace MixedCracks

#endif
