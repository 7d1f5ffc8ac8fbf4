// SPDX-License-Identifier: GPL-2.0-or-later
// With L_n the length of all cracks after step n, L_0 that at the start of the
// watch and D the length of a step of growth, in step n there is
//
//   onset          damage has a first nucleus (damage_origins.cc)
//   crack length   floor((L_n - L_0)/D) is larger than at all events before
//   boundary       an end of a path on a boundary at which it has not begun (a
//                  nucleus within 3 l, and no nearer to the other end), farther
//                  than 3 l from where that boundary was met before
//   separation     two sides of the body are joined (crack_outcome.cc)
//
// A crack that passes several multiples in a step is one event: there is one
// state to show.

#include <base/finite_text.h>

#include <cracks/crack_events.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using dealii::Point;

  namespace
  {
    // of multiples, for lengths that are multiples but for rounding
    constexpr double tolerance = 1e-9;



    // as it will be read again
    double
    rounded(const double value)
    {
      return std::stod(csv_number(value));
    }



    Point<2>
    rounded(const Point<2> &point)
    {
      return {rounded(point[0]), rounded(point[1])};
    }



    double
    whole_length(const std::vector<Crack> &paths)
    {
      double length = 0.;
      for (const Crack &crack : paths)
        length += crack.length;
      return rounded(length);
    }



    // whether a crack began at that end of it
    bool
    began_at(const Point<2>      &end,
             const Point<2>      &other_end,
             const DamageOrigins &origins)
    {
      const std::vector<Point<2>> nuclei = in_plane(origins.nuclei);
      return std::any_of(
        nuclei.begin(), nuclei.end(), [&](const Point<2> &nucleus) {
          const double distance = end.distance(nucleus);
          return distance < origins.reach &&
                 distance <= other_end.distance(nucleus);
        });
    }
  } // namespace



  const std::vector<std::string> &
  event_kinds()
  {
    static const std::vector<std::string> kinds{
      "onset", "crack length", "boundary", "separation"};
    return kinds;
  }



  CrackEvents::CrackEvents(const std::vector<std::string> &kinds,
                           const double                    length_step)
    : kinds(kinds)
    , length_step(length_step)
  {}



  bool
  CrackEvents::watches(const std::string &kind) const
  {
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  }



  double
  CrackEvents::multiples(const double growth_so_far) const
  {
    return std::floor(growth_so_far / length_step + tolerance);
  }



  std::vector<CrackEvents::Meeting>
  CrackEvents::new_meetings(const std::vector<Crack> &paths,
                            const DamageOrigins      &origins) const
  {
    std::vector<Meeting> found;
    const auto           add = [&](const CrackEnd &end,
                         const Point<2> &place,
                         const Point<2> &other_end) {
      const auto is_known = [&](const Meeting &other) {
        return other.first == end.name &&
               other.second.distance(place) < origins.reach;
      };
      if (end.kind == CrackEnd::Kind::boundary &&
          !began_at(place, other_end, origins) &&
          std::none_of(meetings.begin(), meetings.end(), is_known) &&
          std::none_of(found.begin(), found.end(), is_known))
        found.emplace_back(end.name, rounded(place));
    };
    for (const Crack &crack : paths)
    {
      add(crack.start, crack.points.front(), crack.points.back());
      add(crack.end, crack.points.back(), crack.points.front());
    }
    return found;
  }



  std::vector<CrackEvent>
  CrackEvents::look(const TracedCracks  &cracks,
                    const DamageOrigins &origins) const
  {
    const bool              is_first = !initial_length;
    std::vector<CrackEvent> events;
    CrackEvent              now;
    now.crack_length = whole_length(cracks.paths);
    now.growth = is_first ? 0. : rounded(now.crack_length - *initial_length);
    const auto add = [&](const std::string             &kind,
                         const std::string             &boundary,
                         const std::optional<Point<2>> &place) {
      if (!is_first && !watches(kind))
        return;
      now.kind     = is_first ? "start" : kind;
      now.boundary = boundary;
      now.place    = place;
      events.push_back(now);
    };
    std::optional<Point<2>> origin;
    if (!origins.nuclei.empty())
      origin = rounded(in_plane(origins.nuclei).front());
    if (is_first || (origin && !has_begun))
      add("onset", "", origin);
    if (multiples(now.growth) > multiples(growth))
      add("crack length", "", {});
    for (const auto &[boundary, place] : new_meetings(cracks.paths, origins))
      add("boundary", boundary, place);
    if (cracks.separate_body && !is_cut && !is_first)
      add("separation", "", {});
    return events;
  }



  void
  CrackEvents::remember(const CrackEvent &event)
  {
    if (!initial_length)
      initial_length = event.crack_length;
    growth = std::max(growth, event.growth);
    if (!event.boundary.empty() && event.place)
      meetings.emplace_back(event.boundary, *event.place);
    else if (event.place)
      has_begun = true;
    is_cut = is_cut || event.kind == "separation";
  }
} // namespace MixedCracks
