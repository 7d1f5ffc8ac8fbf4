// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_model_strength_h
#define mixed_cracks_model_strength_h

#include <model/crack_density.h>
#include <model/degradation.h>

namespace MixedCracks
{
  /// What an even bar bears: the largest stress on its way to phi = 0, and the
  /// strain it comes at.
  struct Strength
  {
    double stress; ///< sigma_c over sqrt(E G_c / l)
    double strain; ///< epsilon_c over sqrt(G_c / (E l))
  };

  /// Where phi is the same everywhere the phase-field equation g'/2 E eps^2 =
  /// -a'(phi) G_c / l gives the stress g E eps, whose largest value over 0 <=
  /// phi <= 1 this is; with g = phi^2: sqrt(3/8) for AT1, sqrt(27/256) for AT2,
  /// sqrt(2/pi) for Wu. @p degradation: of kappa = 0.
  Strength relative_strength(const CrackDensity &density,
                             const Degradation  &degradation);
} // namespace MixedCracks

#endif
