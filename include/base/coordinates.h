// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_coordinates_h
#define mixed_cracks_base_coordinates_h

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace MixedCracks
{
  /// The coordinates of a point or vector, which compare as arrays do: by the
  /// first one that differs.
  template <int dim>
  std::array<double, dim>
  coordinates_of(const dealii::Tensor<1, dim> &vector)
  {
    std::array<double, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = vector[d];
    return result;
  }

  /// Sets the first coordinates of a point or vector to the @p numbers, at most
  /// dim of them.
  template <int dim>
  void
  set_coordinates(const std::vector<double> &numbers,
                  dealii::Tensor<1, dim>    &vector)
  {
    for (unsigned int d = 0; d < numbers.size(); ++d)
      vector[d] = numbers[d];
  }
} // namespace MixedCracks

#endif
