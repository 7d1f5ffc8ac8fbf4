// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_event_parameters_h
#define mixed_cracks_output_event_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// The entries on events of the subsection "Output".
  struct EventParameters
  {
    std::string names       = "none";
    double      length_step = 1.; ///< mm

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Those of event_kinds() that are asked for.
    std::vector<std::string> kinds() const;

    /// Throws InputError for words that contradict each other, a length that
    /// is none, and events in a dimension that has no paths of cracks.
    void check(int dim) const;
  };
} // namespace MixedCracks

#endif
