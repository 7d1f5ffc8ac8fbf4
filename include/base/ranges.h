// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_ranges_h
#define mixed_cracks_base_ranges_h

#include <algorithm>
#include <vector>

namespace MixedCracks
{
  /// Algorithms on all of a container, which std has with C++20.
  template <typename Range, typename Value>
  bool
  contains(const Range &range, const Value &value)
  {
    return std::find(range.begin(), range.end(), value) != range.end();
  }

  template <typename Range, typename Predicate>
  bool
  any_of(const Range &range, const Predicate &predicate)
  {
    return std::any_of(range.begin(), range.end(), predicate);
  }

  template <typename Range, typename Predicate>
  bool
  all_of(const Range &range, const Predicate &predicate)
  {
    return std::all_of(range.begin(), range.end(), predicate);
  }

  /// @p more behind what is in @p all.
  template <typename Value, typename Range>
  void
  append(std::vector<Value> &all, const Range &more)
  {
    all.insert(all.end(), more.begin(), more.end());
  }
} // namespace MixedCracks

#endif
