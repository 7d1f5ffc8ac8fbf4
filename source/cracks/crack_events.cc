// SPDX-License-Identifier: GPL-2.0-or-later
// With S_n the size of all cracks after step n, the length of paths or the area
// of sheets, S_0 that at the start of the watch and D a step of growth, in step
// n there is
//
//   onset          damage has a first nucleus (damage_origins.cc)
//   crack length   floor((S_n - S_0)/D) is larger than at all events before;
//                  in 3-d its name is crack area
//   boundary       a crack touches a boundary at which it has not begun, in no
//                  place within 3 l of where that boundary was met before
//   separation     two sides of the body are joined (crack_outcome.cc), in 3-d
//                  it is in two parts (sheet_outcome.cc)
//
// A path touches with its ends, and began at one with a nucleus within 3 l that
// is no nearer to the other end. A sheet touches along lines, which grow: one
// that has been met is known by the place where it was. It began at its start.
//
// A crack that passes several multiples in a step is one event: there is one
// state to show.

#include <base/finite_text.h>
#include <base/ranges.h>

#include <cracks/crack_events.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using dealii::Point;

  namespace
  {
    // of multiples, for sizes that are multiples but for rounding
    constexpr double tolerance = 1e-9;



    // as it will be read again
    double
    rounded(const double value)
    {
      return std::stod(csv_number(value));
    }



    Point<3>
    rounded(const Point<3> &point)
    {
      return {rounded(point[0]), rounded(point[1]), rounded(point[2])};
    }



    // there are paths or sheets, not both
    double
    whole_size(const TracedCracks &cracks)
    {
      double size = 0.;
      for (const Crack &crack : cracks.paths)
        size += crack.length;
      for (const CrackSheet &sheet : cracks.sheets)
        size += sheet.area;
      return rounded(size);
    }



    // whether a crack began at that end of it
    bool
    began_at(const Point<2>      &end,
             const Point<2>      &other_end,
             const DamageOrigins &origins)
    {
      const std::vector<Point<2>> nuclei = in_plane(origins.nuclei);
      return any_of(nuclei, [&](const Point<2> &nucleus) {
        const double distance = end.distance(nucleus);
        return distance < origins.reach &&
               distance <= other_end.distance(nucleus);
      });
    }



    // A crack on a boundary at which it did not begin; the first of the places
    // stands for all.
    struct Contact
    {
      std::string           boundary;
      std::vector<Point<3>> places; // mm
    };

    std::vector<Contact>
    contacts_of(const TracedCracks &cracks, const DamageOrigins &origins)
    {
      std::vector<Contact> contacts;
      const auto           add_end = [&](const CrackEnd &end,
                               const Point<2> &place,
                               const Point<2> &other_end) {
        if (end.kind == CrackEnd::Kind::boundary &&
            !began_at(place, other_end, origins))
          contacts.push_back({end.name, {in_space(place)}});
      };
      for (const Crack &crack : cracks.paths)
      {
        add_end(crack.start, crack.points.front(), crack.points.back());
        add_end(crack.end, crack.points.back(), crack.points.front());
      }
      for (const CrackSheet &sheet : cracks.sheets)
        for (std::size_t b = 0; b < sheet.boundaries.size(); ++b)
          if (sheet.boundaries[b] != sheet.start)
            contacts.push_back({sheet.boundaries[b], sheet.contacts[b]});
      return contacts;
    }



    std::string
    growth_kind_in(const int dim)
    {
      return dim == 2 ? "crack length" : "crack area";
    }
  } // namespace



  std::vector<std::string>
  event_kinds(const int dim)
  {
    return {"onset", growth_kind_in(dim), "boundary", "separation"};
  }



  CrackEvents::CrackEvents(const int                       dim,
                           const std::vector<std::string> &kinds,
                           const double                    size_step)
    : growth_kind(growth_kind_in(dim))
    , kinds(kinds)
    , size_step(size_step)
  {}



  double
  CrackEvents::multiples(const double growth_so_far) const
  {
    return std::floor(growth_so_far / size_step + tolerance);
  }



  std::vector<CrackEvents::Meeting>
  CrackEvents::new_meetings(const TracedCracks  &cracks,
                            const DamageOrigins &origins) const
  {
    std::vector<Meeting> found;
    for (const Contact &contact : contacts_of(cracks, origins))
    {
      const auto is_known = [&](const Meeting &other) {
        return other.first == contact.boundary &&
               any_of(contact.places, [&](const Point<3> &place) {
                 return other.second.distance(place) < origins.reach;
               });
      };
      if (!any_of(meetings, is_known) && !any_of(found, is_known))
        found.emplace_back(contact.boundary, rounded(contact.places.front()));
    }
    return found;
  }



  std::vector<CrackEvent>
  CrackEvents::look(const TracedCracks  &cracks,
                    const DamageOrigins &origins) const
  {
    const bool              is_first = !initial_size;
    std::vector<CrackEvent> events;
    CrackEvent              now;
    now.crack_size = whole_size(cracks);
    now.growth     = is_first ? 0. : rounded(now.crack_size - *initial_size);
    const auto add = [&](const std::string             &kind,
                         const std::string             &boundary,
                         const std::optional<Point<3>> &place) {
      if (!is_first && !contains(kinds, kind))
        return;
      now.kind     = is_first ? "start" : kind;
      now.boundary = boundary;
      now.place    = place;
      events.push_back(now);
    };
    std::optional<Point<3>> origin;
    if (!origins.nuclei.empty())
      origin = rounded(origins.nuclei.front());
    if (is_first || (origin && !has_begun))
      add("onset", "", origin);
    if (multiples(now.growth) > multiples(growth))
      add(growth_kind, "", {});
    for (const auto &[boundary, place] : new_meetings(cracks, origins))
      add("boundary", boundary, place);
    if (cracks.separate_body && !is_cut && !is_first)
      add("separation", "", {});
    return events;
  }



  void
  CrackEvents::remember(const CrackEvent &event)
  {
    if (!initial_size)
      initial_size = event.crack_size;
    growth = std::max(growth, event.growth);
    if (!event.boundary.empty() && event.place)
      meetings.emplace_back(event.boundary, *event.place);
    else if (event.place)
      has_begun = true;
    is_cut = is_cut || event.kind == "separation";
  }
} // namespace MixedCracks
