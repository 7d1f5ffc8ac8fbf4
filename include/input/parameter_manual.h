// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_parameter_manual_h
#define mixed_cracks_input_parameter_manual_h

#include <deal.II/base/parameter_handler.h>

#include <ostream>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// "prm", "json" and "markdown".
  const std::vector<std::string> &parameter_formats();

  /// Write every entry, in the order of declaration and with nothing that
  /// changes from run to run.
  ///
  /// "prm": a file that read_parameters() takes, with the present values and
  /// each entry's description, allowed values and default above it.
  /// "json": an array with one object per entry: full_name, subsections,
  /// name, value, default_value, allowed, pattern, documentation.
  /// "markdown": a section for each subsection, defaults only.
  ///
  /// Throws InputError for another format.
  void print_parameters(std::ostream                   &out,
                        const dealii::ParameterHandler &prm,
                        const std::string              &format);
} // namespace MixedCracks

#endif
