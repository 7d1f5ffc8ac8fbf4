// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_damage_origins_h
#define mixed_cracks_cracks_damage_origins_h

#include <discretization/damage_origins.h>

namespace MixedCracks
{
  // How origins of damage are told apart, from broken nodes in the order in
  // which the iterations of load steps find them. Serial; the same nodes give
  // the same origins on all ranks.

  /// Begin with nodes that are broken from the start. @p reach: some l, mm.
  DamageOrigins origins_at_start(double                               reach,
                                 const std::vector<dealii::Point<3>> &nodes);

  /// Nodes that have broken since.
  void add_broken_nodes(const std::vector<dealii::Point<3>> &nodes,
                        DamageOrigins                       &origins);

  /// Whether that node was seen broken already.
  bool is_known(const dealii::Point<3> &node, const DamageOrigins &origins);
} // namespace MixedCracks

#endif
