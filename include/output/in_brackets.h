// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_in_brackets_h
#define mixed_cracks_output_in_brackets_h

#include <base/log.h>

#include <deal.II/base/point.h>

namespace MixedCracks
{
  /// "(1, 2.5)"
  template <int dim>
  std::string
  in_brackets(const dealii::Point<dim> &point)
  {
    std::string text;
    for (unsigned int d = 0; d < dim; ++d)
      text += format(d == 0 ? "(%.6g" : ", %.6g", point[d]);
    return text + ")";
  }
} // namespace MixedCracks

#endif
