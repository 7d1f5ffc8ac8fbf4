// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_parameters_h
#define mixed_cracks_output_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace MixedCracks
{
  /// Subsection "Output".
  struct OutputParameters
  {
    std::string directory                  = "results";
    int         fields_every               = 10;
    std::string field_format               = "VTU";
    int         checkpoint_every           = 10;
    double      wall_time_limit            = 0.;
    double      energy_imbalance_tolerance = 0.02;

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Whether any fields are to be written.
    bool
    with_fields() const
    {
      return field_format != "none";
    }

    /// Throws InputError for an empty directory name, and for a format that
    /// this deal.II cannot write.
    void check() const;
  };
} // namespace MixedCracks

#endif
