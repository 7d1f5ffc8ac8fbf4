// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_parameter_check_h
#define mixed_cracks_input_parameter_check_h

#include <input/parameter_tree.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// What is wrong with @p value for an entry: its full name, the value found
  /// and what is allowed. Empty when nothing is.
  std::string value_problem(const ParameterEntry &entry,
                            const std::string    &value);

  /// "unknown entry 'x' in Geometry; did you mean 'y'? ...": where an entry
  /// of that name or of one close to it is, and what there is instead.
  std::string unknown_entry_message(const ParameterTree            &tree,
                                    const std::vector<std::string> &path,
                                    const std::string              &name);

  /// The same for a subsection.
  std::string unknown_subsection_message(const ParameterTree            &tree,
                                         const std::vector<std::string> &path,
                                         const std::string              &name);
} // namespace MixedCracks

#endif
