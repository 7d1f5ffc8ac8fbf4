// SPDX-License-Identifier: GPL-2.0-or-later
// What the cracks have done to the body. Cracks are joined to groups, which
// connect sides of the body or not (crack_groups.cc). The first answer that
// holds:
//
//   no cracks                             none
//   a group connects without the hole     below or above the hole: the side of
//                                         its center where the group crosses
//                                         x = x_center (both, none: other)
//   a group connects by way of the hole   through
//   otherwise                             arrested
//
// Without the hole first: a crack that passes a hole has cut the body even
// where others have reached the hole.

#include <cracks/crack_groups.h>
#include <cracks/crack_outcome.h>
#include <cracks/crack_path_parts.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // The words that stand in files. Behind those of a way comes the name of
    // the hole.
    struct Word
    {
      Outcome::Kind kind;
      Outcome::Way  way;
      const char   *word;
    };
    constexpr Word words[] = {
      {Outcome::Kind::none, Outcome::Way::elsewhere, "none"},
      {Outcome::Kind::arrested, Outcome::Way::elsewhere, "arrested"},
      {Outcome::Kind::separated, Outcome::Way::elsewhere, "other"},
      {Outcome::Kind::separated, Outcome::Way::through, "through"},
      {Outcome::Kind::separated, Outcome::Way::below, "below"},
      {Outcome::Kind::separated, Outcome::Way::above, "above"}};



    bool
    is_side(const std::string &name)
    {
      return role_of_boundary(name) == BoundaryRole::side;
    }



    struct Hole
    {
      std::string name; // empty: there is none
      Point<2>    center;
    };

    // Its center is the mean over its edges by length, sum L_e m_e / sum L_e
    // with the midpoints m_e, so that the graded edges of a refined rim do not
    // move it.
    Hole
    find_hole(const std::vector<BoundaryEdge> &edges)
    {
      Hole         hole;
      Tensor<1, 2> sum;
      double       length = 0.;
      for (const BoundaryEdge &edge : edges)
        if (role_of_boundary(edge.name) == BoundaryRole::hole)
        {
          const double part = edge.begin.distance(edge.end);
          sum += 0.5 * part * (edge.begin + Tensor<1, 2>(edge.end));
          length += part;
          hole.name = edge.name;
        }
      if (length > 0.)
        hole.center = Point<2>(sum / length);
      return hole;
    }



    // Where the cracks cross the vertical line x = x_center. Segments count
    // with one of their ends, so that a vertex on the line is one crossing, not
    // two.
    Outcome::Way
    way_past(const std::vector<Crack> &cracks,
             const Group              &group,
             const Point<2>           &center)
    {
      bool below = false, above = false;
      for (const unsigned int c : group)
        for (std::size_t i = 1; i < cracks[c].points.size(); ++i)
        {
          const Point<2> &a = cracks[c].points[i - 1], &b = cracks[c].points[i];
          if ((a[0] < center[0]) == (b[0] < center[0]))
            continue;
          const double s = (center[0] - a[0]) / (b[0] - a[0]);
          (a[1] + s * (b[1] - a[1]) < center[1] ? below : above) = true;
        }
      if (below == above) // both, or neither
        return Outcome::Way::elsewhere;
      return below ? Outcome::Way::below : Outcome::Way::above;
    }



    // "corner top left", or empty when no two sides meet there
    std::string
    corner_near(const std::vector<BoundaryEdge> &edges,
                const Point<2>                  &point,
                const double                     distance)
    {
      for (const BoundaryEdge &a : edges)
        for (const BoundaryEdge &b : edges)
        {
          if (!is_side(a.name) || !is_side(b.name) || a.name == b.name)
            continue;
          const double tolerance = 1e-6 * a.begin.distance(a.end);
          for (const Point<2> &corner : {a.begin, a.end})
            if (corner.distance(point) < distance &&
                (corner.distance(b.begin) < tolerance ||
                 corner.distance(b.end) < tolerance))
            {
              // "top" and "bottom" first, the rest as in the alphabet
              std::string first = a.name, second = b.name;
              const auto  is_first = [](const std::string &name) {
                return name == "top" || name == "bottom";
              };
              if (is_first(second) || (!is_first(first) && second < first))
                std::swap(first, second);
              return "corner " + first + " " + second;
            }
        }
      return "";
    }



    // the first of the nuclei that lies on one of the cracks
    const Point<2> *
    first_nucleus(const std::vector<Crack>    &cracks,
                  const Group                 &group,
                  const std::vector<Point<2>> &nuclei,
                  const double                 distance)
    {
      for (const Point<2> &nucleus : nuclei)
        for (const unsigned int c : group)
          if (distance_to(cracks[c].points, nucleus) < distance)
            return &nucleus;
      return nullptr;
    }



    const Crack &
    first_crack(const std::vector<Crack> &cracks,
                const Group              &group,
                const Point<2>           *nucleus)
    {
      const auto comes_later = [&](const unsigned int a, const unsigned int b) {
        return nucleus != nullptr ? distance_to(cracks[a].points, *nucleus) >
                                      distance_to(cracks[b].points, *nucleus)
                                  : cracks[a].length < cracks[b].length;
      };
      return cracks[*std::max_element(group.begin(), group.end(), comes_later)];
    }



    // The place that the cracks came from, in this order:
    //
    //   the end of the crack at the first nucleus on the group (within 3 l)
    //   without a nucleus: a notch; else the start of the longest crack
    //
    // as "interior", a corner within 3 l, the name of the boundary, or
    // "elsewhere".
    std::string
    start_of(const std::vector<Crack>        &cracks,
             const Group                     &group,
             const std::vector<BoundaryEdge> &edges,
             const std::vector<Point<2>>     &nuclei,
             const double                     length_scale)
    {
      const double    near    = 3. * length_scale;
      const Point<2> *nucleus = first_nucleus(cracks, group, nuclei, near);
      if (nucleus == nullptr)
        for (const unsigned int c : group)
          if (is_notch(cracks[c].start.name))
            return cracks[c].start.name;
      const Crack &first = first_crack(cracks, group, nucleus);
      // a crack that came from elsewhere may have reached the notch
      const bool from_end = nucleus != nullptr &&
                            first.points.back().distance(*nucleus) < near &&
                            first.points.front().distance(*nucleus) >= near;
      if (first.from_interior && !from_end)
        return "interior";
      const CrackEnd   &end    = from_end ? first.end : first.start;
      const std::string corner = corner_near(
        edges, from_end ? first.points.back() : first.points.front(), near);
      if (!corner.empty())
        return corner;
      return end.kind == CrackEnd::Kind::boundary ? end.name : "elsewhere";
    }



    std::string
    name_of(const CrackEnd &end)
    {
      return end.kind == CrackEnd::Kind::tip ? "tip" : end.name;
    }



    std::vector<std::string>
    what_they_join(const std::vector<Crack> &cracks, const Group &group)
    {
      std::vector<std::string> joins;
      for (const unsigned int c : group)
        joins.push_back(name_of(cracks[c].start) + " to " +
                        name_of(cracks[c].end));
      return joins;
    }
  } // namespace



  std::string
  path_in_words(const Outcome &outcome)
  {
    for (const Word &entry : words)
      if (entry.kind == outcome.kind && entry.way == outcome.way)
        return entry.way == Outcome::Way::elsewhere
                 ? entry.word
                 : entry.word + (' ' + outcome.hole);
    return "other";
  }



  bool
  separates(const Outcome &outcome)
  {
    return outcome.kind == Outcome::Kind::separated;
  }



  Outcome
  classify(const std::vector<Crack>        &cracks,
           const std::vector<BoundaryEdge> &edges,
           const std::vector<Point<2>>     &nuclei,
           const double                     length_scale)
  {
    Outcome outcome;
    if (cracks.empty())
      return outcome;
    const std::vector<PartsOfCrack> parts = parts_of(cracks, edges);
    Group                           group;
    // a connection without the hole comes first
    for (const bool by_hole : {false, true})
      for (const Group &candidate :
           groups_of(cracks, parts, length_scale, by_hole))
        if (group.empty() && connects(parts, candidate))
        {
          group           = candidate;
          outcome.kind    = Outcome::Kind::separated;
          outcome.joins   = what_they_join(cracks, group);
          const Hole hole = find_hole(edges);
          outcome.hole    = hole.name;
          if (!hole.name.empty())
            outcome.way = by_hole ? Outcome::Way::through
                                  : way_past(cracks, group, hole.center);
        }
    if (group.empty())
    {
      outcome.kind       = Outcome::Kind::arrested;
      const auto longest = std::max_element(
        cracks.begin(), cracks.end(), [](const Crack &a, const Crack &b) {
          return a.length < b.length;
        });
      group = {static_cast<unsigned int>(longest - cracks.begin())};
    }
    outcome.start = start_of(cracks, group, edges, nuclei, length_scale);
    return outcome;
  }
} // namespace MixedCracks
