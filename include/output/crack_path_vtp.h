// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_path_vtp_h
#define mixed_cracks_output_crack_path_vtp_h

#include <cracks/crack_path.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// The arc length at the points of a crack, mm.
  std::vector<double> arc_lengths(const Crack &crack);

  /// Paths of cracks as a VTK file of poly lines: arc_length_mm at points,
  /// crack and length_mm on lines. Of the cracks, points and length are used.
  std::string crack_path_vtp(const std::vector<Crack> &cracks);
} // namespace MixedCracks

#endif
