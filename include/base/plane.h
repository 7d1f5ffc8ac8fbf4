// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_plane_h
#define mixed_cracks_base_plane_h

#include <deal.II/base/tensor.h>

namespace MixedCracks
{
  /// a_x b_y - a_y b_x, the area that two vectors of the plane span; positive
  /// when b lies to the left of a.
  inline double
  cross(const dealii::Tensor<1, 2> &a, const dealii::Tensor<1, 2> &b)
  {
    return a[0] * b[1] - a[1] * b[0];
  }
} // namespace MixedCracks

#endif
