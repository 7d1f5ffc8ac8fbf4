// SPDX-License-Identifier: GPL-2.0-or-later
// Distance from a point to a segment, or to a quadrilateral as two triangles.
//
//   segment a b     t = (x - a) . (b - a)/|b - a|^2, clipped to [0, 1];
//                   |x - a - t (b - a)|
//   triangle abc    n = (b - a) x (c - a), twice the area long. If x is above
//                   the inside, ((e - s) x (x - s)) . n >= 0 for each edge
//                   from s to e: |(x - a) . n|/|n|; else the least distance
//                   to an edge

#include <base/flat_piece.h>
#include <base/segment.h>

#include <algorithm>

namespace MixedCracks
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    double
    distance_to_triangle(const Point<3>                &point,
                         const std::array<Point<3>, 3> &corners)
    {
      double     nearest  = point.distance(corners[0]);
      double     longest  = 0.;
      bool       is_above = true;
      const auto normal =
        cross_product_3d(corners[1] - corners[0], corners[2] - corners[0]);
      for (unsigned int i = 0; i < 3; ++i)
      {
        const Point<3> &begin = corners[i], &end = corners[(i + 1) % 3];
        nearest = std::min(
          nearest, point.distance(nearest_on_segment(begin, end, point)));
        longest  = std::max(longest, begin.distance(end));
        is_above = is_above &&
                   cross_product_3d(end - begin, point - begin) * normal >= 0.;
      }
      // without an area there is nothing but the edges
      const double twice_area = normal.norm();
      if (!is_above || twice_area <= 1e-12 * longest * longest)
        return nearest;
      return std::abs((point - corners[0]) * normal) / twice_area;
    }
  } // namespace



  template <>
  FlatPiece<2>
  FlatPiece<2>::segment(const Point<2> &begin, const Point<2> &end)
  {
    return {{{begin, end}}};
  }



  template <>
  FlatPiece<3>
  FlatPiece<3>::segment(const Point<3> &begin, const Point<3> &end)
  {
    return {{{begin, end, begin, end}}};
  }



  template <>
  double
  distance(const Point<2> &point, const FlatPiece<2> &piece)
  {
    return point.distance(
      nearest_on_segment(piece.corners[0], piece.corners[1], point));
  }



  template <>
  double
  distance(const Point<3> &point, const FlatPiece<3> &piece)
  {
    const auto &corners = piece.corners;
    return std::min(
      distance_to_triangle(point, {{corners[0], corners[1], corners[2]}}),
      distance_to_triangle(point, {{corners[1], corners[3], corners[2]}}));
  }
} // namespace MixedCracks
