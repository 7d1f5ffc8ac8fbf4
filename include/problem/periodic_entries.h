// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_periodic_entries_h
#define mixed_cracks_problem_periodic_entries_h

#include <discretization/periodic_sides.h>

#include <functional>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// The entry "Geometry/Periodic sides", 'boundary : boundary ; ...'. Throws
  /// InputError, naming the entry, for what is not of that form, a boundary
  /// that is not among @p boundaries (@p hint says more about those), and one
  /// that is in two places or shares faces with another that is.
  std::vector<PeriodicPair>
  read_periodic_pairs(const std::string                  &text,
                      const NamedBoundaries              &boundaries,
                      const std::function<std::string()> &hint = {});
} // namespace MixedCracks

#endif
