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
    double      length_step = 1.; ///< mm, in 2-d
    double      area_step   = 1.; ///< mm^2, in 3-d

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Those of event_kinds() that are asked for.
    std::vector<std::string> kinds(int dim) const;

    /// Growth from one event to the next, mm, in 3-d mm^2.
    double
    size_step(const int dim) const
    {
      return dim == 2 ? length_step : area_step;
    }

    /// Throws InputError for words that contradict each other, those of the
    /// other dimension, and growth that is none.
    void check(int dim) const;
  };
} // namespace MixedCracks

#endif
