// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_crack_path_boundary_h
#define mixed_cracks_cracks_crack_path_boundary_h

#include <cracks/crack_path.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// A place on the boundary of the body.
  struct BoundaryPlace
  {
    dealii::Point<2> point; ///< mm
    /// from where it was asked for, mm; infinite when there is none
    double       distance = std::numeric_limits<double>::infinity();
    unsigned int edge     = 0;
    bool
    exists() const
    {
      return distance < std::numeric_limits<double>::infinity();
    }
  };

  /// The end of a notch.
  struct NotchTip
  {
    dealii::Point<2>     point;     ///< mm
    dealii::Tensor<1, 2> direction; ///< in which the notch points, length 1
    double               radius;    ///< of a blunt one, mm; 0 of a slit or a V
  };

  /// The boundary of the body, asked for distances and intersections.
  class BodyBoundary
  {
  public:
    explicit BodyBoundary(const std::vector<BoundaryEdge> &edges);

    /// "notch" or "slit".
    std::string
    notch_name() const
    {
      return notch_edges.empty() ? "" : edges[notch_edges.front()].name;
    }

    /// The nearest place on the notch, or on all the rest.
    BoundaryPlace nearest(const dealii::Point<2> &point, bool notch) const;

    /// Where the way from @p from to @p to first meets the boundary.
    BoundaryPlace first_met(const dealii::Point<2> &from,
                            const dealii::Point<2> &to) const;

    /// The tip within @p distance of its rounding or point; nullptr when
    /// there is none.
    const NotchTip *tip_near(const dealii::Point<2> &point,
                             double                  distance) const;

    const std::string &
    name(const BoundaryPlace &place) const
    {
      return edges[place.edge].name;
    }

    /// Of length 1, to the side on which @p inside lies.
    dealii::Tensor<1, 2> normal(const BoundaryPlace    &place,
                                const dealii::Point<2> &inside) const;

  private:
    void find_notch_tips();
    void find_blunt_tip(const std::vector<dealii::Point<2>> &mouth);

    const std::vector<BoundaryEdge> edges;
    std::vector<unsigned int>       notch_edges, other_edges;
    std::vector<NotchTip>           tips;
  };
} // namespace MixedCracks

#endif
