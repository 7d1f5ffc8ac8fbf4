// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_point_grid_h
#define mixed_cracks_discretization_point_grid_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace MixedCracks
{
  /// Points sorted into boxes, so that those near a place are found quickly.
  template <int dim>
  class PointGrid
  {
  public:
    using Point = dealii::Point<dim>;

    /// @p size: of the boxes, the largest distance that is asked for; mm
    PointGrid(const std::vector<Point> &points, const double size)
      : size(size)
    {
      for (const Point &point : points)
        boxes[box_of(point)].push_back(point);
    }

    bool
    has_point_within(const Point &center, const double distance) const
    {
      return any_within(center, distance, [](const Point &) { return true; });
    }

    /// The unit vector that points out of the damage at a node, if that is a
    /// tip: where the points within that distance reach farther back than
    /// to the sides. Otherwise 0, as where a band only widens.
    dealii::Tensor<1, dim>
    forward_of_tip(const Point &node, const double distance) const
    {
      dealii::Tensor<1, dim> forward;
      any_within(node, distance, [&](const Point &point) {
        forward += node - point;
        return false;
      });
      if (forward.norm() < 1e-6 * distance)
        return dealii::Tensor<1, dim>();
      forward /= forward.norm();
      double back = 0., beside = 0.;
      any_within(node, distance, [&](const Point &point) {
        const double along = (node - point) * forward;
        back               = std::max(back, along);
        beside = std::max(beside, ((node - point) - along * forward).norm());
        return false;
      });
      return back > beside ? forward : dealii::Tensor<1, dim>();
    }

  private:
    using Box = std::array<int, dim>;

    // whether visit(point) is true for one of the points within the distance
    template <typename Visit>
    bool
    any_within(const Point &center,
               const double distance,
               const Visit &visit) const
    {
      const Box home = box_of(center);
      for (int i = 0; i < dealii::Utilities::pow(3, dim); ++i)
      {
        Box near = home;
        for (int d = 0, rest = i; d < dim; ++d, rest /= 3)
          near[d] += rest % 3 - 1;
        const auto found = boxes.find(near);
        if (found == boxes.end())
          continue;
        for (const Point &point : found->second)
          if (point.distance(center) <= distance && visit(point))
            return true;
      }
      return false;
    }

    Box
    box_of(const Point &point) const
    {
      Box box;
      for (unsigned int d = 0; d < dim; ++d)
        box[d] = static_cast<int>(std::floor(point[d] / size));
      return box;
    }

    const double                      size;
    std::map<Box, std::vector<Point>> boxes;
  };
} // namespace MixedCracks

#endif
