// SPDX-License-Identifier: GPL-2.0-or-later
// Cracks are joined to groups: a branch with the crack it leaves, and all that
// end on one void within the body (a slit without a mouth, say; with 'by hole'
// a hole, too). A group connects when two of its ends are on the outline of the
// body and have no side in common. A notch or slit that opens at a side is a
// part of that side (boundary_parts.cc).
//
// Two ends on one side do not separate: a piece that spalls off there leaves
// the rest whole. Nor does a crack from a slit within the body to a side: the
// ligament beyond the other tip holds.

#include <cracks/crack_groups.h>
#include <cracks/crack_path_parts.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace MixedCracks
{
  namespace
  {
    // Whether both end on the same void within the body.
    bool
    share_a_void(const PartsOfCrack &one,
                 const PartsOfCrack &other,
                 const bool          by_hole)
    {
      for (const BoundaryPart &a : one)
        for (const BoundaryPart &b : other)
          if (a.line != BoundaryPart::outline && a.line == b.line &&
              (by_hole || !a.is_hole))
            return true;
      return false;
    }



    bool
    have_a_side_in_common(const BoundaryPart &a, const BoundaryPart &b)
    {
      return std::any_of(
        a.sides.begin(), a.sides.end(), [&b](const std::string &side) {
          return b.sides.count(side) > 0;
        });
    }
  } // namespace



  std::vector<PartsOfCrack>
  parts_of(const std::vector<Crack>        &cracks,
           const std::vector<BoundaryEdge> &edges)
  {
    const BoundaryParts       boundary(edges);
    std::vector<PartsOfCrack> result(cracks.size());
    for (std::size_t c = 0; c < cracks.size(); ++c)
      for (const auto &[end, point] :
           {std::pair(cracks[c].start, cracks[c].points.front()),
            std::pair(cracks[c].end, cracks[c].points.back())})
        if (end.kind == CrackEnd::Kind::boundary)
          result[c].push_back(boundary.at(point, end.name));
    return result;
  }



  // Connected components by relabelling: cracks are few. A branch belongs to
  // every crack within l of its first point: it was joined to the core of its
  // parent, before that was prolonged and resampled.
  std::vector<Group>
  groups_of(const std::vector<Crack>        &cracks,
            const std::vector<PartsOfCrack> &parts,
            const double                     length_scale,
            const bool                       by_hole)
  {
    std::vector<unsigned int> label(cracks.size());
    std::iota(label.begin(), label.end(), 0u);
    const auto merge = [&label](const unsigned int a, const unsigned int b) {
      const unsigned int from = label[a], to = label[b];
      std::replace(label.begin(), label.end(), from, to);
    };
    for (unsigned int a = 0; a < cracks.size(); ++a)
      for (unsigned int b = 0; b < cracks.size(); ++b)
        if (a != b && (share_a_void(parts[a], parts[b], by_hole) ||
                       (cracks[a].start.kind == CrackEnd::Kind::crack &&
                        distance_to(cracks[b].points,
                                    cracks[a].points.front()) < length_scale)))
          merge(a, b);
    std::vector<Group> groups(cracks.size());
    for (unsigned int a = 0; a < cracks.size(); ++a)
      groups[label[a]].push_back(a);
    groups.erase(std::remove_if(groups.begin(),
                                groups.end(),
                                [](const Group &g) { return g.empty(); }),
                 groups.end());
    return groups;
  }



  bool
  connects(const std::vector<PartsOfCrack> &parts, const Group &group)
  {
    PartsOfCrack ends;
    for (const unsigned int c : group)
      for (const BoundaryPart &part : parts[c])
        if (!part.sides.empty())
          ends.push_back(part);
    for (const BoundaryPart &a : ends)
      for (const BoundaryPart &b : ends)
        if (!have_a_side_in_common(a, b))
          return true;
    return false;
  }
} // namespace MixedCracks
