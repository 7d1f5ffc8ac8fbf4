// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_damage_origins_h
#define mixed_cracks_discretization_damage_origins_h

#include <deal.II/base/point.h>

#include <array>
#include <map>
#include <vector>

namespace MixedCracks
{
  /// Where damage was seen first; in the plane z = 0. It belongs to a state: a
  /// crack can run through a body within one load step, so that its origin is
  /// known to the iterations of the step only, and a step that is dropped takes
  /// what it saw with it. Filled by cracks/damage_origins.h.
  struct DamageOrigins
  {
    using Box = std::array<int, 3>;

    /// damage nearer than this to earlier damage belongs to it, mm; 0: nothing
    /// is watched yet
    double reach = 0.;
    /// all broken nodes seen so far, in boxes of that size
    std::map<Box, std::vector<dealii::Point<3>>> known;
    /// those that were broken from the start, by slits and initial cracks
    std::vector<dealii::Point<3>> initial;
    /// the first node of damage that has nothing to do with earlier damage, and
    /// where the initial cracks began to grow, in the order of time
    std::vector<dealii::Point<3>> nuclei;
    bool                          initial_has_grown = false;

    bool
    is_watched() const
    {
      return reach > 0.;
    }
  };

  /// A point of the plane among those of space, z = 0.
  inline dealii::Point<3>
  in_space(const dealii::Point<2> &point)
  {
    return {point[0], point[1], 0.};
  }

  inline dealii::Point<3>
  in_space(const dealii::Point<3> &point)
  {
    return point;
  }

  /// The other way; what has no z is a point of the plane.
  inline std::vector<dealii::Point<2>>
  in_plane(const std::vector<dealii::Point<3>> &points)
  {
    std::vector<dealii::Point<2>> result;
    for (const dealii::Point<3> &point : points)
      result.emplace_back(point[0], point[1]);
    return result;
  }
} // namespace MixedCracks

#endif
