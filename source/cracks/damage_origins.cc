// SPDX-License-Identifier: GPL-2.0-or-later
#include <cracks/damage_origins.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using dealii::Point;

  namespace
  {
    // Damage this far (in reaches) from the nodes broken at the start is growth
    // of them, and not their profile that settles.
    constexpr double growth = 1. / 3.;
  } // namespace



  DamageOrigins::DamageOrigins(const double reach)
    : reach(reach)
  {}



  DamageOrigins::Box
  DamageOrigins::box_of(const Point<2> &point) const
  {
    return {{static_cast<int>(std::floor(point[0] / reach)),
             static_cast<int>(std::floor(point[1] / reach))}};
  }



  double
  DamageOrigins::distance(const Point<2> &point) const
  {
    double    smallest = reach;
    const Box home     = box_of(point);
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
      {
        const auto box = known.find(Box{{home[0] + i, home[1] + j}});
        if (box == known.end())
          continue;
        for (const Point<2> &other : box->second)
          smallest = std::min(smallest, other.distance(point));
      }
    return smallest;
  }



  void
  DamageOrigins::add_initial(const std::vector<Point<2>> &nodes)
  {
    for (const Point<2> &node : nodes)
    {
      known[box_of(node)].push_back(node);
      initial.push_back(node);
    }
  }



  void
  DamageOrigins::add(const std::vector<Point<2>> &nodes)
  {
    for (const Point<2> &node : nodes)
    {
      const double from_known = distance(node);
      if (from_known == 0.)
        continue;
      if (from_known >= reach)
        found.push_back(node);
      else if (!initial_has_grown && !initial.empty())
      {
        const auto nearest =
          std::min_element(initial.begin(),
                           initial.end(),
                           [&](const Point<2> &a, const Point<2> &b) {
                             return a.distance(node) < b.distance(node);
                           });
        const double away = nearest->distance(node);
        if (away > growth * reach && away < reach)
        {
          found.push_back(*nearest);
          initial_has_grown = true;
        }
      }
      known[box_of(node)].push_back(node);
    }
  }



  void
  DamageOrigins::restore(const std::vector<Point<2>> &earlier)
  {
    found             = earlier;
    initial_has_grown = false;
    for (const Point<2> &node : initial)
      initial_has_grown =
        initial_has_grown ||
        std::find(found.begin(), found.end(), node) != found.end();
  }
} // namespace MixedCracks
