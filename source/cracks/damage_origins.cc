// SPDX-License-Identifier: GPL-2.0-or-later
// Where damage began, from nodes with phi < 0.3 in the order in which they
// break, with R = 3 l [reach]. Known nodes K, at first the initial ones I
// (slits, initial cracks); for each new node x, d = distance of x to K:
//
//   d >= R                            x is a nucleus: damage of its own
//   d <  R, R/3 < |x - I| < R,
//           the first such x          the node of I nearest to x is a nucleus:
//                                     there the initial cracks begin to grow
//   then K := K + {x}
//
// Single-linkage clusters, built up in time: a crack that advances by less than
// R from one look to the next is never a nucleus again. R/3 = l keeps the
// widening of an initial profile apart from growth. What a trial step found is
// dropped with it (State::damage_origins); to look at accepted states only
// would be too late, as a crack can cross the body within one of them.
//
// K is kept in boxes of edge R: what is nearer than R lies in the box of x or
// in one of its 26 neighbours, of which a body in the plane has 8.

#include <base/ranges.h>

#include <cracks/damage_origins.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using dealii::Point;

  namespace
  {
    // In reaches. Nearer than this to the nodes broken at the start, their
    // profile settles.
    constexpr double growth = 1. / 3.;



    DamageOrigins::Box
    box_of(const Point<3> &point, const double size)
    {
      return {{static_cast<int>(std::floor(point[0] / size)),
               static_cast<int>(std::floor(point[1] / size)),
               static_cast<int>(std::floor(point[2] / size))}};
    }



    // to the nearest node known, no more than the reach
    double
    distance_to_known(const Point<3> &point, const DamageOrigins &origins)
    {
      double                   smallest = origins.reach;
      const DamageOrigins::Box home     = box_of(point, origins.reach);
      for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
          for (int k = -1; k <= 1; ++k)
          {
            const auto box =
              origins.known.find({{home[0] + i, home[1] + j, home[2] + k}});
            if (box == origins.known.end())
              continue;
            for (const Point<3> &other : box->second)
              smallest = std::min(smallest, other.distance(point));
          }
      return smallest;
    }



    // The initial cracks begin to grow where they are nearest to the first
    // damage that is beyond their own profile.
    void
    look_for_growth(const Point<3> &node, DamageOrigins &origins)
    {
      if (origins.initial_has_grown || origins.initial.empty())
        return;
      const auto nearest =
        std::min_element(origins.initial.begin(),
                         origins.initial.end(),
                         [&](const Point<3> &a, const Point<3> &b) {
                           return a.distance(node) < b.distance(node);
                         });
      const double away = nearest->distance(node);
      if (away > growth * origins.reach && away < origins.reach)
      {
        origins.nuclei.push_back(*nearest);
        origins.initial_has_grown = true;
      }
    }
  } // namespace



  DamageOrigins
  origins_at_start(const double reach, const std::vector<Point<3>> &nodes)
  {
    DamageOrigins origins;
    origins.reach   = reach;
    origins.initial = nodes;
    for (const Point<3> &node : nodes)
      origins.known[box_of(node, reach)].push_back(node);
    return origins;
  }



  void
  add_broken_nodes(const std::vector<Point<3>> &nodes, DamageOrigins &origins)
  {
    for (const Point<3> &node : nodes)
    {
      const double from_known = distance_to_known(node, origins);
      if (from_known == 0.)
        continue;
      if (from_known >= origins.reach)
        origins.nuclei.push_back(node);
      else
        look_for_growth(node, origins);
      origins.known[box_of(node, origins.reach)].push_back(node);
    }
  }



  bool
  is_known(const Point<3> &node, const DamageOrigins &origins)
  {
    const auto box = origins.known.find(box_of(node, origins.reach));
    return box != origins.known.end() && contains(box->second, node);
  }
} // namespace MixedCracks
