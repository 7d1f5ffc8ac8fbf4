// SPDX-License-Identifier: GPL-2.0-or-later
// Whether the body is in two follows from what is left of it: a sheet may have
// small gaps and join sides all around, and a notch that goes through the
// thickness always joins the sides 'front' and 'back'. In the plane paths tell
// the same (crack_outcome.cc), but for a piece that spalls off at one side: in
// 3-d, through the thickness, it comes to three.
//
// The way past a hole is that in the plane: where the cracks that separate the
// body cross x = x_center of the hole. They are 'through' when one of them ends
// on it and none without it would do.

#include <base/ranges.h>

#include <cracks/sheet_outcome.h>

#include <algorithm>
#include <set>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // in l: parts that are smaller than a cube of this are crumbs
    constexpr double edge_of_crumb = 2.;
    // in l: what is near
    constexpr double reach_of_nucleus = 3.;



    bool
    ends_on_a_hole(const CrackSheet &sheet)
    {
      return any_of(sheet.boundaries, [](const std::string &name) {
        return role_of_boundary(name) == BoundaryRole::hole;
      });
    }



    // those without a front that join two boundaries, or the largest
    std::vector<const CrackSheet *>
    separating(const std::vector<CrackSheet> &sheets)
    {
      std::vector<const CrackSheet *> result;
      for (const CrackSheet &sheet : sheets)
        if (sheet.fronts.empty() && sheet.boundaries.size() > 1)
          result.push_back(&sheet);
      if (result.empty())
        result.push_back(&sheets.front());
      return result;
    }



    // by triangles with corners on both sides of x = x_center
    Outcome::Way
    way_past(const std::vector<const CrackSheet *> &sheets,
             const Point<3>                        &center)
    {
      bool below = false, above = false;
      for (const CrackSheet *const sheet : sheets)
        for (const auto &triangle : sheet->triangles)
          for (unsigned int i = 0; i < 3; ++i)
          {
            const Point<3> &a = sheet->vertices[triangle[i]],
                           &b = sheet->vertices[triangle[(i + 1) % 3]];
            if ((a[0] < center[0]) != (b[0] < center[0]))
              (a[1] + b[1] < 2. * center[1] ? below : above) = true;
          }
      if (below == above) // both, or neither
        return Outcome::Way::elsewhere;
      return below ? Outcome::Way::below : Outcome::Way::above;
    }



    // the crack at the first nucleus, or else the first
    const CrackSheet &
    first_crack(const std::vector<const CrackSheet *> &sheets,
                const std::vector<Point<3>>           &nuclei,
                const double                           length_scale)
    {
      for (const Point<3> &nucleus : nuclei)
        for (const CrackSheet *const sheet : sheets)
          for (const Point<3> &vertex : sheet->vertices)
            if (vertex.distance(nucleus) < reach_of_nucleus * length_scale)
              return *sheet;
      return *sheets.front();
    }
  } // namespace



  bool
  are_separate(const std::vector<IntactPart>                   &parts,
               const std::map<types::boundary_id, std::string> &names,
               const double                                     length_scale)
  {
    const double edge = edge_of_crumb * length_scale;
    const auto   n =
      std::count_if(parts.begin(), parts.end(), [&](const IntactPart &part) {
        std::set<std::string> sides;
        for (const types::boundary_id id : part.boundaries)
        {
          const auto name = names.find(id);
          if (name == names.end())
            sides.insert("boundary");
          else if (role_of_boundary(name->second) == BoundaryRole::side)
            sides.insert(name->second);
        }
        return sides.size() > 1 && part.volume > edge * edge * edge;
      });
    return n > 1;
  }



  Outcome
  classify(const std::vector<CrackSheet>    &sheets,
           const bool                        separate,
           const std::optional<HoleInSpace> &hole,
           const std::vector<Point<3>>      &nuclei,
           const double                      length_scale)
  {
    Outcome outcome;
    if (separate)
      outcome.kind = Outcome::Kind::separated;
    else if (!sheets.empty())
      outcome.kind = Outcome::Kind::arrested;
    if (sheets.empty())
      return outcome;
    std::vector<const CrackSheet *> cracks = {&sheets.front()};
    if (separate)
    {
      cracks = separating(sheets);
      for (const CrackSheet *const sheet : cracks)
        outcome.joins.push_back(sheet->joins());
      if (hole)
      {
        outcome.hole = hole->name;
        outcome.way =
          all_of(cracks,
                 [](const CrackSheet *sheet) { return ends_on_a_hole(*sheet); })
            ? Outcome::Way::through
            : way_past(cracks, hole->center);
      }
    }
    const std::string &start = first_crack(cracks, nuclei, length_scale).start;
    outcome.start            = start.empty() ? "elsewhere" : start;
    return outcome;
  }
} // namespace MixedCracks
