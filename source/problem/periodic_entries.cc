// SPDX-License-Identifier: GPL-2.0-or-later
// Pairs of boundaries by name. A name may have blanks, hence the colon between
// two. A face may have several names, but one partner only.

#include <base/errors.h>
#include <base/names.h>
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
    std::vector<std::string> names;
    for (const auto &boundary : boundaries)
      names.push_back(boundary.first);
    std::vector<PeriodicPair>            pairs;
    std::set<dealii::types::boundary_id> taken;
    for (const std::string &item : split_list(text, ';'))
    {
      const std::vector<std::string> parts = split_list(item, ':');
      if (parts.size() != 2)
        throw InputError(periodic_sides_entry + ": found " + in_quotes(item) +
                         ", allowed is 'boundary : boundary', as 'left : "
                         "right', several separated by ';'.");
      PeriodicPair pair;
      for (unsigned int i = 0; i < 2; ++i)
      {
        pair.names[i]    = parts[i];
        const auto found = boundaries.find(parts[i]);
        if (found == boundaries.end())
        {
          const std::string more = hint ? hint() : "";
          throw InputError(periodic_sides_entry + ": boundary: " +
                           unknown_name_message(parts[i], names) +
                           (more.empty() ? "" : " " + more));
        }
        pair.sides[i] = found->second;
        for (const auto id : pair.sides[i])
          if (!taken.insert(id).second)
            throw InputError(periodic_sides_entry + ": found '" + parts[i] +
                             "' in " + in_quotes(item) +
                             ", whose faces are in this list already. Allowed "
                             "is one partner for each side.");
      }
      pairs.push_back(pair);
    }
    return pairs;
  }
} // namespace MixedCracks
