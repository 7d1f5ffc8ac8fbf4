// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_steps_phase_field_bounds_h
#define mixed_cracks_steps_phase_field_bounds_h

#include <base/linear_algebra.h>

namespace MixedCracks
{
  /// max over the nodes of a - b, or of its modulus; infinite where one of them
  /// is NaN. Collective.
  double largest_difference(const LinearAlgebra::Vector &a,
                            const LinearAlgebra::Vector &b,
                            bool                         modulus);

  /// @p result = base + factor (target - base), within [0, @p upper] at each
  /// node; it has ghosts.
  void move_within_bounds(const LinearAlgebra::Vector &base,
                          const LinearAlgebra::Vector &target,
                          double                       factor,
                          const LinearAlgebra::Vector &upper,
                          LinearAlgebra::Vector       &result);

  /// @p result = min(result, value) at the nodes where @p marks, without
  /// ghosts, is above 0; it may have ghosts.
  void lower_where(const LinearAlgebra::Vector &marks,
                   const LinearAlgebra::Vector &value,
                   LinearAlgebra::Vector       &result);
} // namespace MixedCracks

#endif
