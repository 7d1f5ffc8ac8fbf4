// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_damage_warning_h
#define mixed_cracks_simulation_damage_warning_h

#include <output/run_end.h>
#include <output/statistics_row.h>

#include <simulation/body.h>

namespace MixedCracks
{
  /// On where there is damage, or ""; see damage_in_words(). From the rows,
  /// which a resumed run has as well. Collective.
  template <int dim>
  std::string damage_warning(const Body<dim>                  &body,
                             const std::vector<StatisticsRow> &rows,
                             RunEnd                            end);
} // namespace MixedCracks

#endif
