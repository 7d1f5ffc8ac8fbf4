// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_energy_balance_h
#define mixed_cracks_output_energy_balance_h

#include <output/statistics.h>

#include <cmath>
#include <limits>
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

  /// Which imbalances are worth a word.
  struct ImbalanceRule
  {
    double tolerance; ///< relative; 0: none are
    /// a step that sets energy free, and in which the phase field changes by
    /// more than this, is one in which a crack ran
    double change_where_a_crack_ran = std::numeric_limits<double>::infinity();
    /// where there is less energy in all than this, it is rounding; mJ
    double least_energy = 0.;

    bool
    is_broken_by(const StepImbalance &step) const
    {
      return tolerance > 0. && step.scale > least_energy &&
             step.exceeds(tolerance);
    }
  };

  /// One sentence on all steps that break the rule, also those before the run
  /// was resumed; "" if there are none. Steps in which a crack ran are left
  /// out: a quasi-static model has nowhere to put their energy, and it is no
  /// fault of the calculation.
  std::string imbalance_in_words(const std::vector<StatisticsRow> &rows,
                                 const ImbalanceRule              &rule);

  /// Whether such a step is one in which a crack ran.
  bool is_set_free(const StepImbalance &step,
                   const StatisticsRow &row,
                   const ImbalanceRule &rule);
} // namespace MixedCracks

#endif
