// SPDX-License-Identifier: GPL-2.0-or-later
// Balance of one step, mJ,
//
//   I_n = (W_n - W_(n-1)) - (E_n - E_(n-1)) - (D_n - D_(n-1)),
//
// W external work by the trapezoidal rule (ElasticStep::external_work), E
// stored energy, D = integral of G_c gamma, judged by |I_n| > tolerance
// max(|W_n|, E_n).
//
// In a quasi-static evolution with an energy (M1), dW = dE + dD: what is left
// is the error of the trapezoidal rule, of third order in a step in which
// forces are smooth, none where they are linear. A crack that runs sets free
// I_n > 0, which would be kinetic energy. A lagged phi, and laws that are not
// the derivative of an energy (M7, M8), leave something of either sign.
//
// |W_n| is the sum since the start, not that of the step, since a step near a
// maximum of the load may do hardly any work; E_n where loads that were there
// at the start have stored more than has been done since.

#include <base/log.h>

#include <output/energy_balance.h>

namespace MixedCracks
{
  StepImbalance
  imbalance(const StatisticsRow &before, const StatisticsRow &after)
  {
    const double work = std::abs(after["external_work"]);
    return {after.energy_imbalance(before),
            std::max(work, after["elastic_energy"]),
            after["elastic_energy"] > work};
  }



  bool
  is_set_free(const StepImbalance &step,
              const StatisticsRow &row,
              const ImbalanceRule &rule)
  {
    return step.energy > 0. &&
           row["max_phase_field_change"] > rule.change_where_a_crack_ran;
  }



  std::string
  imbalance_in_words(const std::vector<StatisticsRow> &rows,
                     const ImbalanceRule              &rule)
  {
    std::size_t n_steps = 0, worst = 0;
    double      largest = 0.;
    for (std::size_t i = 1; i < rows.size(); ++i)
    {
      const StepImbalance step = imbalance(rows[i - 1], rows[i]);
      if (!rule.is_broken_by(step) || is_set_free(step, rows[i], rule))
        continue;
      ++n_steps;
      if (worst > 0 && std::abs(step.energy) <= std::abs(largest))
        continue;
      worst   = i;
      largest = step.energy;
    }
    if (n_steps == 0)
      return "";
    std::string text = "energy balance: ";
    text += n_steps == 1 ? format("step %u leaves", rows[worst].step())
                         : format("%zu steps leave", n_steps);
    text += " more over than Output/Energy imbalance tolerance allows";
    text +=
      n_steps == 1
        ? format(", %.4g mJ", largest)
        : format(", most in step %u: %.4g mJ", rows[worst].step(), largest);
    return text +
           format("; %.4g mJ in all, of an external work of %.4g mJ",
                  rows.back().energy_imbalance(rows.front()),
                  rows.back()["external_work"] - rows.front()["external_work"]);
  }
} // namespace MixedCracks
