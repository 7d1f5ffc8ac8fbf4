// SPDX-License-Identifier: GPL-2.0-or-later
#include <output/run_log.h>

#include <limits>

namespace MixedCracks
{
  // Time left by load: seconds so far (1 - f)/f at the fraction f of the end
  // time, as if every piece of the load took as long; a crack that runs takes
  // longer.
  void
  RunLog::step(const std::vector<StatisticsRow> &rows)
  {
    const StatisticsRow &row = rows.back();
    log.line(format("  t = %.6g s, u = %.6g mm, F = %.6g N, E_el = %.5g, "
                    "E_crack = %.5g, W = %.5g mJ, max dphi = %.3g, cells "
                    "%.0f, %.1f s",
                    row["time"],
                    row["displacement"],
                    row.force_size(),
                    row["elastic_energy"],
                    row["crack_energy"],
                    row["external_work"],
                    row["max_phase_field_change"],
                    row["cells"],
                    row["wall_time"]));
    const double fraction = row["time"] / options.end_time;
    if (fraction > 0.)
      log.progress(format("%3.0f %% of the load, about %.0f s to the end time",
                          100. * fraction,
                          row["wall_time"] * (1. - fraction) / fraction));
    if (rows.size() > 1)
      energy_balance(rows[rows.size() - 2], row);
  }



  void
  RunLog::energy_balance(const StatisticsRow &before, const StatisticsRow &row)
  {
    const StepImbalance step = imbalance(before, row);
    if (!imbalance_rule.is_broken_by(step))
      return;
    const std::string reason =
      options.is_lagged ? "the lagged phase field acts as a rate effect"
      : is_set_free(step, row, imbalance_rule)
        ? "set free by a crack that ran"
        : "the step is too long, or the pressure law has no energy";
    log.line(format("  energy balance: %.4g mJ of this step, %.1f %% of the "
                    "%s, are neither stored nor in the crack: %s",
                    step.energy,
                    100. * step.energy / step.scale,
                    step.is_of_stored_energy ? "stored energy"
                                             : "external work so far",
                    reason.c_str()));
  }



  void
  RunLog::energy_balance(const std::vector<StatisticsRow> &rows)
  {
    const std::string balance  = imbalance_in_words(rows, imbalance_rule);
    ImbalanceRule     any_step = imbalance_rule;
    any_step.change_where_a_crack_ran = std::numeric_limits<double>::infinity();
    const std::string with_cracks     = imbalance_in_words(rows, any_step);
    if (!balance.empty())
      log.line("warning: " + balance);
    else if (!with_cracks.empty())
      log.line(with_cracks + "; all of it set free by cracks that ran");
  }



  void
  RunLog::linear_solver(const std::string &in_words)
  {
    if (in_words != present_linear_solver)
      log.line("linear solver: " + in_words);
    present_linear_solver = in_words;
  }



  void
  RunLog::damage(const std::string &warning)
  {
    if (warning.empty() || damage_is_known)
      return;
    damage_is_known = true;
    log.line("warning: " + warning);
  }



  void
  RunLog::end(const std::string                &reason,
              const Summary                    &summary,
              const std::vector<StatisticsRow> &rows)
  {
    const StatisticsRow &peak =
      rows[peak_row(rows, summary.without_equilibrium)];
    const StatisticsRow &last = rows.back();
    log.line("");
    log.line("end: " + reason);
    log.line("crack: " + path_in_words(summary.cracks) +
             ", start: " + summary.cracks.start);
    log.line(format("peak force %.6g N at %.6g mm; at the end %.3g N (%.1f %% "
                    "of the peak) at %.6g mm",
                    peak.force_size(),
                    peak["displacement"],
                    last.force_size(),
                    peak.force_size() > 0.
                      ? 100. * last.force_size() / peak.force_size()
                      : 0.,
                    last["displacement"]));
    energy_balance(rows);
    log.line(format("steps %u, rejected %u, factorisations %u, solves %u, "
                    "%.1f s",
                    last.step(),
                    summary.cost.rejected_steps,
                    summary.cost.factorizations,
                    summary.cost.solves,
                    summary.cost.wall_time));
    std::string text = format("MB: at most %.0f;", summary.peak_memory);
    for (const auto &[name, megabytes] : summary.memory)
      text += format(" %s %.0f;", name.c_str(), megabytes);
    log.line(text);
    text = "seconds:";
    for (const auto &[name, seconds] : summary.cost.phases)
      text += format(" %s %.2f;", name.c_str(), seconds);
    log.line(text);
  }
} // namespace MixedCracks
