// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_projected_descent_h
#define mixed_cracks_solvers_projected_descent_h

#include <solvers/active_set.h>

namespace MixedCracks
{
  /// The safeguard of the active set method: moves downhill in the energy
  /// within the bounds, by conjugate gradients on the free dofs and a line
  /// search along the projected path (gradient projection with conjugate
  /// gradients, More and Toraldo, SIAM J. Optim. 1 (1991)). Converges where
  /// the operator of Wu's functional is indefinite and active sets cycle:
  /// there a direction of negative curvature leads to a bound. Needs more
  /// iterations than an active set that settles.
  ///
  /// @p solution and @p residual as in ActiveSetSolver::solve(). Collective.
  ActiveSetOutcome descend_within_bounds(const BoundedProblem   &problem,
                                         const ActiveSetOptions &options,
                                         LinearAlgebra::Vector  &solution,
                                         LinearAlgebra::Vector  &residual);
} // namespace MixedCracks

#endif
