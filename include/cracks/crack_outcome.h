// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_crack_outcome_h
#define mixed_cracks_cracks_crack_outcome_h

#include <cracks/crack_path.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// In place of what is not known in 3-d, where cracks have no paths.
  constexpr const char *not_traced = "not traced";

  /// How a body has broken. A side is every boundary that is neither "hole"
  /// nor "notch".
  struct Outcome
  {
    /// "through hole": cracks join two different sides, or the notch and a
    /// side, by way of the hole; "below hole", "above hole": a crack, with
    /// what it branches from, joins two sides, or the notch and a side,
    /// without the hole, and passes below or above the center of the hole (the
    /// mean of its edges); "arrested": there are cracks, but no such
    /// connection; "none": there is no crack; "other": a connection in a body
    /// without a hole, or one that does not pass the hole.
    std::string path = "none";
    /// Of the cracks that make the connection, or else of the longest crack,
    /// the end at which damage came first (without nuclei: "notch" when one of
    /// them starts there, else the start of the longest): "notch", "hole" or
    /// the name of another boundary, "corner top left" and the like within 3 l
    /// of where two sides meet, "interior" for a crack that has grown both
    /// ways, "elsewhere" in the material; "none" without a crack.
    std::string start = "none";
  };

  /// Whether the cracks of that outcome have cut the body in two.
  bool separates(const Outcome &outcome);

  /// @p edges: all of the boundary. @p nuclei: where damage was seen first, in
  /// that order, mm; the crack nearest to the first of them is the first one,
  /// without any it is the longest. @p length_scale: l, mm.
  Outcome classify(const std::vector<Crack>            &cracks,
                   const std::vector<BoundaryEdge>     &edges,
                   const std::vector<dealii::Point<2>> &nuclei,
                   double                               length_scale);
} // namespace MixedCracks

#endif
