// SPDX-License-Identifier: GPL-2.0-or-later
// When to stop for a limit T of the wall time (s), by the longest times so far
// of a load step S, a checkpoint C and a call that cannot be interrupted I; t
// is now:
//
//   in a step      stop if  t + I + C > T      the step is lost, not the state
//   before a step  stop if  t + S + C > T      it is not even begun
//
// C counts as S until one was written.

#include <simulation/wall_time_budget.h>

#include <algorithm>

namespace MixedCracks
{
  void
  WallTimeBudget::note_step(const double duration)
  {
    step = std::max(step, duration);
  }



  void
  WallTimeBudget::note_checkpoint(const double duration)
  {
    checkpoint = std::max(checkpoint, duration);
  }



  void
  WallTimeBudget::note_call(const double duration)
  {
    call = std::max(call, duration);
  }



  double
  WallTimeBudget::reserve() const
  {
    return call + (checkpoint < 0. ? step : checkpoint);
  }



  bool
  WallTimeBudget::is_over(const double now) const
  {
    return given_limit > 0. && now + reserve() > given_limit;
  }



  bool
  WallTimeBudget::is_over_for_a_step(const double now) const
  {
    // the longest call is part of the step
    return given_limit > 0. && now + step + reserve() - call > given_limit;
  }
} // namespace MixedCracks
