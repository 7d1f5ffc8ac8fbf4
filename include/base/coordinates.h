// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_coordinates_h
#define mixed_cracks_base_coordinates_h

#include <base/errors.h>
#include <base/text.h>

#include <deal.II/base/point.h>

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

  /// The point that @p text is, as "0, 1". Throws InputError that names
  /// @p parameter and what was @p found, the text where nothing else is said.
  template <int dim>
  dealii::Point<dim>
  read_point(const std::string &text,
             const std::string &parameter,
             const std::string &found = "")
  {
    const std::vector<double> numbers = parse_numbers(text, parameter);
    if (numbers.size() != dim)
      throw InputError(
        parameter + ": found " + in_quotes(found.empty() ? text : found) +
        ", allowed is a point of " + std::to_string(dim) + " numbers, as '" +
        (dim == 2 ? "0, 1" : "0, 1, 2") + "'.");
    dealii::Point<dim> point;
    set_coordinates(numbers, point);
    return point;
  }
} // namespace MixedCracks

#endif
