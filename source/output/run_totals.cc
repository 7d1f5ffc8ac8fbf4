// SPDX-License-Identifier: GPL-2.0-or-later
#include <output/run_totals.h>

namespace MixedCracks
{
  // Sums over pieces of a run. Of phases each piece gives the largest over its
  // ranks.
  RunTotals
  operator+(const RunTotals &one, const RunTotals &other)
  {
    RunTotals sum = one;
    sum.factorizations += other.factorizations;
    sum.solves += other.solves;
    sum.rejected_steps += other.rejected_steps;
    sum.wall_time += other.wall_time;
    for (const auto &[name, seconds] : other.phases)
      sum.phases[name] += seconds;
    return sum;
  }
} // namespace MixedCracks
