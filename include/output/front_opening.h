// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_front_opening_h
#define mixed_cracks_output_front_opening_h

#include <base/linear_algebra.h>

#include <cracks/crack_sheet.h>

#include <discretization/fields.h>

#include <vector>

namespace MixedCracks
{
  /// The angle at which cracks are open behind their fronts (crack tip opening
  /// angle, the angle between the faces at a fixed distance behind the front;
  /// ASTM E2472). With q on the sheet, r = 2 l behind a point of the front, and
  /// the normal n there,
  ///
  ///   w = (u(q + l n) - u(q - l n)) . n,   angle = 2 atan(w / (2 r)), degrees.
  ///
  /// l beside the sheet is outside of what is broken, and near enough that the
  /// strain in between counts little. NaN where a place lies outside of the
  /// body. @p sheets: on rank 0, where the angles are, one front after the
  /// other. @p elastic with ghosts; @p length_scale: l, mm. Collective.
  std::vector<double> opening_angles(const Fields<3>               &fields,
                                     const LinearAlgebra::Vector   &elastic,
                                     const std::vector<CrackSheet> &sheets,
                                     double length_scale);
} // namespace MixedCracks

#endif
