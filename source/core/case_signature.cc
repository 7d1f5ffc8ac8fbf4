// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/case_signature.h>
#include <core/errors.h>
#include <core/parameter_tree.h>

#include <sstream>

namespace MixedCracks
{
  std::string
  case_signature(const dealii::ParameterHandler &prm)
  {
    std::string       text;
    const std::string free_to_change[] = {
      "Load stepping", "Linear solver", "Output"};
    const ParameterTree tree(prm);
    for (const ParameterEntry &entry : tree.entries())
    {
      bool fixed = true;
      for (const std::string &subsection : free_to_change)
        fixed = fixed && entry.path.front() != subsection;
      // whose columns of statistics.csv go on
      fixed = fixed || entry.full_name() == "Output/Displacement at points";
      if (fixed)
        text += entry.full_name() + " = " + entry.value + '\n';
    }
    return text;
  }



  void
  require_same_case(const std::string &before, const std::string &now)
  {
    std::istringstream old_lines(before), new_lines(now);
    std::string        old_line, new_line;
    while (std::getline(new_lines, new_line))
    {
      std::getline(old_lines, old_line);
      if (old_line != new_line)
        throw InputError("--resume: the case has changed; the checkpoint was "
                         "written with '" +
                         old_line + "', found now '" + new_line +
                         "'. Allowed to change: entries of Load stepping, "
                         "Linear solver and Output, but for "
                         "Output/Displacement at points.");
    }
  }
} // namespace MixedCracks
