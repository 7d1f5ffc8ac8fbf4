// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_finite_check_h
#define mixed_cracks_output_finite_check_h

#include <discretization/fields.h>
#include <discretization/state.h>

#include <output/statistics_row.h>

namespace MixedCracks
{
  /// What of a state and its row is not finite, in words; empty when all of it
  /// is. Collective.
  template <int dim>
  std::string not_finite(const Fields<dim>   &fields,
                         const State         &state,
                         const StatisticsRow &row);
} // namespace MixedCracks

#endif
