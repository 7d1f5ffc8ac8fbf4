// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_state_h
#define mixed_cracks_discretization_state_h

#include <base/linear_algebra.h>

namespace MixedCracks
{
  /// One state of the body, a value: a step works on a copy (the trial) and
  /// the accepted one is replaced or kept, nobody restores vectors by hand.
  /// All vectors have ghosts.
  struct State
  {
    double time      = 0.; ///< s
    double time_step = 0.; ///< that led here, s; 0: the initial state

    LinearAlgebra::Vector elastic;     ///< displacement (mm), pressure (MPa)
    LinearAlgebra::Vector phase_field; ///< 1 intact, 0 broken
    /// the phase field the degradation was evaluated with, (M9)
    LinearAlgebra::Vector lagged_phase_field;
    /// one step earlier, for the extrapolated coupling
    LinearAlgebra::Vector previous_phase_field;
    /// internal minus external nodal forces per mm thickness (N/mm): what the
    /// supports give, 0 at free nodes
    LinearAlgebra::Vector reaction;
  };
} // namespace MixedCracks

#endif
