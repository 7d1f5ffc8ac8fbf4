// SPDX-License-Identifier: GPL-2.0-or-later
// Pairs of boundaries by name. A name may have blanks, hence the colon between
// two. A face may have several names, but one partner only.

#include <base/errors.h>
#include <base/text.h>

#include <problem/periodic_entries.h>

#include <set>

namespace MixedCracks
{
  namespace
  {
    const std::string periodic_sides_entry = "Geometry/Periodic sides";
  }



  std::vector<PeriodicPair>
  read_periodic_pairs(const std::string                  &text,
                      const NamedBoundaries              &boundaries,
                      const std::function<std::string()> &hint)
  {
    std::vector<PeriodicPair>            pairs;
    std::set<dealii::types::boundary_id> taken;
    for (const auto &parts :
         read_items(text, "boundary : boundary", periodic_sides_entry))
    {
      PeriodicPair pair;
      for (unsigned int i = 0; i < 2; ++i)
      {
        pair.names[i] = parts[i];
        pair.sides[i] =
          boundary_of(parts[i], boundaries, periodic_sides_entry, hint);
        for (const auto id : pair.sides[i])
          if (!taken.insert(id).second)
            throw InputError(periodic_sides_entry + ": found '" + parts[i] +
                             "' in " + in_quotes(parts[0] + " : " + parts[1]) +
                             ", whose faces are in this list already. Allowed "
                             "is one partner for each side.");
      }
      pairs.push_back(pair);
    }
    return pairs;
  }
} // namespace MixedCracks
