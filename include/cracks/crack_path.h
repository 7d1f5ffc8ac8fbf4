// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_crack_path_h
#define mixed_cracks_cracks_crack_path_h

#include <deal.II/base/point.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A cell in a generous band around cracks: min phi < 0.9, say.
  struct DamagedCell
  {
    /// mm; in the order of deal.II, x fastest
    std::array<dealii::Point<2>, 4> vertices;
    /// at the vertices; 1 intact, 0 broken
    std::array<double, 4> phase_field;
  };

  /// A straight piece of the boundary of the body, between two vertices. All
  /// edges of a notch or slit must be passed, and the edges where the notch
  /// begins; of the others, those within some l of the cells.
  struct BoundaryEdge
  {
    dealii::Point<2> begin, end; ///< mm
    std::string      name;       ///< "left", "right", ..., "hole", "notch"
  };

  /// What a boundary is to cracks.
  enum class BoundaryRole
  {
    side,  ///< of the body: two of them joined by a crack are apart
    hole,  ///< inside of the body: cracks may pass by way of it
    notch, ///< or slit: cracks start at its tip; part of the side it opens at
  };

  /// By its name, which geometries and files of meshes give: "hole"; "notch",
  /// "slit"; every other one is a side.
  BoundaryRole role_of_boundary(const std::string &name);

  inline bool
  is_notch(const std::string &name)
  {
    return role_of_boundary(name) == BoundaryRole::notch;
  }

  /// What trace_cracks() takes for a crack. l is the length scale.
  struct CrackPathOptions
  {
    double length_scale = 0.; ///< l, mm
    /// nodes with a smaller phase field are broken: every crack has some.
    /// A path midway between nodes l/2 apart has 0.25 at the nearest nodes.
    double broken = 0.3;
    /// nodes with a smaller phase field hold a crack together
    double connected = 0.5;
    /// a tip lies this far (in l) behind the place where the phase field
    /// passes 0.5 on the prolonged path: the optimal profiles have 0.5 at
    /// 0.52 l (Wu), 0.59 l (AT1), 0.69 l (AT2) ahead of the crack
    double tip_lag = 0.6;
    /// a tip this close (in l, at least two cells) to the boundary ahead is
    /// taken to have reached it
    double reach = 1.5;
    /// damage within this distance (in l) of the boundary is not traced: it
    /// may follow the boundary. Paths are prolonged to the boundary from there.
    double rim = 1.;
    /// cracks must be longer than this (in l)
    double shortest = 2.;
    /// what is broken farther than this (in l, at least four cells) from a
    /// path is a crack of its own
    double branch_distance = 3.;
    /// where damage was seen first, mm: helps to tell start and end
    std::vector<dealii::Point<2>> nuclei;
  };

  /// Where a crack begins or ends.
  struct CrackEnd
  {
    enum class Kind
    {
      tip,      ///< in the material
      boundary, ///< on the boundary of the body
      crack     ///< on another crack: the start of a branch
    };
    Kind kind = Kind::tip;
    /// of the boundary it met, "crack" for a branch, empty for a tip
    std::string name;
  };

  /// A crack as a polyline.
  struct Crack
  {
    std::vector<dealii::Point<2>> points;      ///< mm, start first
    double                        length = 0.; ///< mm
    /// degrees, counter-clockwise positive: from the direction in which the
    /// notch points at its tip, or else the inward normal of the boundary, to
    /// the chord from the start to the point 3 l along the path; NaN for a
    /// start that is not on the boundary
    double   kink_angle = std::numeric_limits<double>::quiet_NaN();
    CrackEnd start, end;
    /// a nucleus lies on the path, and none within 3 l of its ends: the crack
    /// has grown both ways
    bool from_interior = false;

    /// The name of the start, or "interior" for a crack that has grown both
    /// ways; empty for a tip.
    std::string
    start_name() const
    {
      return from_interior ? "interior" : start.name;
    }
  };

  /// The cracks in a plane body: centre lines of the bands in which the phase
  /// field is small. Nodes are merged by position.
  ///
  /// The start is an end at the notch; else one at the boundary; else the one
  /// with a nucleus within 3 l; else the one with the smaller x, then y. A
  /// crack starts at the tip of a notch, whose own profile is none. Damage in
  /// a band along the boundary is no crack, and a crack that comes closer than
  /// @p options.rim to the boundary ends there; one that leaves it again is
  /// another one.
  std::vector<Crack> trace_cracks(const std::vector<DamagedCell>  &cells,
                                  const std::vector<BoundaryEdge> &edges,
                                  const CrackPathOptions          &options);
} // namespace MixedCracks

#endif
