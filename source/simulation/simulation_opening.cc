// SPDX-License-Identifier: GPL-2.0-or-later
#include <simulation/simulation.h>

namespace MixedCracks
{
  template <int dim>
  void
  Simulation<dim>::record_opening(const State &state, const StatisticsRow &row)
  {
    if (!crack_opening.lines().empty())
      crack_opening_file.add(
        row.step,
        row.time,
        crack_opening.evaluate(state.elastic, state.phase_field));
  }



  template void Simulation<2>::record_opening(const State &,
                                              const StatisticsRow &);
  template void Simulation<3>::record_opening(const State &,
                                              const StatisticsRow &);
} // namespace MixedCracks
