// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_damage_origins_h
#define mixed_cracks_cracks_damage_origins_h

#include <deal.II/base/point.h>

#include <array>
#include <map>
#include <vector>

namespace MixedCracks
{
  /// Where damage was seen first. Fed with broken nodes as the iterations of a
  /// load step find them, since a crack can run through a body within one step.
  /// A value: a rejected step is undone by a copy. Serial.
  class DamageOrigins
  {
  public:
    /// @p reach, mm: damage nearer than this to earlier damage belongs to it;
    /// some l.
    explicit DamageOrigins(double reach = 1.);

    /// Nodes that are broken from the start, by slits and initial cracks.
    void add_initial(const std::vector<dealii::Point<2>> &nodes);

    /// Nodes that have broken since.
    void add(const std::vector<dealii::Point<2>> &nodes);

    /// Of a resumed run.
    void restore(const std::vector<dealii::Point<2>> &earlier);

    /// The first node of damage that has nothing to do with earlier damage,
    /// and where the initial cracks began to grow, in the order of time.
    const std::vector<dealii::Point<2>> &
    nuclei() const
    {
      return found;
    }

  private:
    using Box = std::array<int, 2>;

    Box box_of(const dealii::Point<2> &point) const;

    /// Distance to the nearest node known, no more than the reach.
    double distance(const dealii::Point<2> &point) const;

    double                                       reach;
    std::map<Box, std::vector<dealii::Point<2>>> known;
    std::vector<dealii::Point<2>>                initial, found;
    bool                                         initial_has_grown = false;
  };
} // namespace MixedCracks

#endif
