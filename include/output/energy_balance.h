// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_energy_balance_h
#define mixed_cracks_output_energy_balance_h

#include <output/statistics.h>

#include <cmath>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// What a step has left over in the energy balance.
  struct StepImbalance
  {
    double energy; ///< mJ, external work less what is stored and in the crack
    /// external work so far, or the stored energy where that is larger, as it
    /// is under loads that are there from the start: these have done no work
    /// since; mJ
    double scale;
    bool   is_of_stored_energy; ///< the scale

    bool
    exceeds(const double tolerance) const
    {
      return std::abs(energy) > tolerance * scale;
    }
  };

  StepImbalance imbalance(const StatisticsRow &before,
                          const StatisticsRow &after);

  /// One sentence on all steps that exceed @p tolerance, also those before the
  /// run was resumed; "" if there are none, or if the tolerance is 0.
  std::string imbalance_in_words(const std::vector<StatisticsRow> &rows,
                                 double                            tolerance);
} // namespace MixedCracks

#endif
