// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_segment_h
#define mixed_cracks_base_segment_h

#include <deal.II/base/point.h>

#include <algorithm>

namespace MixedCracks
{
  /// The point of a segment that is nearest to @p point. The segment may be one
  /// point.
  template <int dim>
  dealii::Point<dim>
  nearest_on_segment(const dealii::Point<dim> &begin,
                     const dealii::Point<dim> &end,
                     const dealii::Point<dim> &point)
  {
    const dealii::Tensor<1, dim> along  = end - begin;
    const double                 square = along.norm_square();
    const double part = square > 0. ? (point - begin) * along / square : 0.;
    return begin + std::clamp(part, 0., 1.) * along;
  }
} // namespace MixedCracks

#endif
