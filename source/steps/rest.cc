// SPDX-License-Identifier: GPL-2.0-or-later
// Whether a quantity W, the stored energy, still changes. Over the last five
// iterations, whose steps were theta_k times a plain one,
//
//   max W - min W <= tolerance * sum_k theta_k * max(|W|, |W_first|/10):
//
// W changes by less than the tolerance, relative to itself, per plain
// iteration. A long step counts for as many plain ones as it is long, and a
// step that was cut short does not pass for rest.

#include <steps/rest.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace
  {
    constexpr std::size_t n_watched = 5;

    // of the first value: less than that need not be known as accurately
    constexpr double floor_of_scale = 0.1;
  } // namespace



  void
  RestWatch::restart()
  {
    last.clear();
  }



  void
  RestWatch::add(const double value, const double factor)
  {
    if (last.empty())
      first = value;
    if (factor == 0. && !last.empty())
    {
      last.back().value = value;
      return;
    }
    last.push_back({value, factor});
    // the change to the first of the watched ones is none of theirs
    if (last.size() > n_watched + 1)
      last.pop_front();
  }



  bool
  RestWatch::is_at_rest(const double tolerance) const
  {
    if (last.size() <= n_watched)
      return false;
    double smallest = last.front().value, largest = smallest, plain = 0.;
    for (auto entry = std::next(last.begin()); entry != last.end(); ++entry)
    {
      smallest = std::min(smallest, entry->value);
      largest  = std::max(largest, entry->value);
      plain += entry->factor;
    }
    const double scale =
      std::max(std::abs(last.back().value), floor_of_scale * std::abs(first));
    return largest - smallest <= tolerance * plain * scale;
  }
} // namespace MixedCracks
