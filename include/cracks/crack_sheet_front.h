// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_crack_sheet_front_h
#define mixed_cracks_cracks_crack_sheet_front_h

#include <cracks/crack_sheet.h>
#include <cracks/sheet_mesh.h>

#include <set>
#include <vector>

namespace MixedCracks
{
  /// Of all vertices to the nearest cut side, mm; no more than @p largest.
  std::vector<double> distances_to_cut(const SheetMesh &mesh, double largest);

  /// From a point to a polyline, mm.
  double distance_to(const CrackFront &front, const dealii::Point<3> &point);

  /// The cut sides among the @p open ones of some triangles, as lines: the
  /// longest first; none shorter than l, which are ragged ends.
  std::vector<CrackFront> fronts_of(const SheetMesh                      &mesh,
                                    const std::vector<SheetMesh::SideOf> &open,
                                    const std::set<unsigned int> &members,
                                    const CrackSheetOptions      &options);
} // namespace MixedCracks

#endif
