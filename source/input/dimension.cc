// SPDX-License-Identifier: GPL-2.0-or-later
// Geometry/Dimension is read before all else, by a parser that knows this entry
// alone and whose errors, of all the others, nobody looks at: what follows is a
// template of the dimension. The second reading, with all entries, reports what
// is wrong.

#include <deal.II/base/patterns.h>

#include <input/dimension.h>
#include <input/parameter_parser.h>
#include <input/parameter_tree.h>

namespace MixedCracks
{
  void
  add_dimension(dealii::ParameterHandler &prm, std::string &value)
  {
    prm.add_parameter("Dimension",
                      value,
                      "Of space: 2 or 3. In 3-d points have three coordinates, "
                      "x, y, z, wherever the parameters ask for some, and "
                      "there is a displacement component z.",
                      dealii::Patterns::Selection("2|3"));
  }



  int
  chosen_dimension(const std::vector<SourceLine>  &source,
                   const std::vector<std::string> &overrides)
  {
    dealii::ParameterHandler prm;
    std::string              value = "2";
    prm.enter_subsection("Geometry");
    add_dimension(prm, value);
    prm.leave_subsection();

    const ParameterTree tree(prm);
    ParameterParser     parser(tree);
    parser.parse_file(source);
    for (const std::string &text : overrides)
      parser.parse_override(text);
    for (const ParameterAssignment &assignment : parser.assignments())
      value = assignment.value;
    return value == "3" ? 3 : 2;
  }
} // namespace MixedCracks
