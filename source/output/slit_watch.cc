// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/log.h>

#include <output/in_brackets.h>
#include <output/slit_watch.h>

namespace MixedCracks
{
  template <int dim>
  std::string
  SlitWatch<dim>::watch(const State &state)
  {
    const auto place = overlap.deepest(state.elastic);
    if (place.depth == 0.)
      return "";
    ++n_steps;
    if (place.depth > deepest)
    {
      deepest          = place.depth;
      deepest_in_words = format(
        "the faces of a slit pass through each other, by up to %.3g mm at %s "
        "at t = %.6g s: slits have no contact; a crack of 'Initial cracks' in "
        "a whole mesh, with an energy split, closes",
        place.depth,
        in_brackets(place.position).c_str(),
        state.time);
    }
    return format("  warning: the faces of a slit pass through each other, by "
                  "%.3g mm at %s",
                  place.depth,
                  in_brackets(place.position).c_str());
  }



  template <int dim>
  std::string
  SlitWatch<dim>::warning() const
  {
    return n_steps == 0 ? ""
                        : deepest_in_words + format(" (in %u steps)", n_steps);
  }



  template <int dim>
  void
  SlitWatch<dim>::save(RunRecord &record) const
  {
    record.n_overlapping_steps = n_steps;
    record.deepest_overlap     = deepest;
    record.overlap_in_words    = deepest_in_words;
  }



  template <int dim>
  void
  SlitWatch<dim>::restore(const RunRecord &record)
  {
    n_steps          = record.n_overlapping_steps;
    deepest          = record.deepest_overlap;
    deepest_in_words = record.overlap_in_words;
  }



  template class SlitWatch<2>;
  template class SlitWatch<3>;
} // namespace MixedCracks
