// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_dimension_h
#define mixed_cracks_input_dimension_h

#include <deal.II/base/parameter_handler.h>

#include <input/parameter_source.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// The entry "Geometry/Dimension"; the caller has entered the subsection.
  /// @p value: "2" or "3".
  void add_dimension(dealii::ParameterHandler &prm, std::string &value);

  /// What a parameter file and the overrides of --set say of the dimension: 2
  /// or 3, which has to be known before the other entries can be declared. All
  /// mistakes are passed over, since read_parameters() reports them.
  int chosen_dimension(const std::vector<SourceLine>  &source,
                       const std::vector<std::string> &overrides);
} // namespace MixedCracks

#endif
