// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_intact_parts_h
#define mixed_cracks_cracks_intact_parts_h

#include <base/linear_algebra.h>

#include <discretization/fields.h>

#include <set>
#include <vector>

namespace MixedCracks
{
  /// A part of the body that hangs together.
  struct IntactPart
  {
    double                               volume = 0.; ///< mm^3
    std::set<dealii::types::boundary_id> boundaries;  ///< that it comes to
  };

  /// What is left of the body: nodes whose phase field is at least @p connected
  /// hang together when they belong to one cell. (Cells of l/2 across a crack
  /// at any angle have nodes below that on one side of it at least.) The
  /// largest part first; the same on all ranks. @p phase_field with ghosts.
  /// Collective.
  std::vector<IntactPart> intact_parts(const Fields<3>             &fields,
                                       const LinearAlgebra::Vector &phase_field,
                                       double connected = 0.5);
} // namespace MixedCracks

#endif
