// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_rigid_body_modes_h
#define mixed_cracks_discretization_rigid_body_modes_h

#include <discretization/fields.h>

namespace MixedCracks
{
  /// Motions that cost no energy: dim translations, then the rotations about
  /// the middle of the chosen nodes of all ranks, 1 in 2-d and 3 in 3-d. @p
  /// chosen: one entry per owned elastic dof, displacements only. Each mode has
  /// one entry per chosen dof, in order; at most about 1 in size. Collective.
  template <int dim>
  std::vector<std::vector<double>>
  rigid_body_modes(const Fields<dim> &fields, const std::vector<bool> &chosen);
} // namespace MixedCracks

#endif
