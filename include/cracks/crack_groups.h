// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_crack_groups_h
#define mixed_cracks_cracks_crack_groups_h

#include <cracks/boundary_parts.h>
#include <cracks/crack_path.h>

#include <vector>

namespace MixedCracks
{
  /// Numbers of cracks that are joined.
  using Group = std::vector<unsigned int>;

  /// What a crack starts and ends on; nothing for ends in the material.
  using PartsOfCrack = std::vector<BoundaryPart>;

  /// Of each crack. @p edges: all of the boundary, joined at their ends.
  std::vector<PartsOfCrack> parts_of(const std::vector<Crack>        &cracks,
                                     const std::vector<BoundaryEdge> &edges);

  /// Every crack is in one of them. @p length_scale: l, mm. @p by_hole: whether
  /// a hole joins the cracks that end on it, as other voids in the body do.
  std::vector<Group> groups_of(const std::vector<Crack>        &cracks,
                               const std::vector<PartsOfCrack> &parts,
                               double                           length_scale,
                               bool                             by_hole);

  /// Whether a group joins two different sides of the body.
  bool connects(const std::vector<PartsOfCrack> &parts, const Group &group);
} // namespace MixedCracks

#endif
