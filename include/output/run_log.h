// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_run_log_h
#define mixed_cracks_output_run_log_h

#include <base/log.h>

#include <output/energy_balance.h>
#include <output/statistics_row.h>
#include <output/summary.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// What the sentences on a run depend on.
  struct RunLogOptions
  {
    double end_time  = 0.;    ///< s
    bool   is_lagged = false; ///< the phase field of the degradation
  };

  /// What log.txt and the screen say of a run that goes on.
  class RunLog
  {
  public:
    RunLog(Log &log, const RunLogOptions &options)
      : log(log)
      , options(options)
    {}

    /// What is said of energies, once the material is known; before that
    /// nothing is.
    void
    judge_energies_by(const ImbalanceRule &rule)
    {
      imbalance_rule = rule;
    }

    /// The last of the @p rows, and whether its energies balance.
    void step(const std::vector<StatisticsRow> &rows);

    /// When it is another one than before.
    void linear_solver(const std::string &in_words);

    /// Say a warning once; "" is none.
    void damage(const std::string &warning);

    /// The end of a run, for @p reason.
    void end(const std::string                &reason,
             const Summary                    &summary,
             const std::vector<StatisticsRow> &rows);

  private:
    void energy_balance(const StatisticsRow &before, const StatisticsRow &row);

    /// All steps together, at the end.
    void energy_balance(const std::vector<StatisticsRow> &rows);

    Log                &log;
    const RunLogOptions options;
    ImbalanceRule       imbalance_rule{0.};
    std::string         present_linear_solver;
    bool                damage_is_known = false;
  };
} // namespace MixedCracks

#endif
