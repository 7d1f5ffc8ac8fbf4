// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_sheet_vtp_h
#define mixed_cracks_output_crack_sheet_vtp_h

#include <cracks/crack_sheet.h>

#include <output/crack_front_rows.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// Cracks as a VTK file of triangles: normals at the points, crack and
  /// area_mm2, that of the crack, on triangles.
  std::string crack_sheet_vtp(const std::vector<CrackSheet> &sheets);

  /// Fronts as a VTK file of lines: arc_length_mm, tip_speed_mm_per_s and
  /// opening_angle_deg at the points, NaN where they are not known; crack and
  /// front on lines.
  std::string crack_front_vtp(const std::vector<FrontRow> &rows);
} // namespace MixedCracks

#endif
