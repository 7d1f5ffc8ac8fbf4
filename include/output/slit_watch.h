// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_slit_watch_h
#define mixed_cracks_output_slit_watch_h

#include <discretization/state.h>

#include <output/checkpoint.h>
#include <output/slit_overlap.h>

namespace MixedCracks
{
  /// Warns of a run in which the faces of slits pass through each other.
  template <int dim>
  class SlitWatch
  {
  public:
    explicit SlitWatch(const Fields<dim> &fields)
      : overlap(fields)
    {}

    /// When the coarse mesh is there.
    void
    reinit()
    {
      overlap.reinit();
    }

    /// Look at an accepted state: "" or a line for the log. Collective.
    std::string watch(const State &state);

    /// One sentence on all states; "" when there is nothing to warn of.
    std::string warning() const;

    void save(RunRecord &record) const;
    void restore(const RunRecord &record);

    const std::vector<SlitFace<dim>> &
    slits() const
    {
      return overlap.slits();
    }

  private:
    SlitOverlap<dim> overlap;
    unsigned int     n_steps = 0;  // in which they do
    double           deepest = 0.; // mm
    std::string      deepest_in_words;
  };
} // namespace MixedCracks

#endif
