// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_damage_origins_h
#define mixed_cracks_discretization_damage_origins_h

#include <deal.II/base/point.h>

#include <array>
#include <map>
#include <vector>

namespace MixedCracks
{
  /// Where damage was seen first, in the plane. It belongs to a state: a crack
  /// can run through a body within one load step, so that its origin is known
  /// to the iterations of the step only, and a step that is dropped takes what
  /// it saw with it. Filled by cracks/damage_origins.h.
  struct DamageOrigins
  {
    using Box = std::array<int, 2>;

    /// damage nearer than this to earlier damage belongs to it, mm; 0: nothing
    /// is watched yet
    double reach = 0.;
    /// all broken nodes seen so far, in boxes of that size
    std::map<Box, std::vector<dealii::Point<2>>> known;
    /// those that were broken from the start, by slits and initial cracks
    std::vector<dealii::Point<2>> initial;
    /// the first node of damage that has nothing to do with earlier damage, and
    /// where the initial cracks began to grow, in the order of time
    std::vector<dealii::Point<2>> nuclei;
    bool                          initial_has_grown = false;

    bool
    is_watched() const
    {
      return reach > 0.;
    }
  };
} // namespace MixedCracks

#endif
