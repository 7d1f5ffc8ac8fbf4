// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_boundary_parts_h
#define mixed_cracks_cracks_boundary_parts_h

#include <cracks/crack_path.h>

#include <limits>
#include <set>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// What a place on the boundary is to cracks that end there.
  struct BoundaryPart
  {
    static constexpr unsigned int outline =
      std::numeric_limits<unsigned int>::max();

    /// The sides of the body that the place belongs to: of a side itself, of a
    /// notch or hole those at which it opens. None inside of the body.
    std::set<std::string> sides;
    /// The closed line around a void within the body, by number, or the
    /// outline.
    unsigned int line = outline;
    /// whether that line within the body is a hole by its name
    bool is_hole = false;
  };

  /// How the edges of the boundary hang together: which belong to the outline
  /// of the body, which go around holes and slits within it, and at which sides
  /// notches open.
  class BoundaryParts
  {
  public:
    /// @p edges: all of the boundary, joined at their ends.
    explicit BoundaryParts(const std::vector<BoundaryEdge> &edges);

    /// Of a point on an edge of that @p name, or on a notch. Where there is no
    /// such edge, a part of the outline for itself.
    BoundaryPart at(const dealii::Point<2> &point,
                    const std::string      &name) const;

  private:
    void find_outline(const std::vector<unsigned int> &line_of_edge);

    const std::vector<BoundaryEdge> edges;
    std::vector<BoundaryPart>       parts; // of each edge
  };
} // namespace MixedCracks

#endif
