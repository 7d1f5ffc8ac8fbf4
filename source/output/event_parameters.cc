// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>
#include <base/names.h>
#include <base/text.h>

#include <cracks/crack_events.h>

#include <deal.II/base/patterns.h>

#include <output/event_parameters.h>

#include <algorithm>

namespace MixedCracks
{
  namespace Patterns = dealii::Patterns;

  void
  EventParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter(
      "Events",
      names,
      "What gets fields, a row of events.csv and a line of the log in the step "
      "it comes in, so that Fields every can be large: 'onset': damage begins "
      "that was not there at the start; 'crack length': all cracks together "
      "have grown by another Event crack length; 'boundary': a crack meets a "
      "boundary by name, a hole or a notch among them; 'separation': cracks "
      "join two sides of the body; or 'all'. In 2-d only, where paths of "
      "cracks are known. 'none': nothing of it.",
      Patterns::MultipleSelection("none|all|" +
                                  join_names(event_kinds(), "|")));
    prm.add_parameter("Event crack length",
                      length_step,
                      "Growth da of the length of all cracks, as in "
                      "crack_path.csv, from one event 'crack length' to the "
                      "next: there is one in every step in which floor((a - "
                      "a_0)/da) becomes larger, a_0 being the length at the "
                      "start. Unit: mm.",
                      Patterns::Double(0.));
    prm.leave_subsection();
  }



  std::vector<std::string>
  EventParameters::kinds() const
  {
    const std::vector<std::string> words = split_list(names, ',');
    const auto                     has   = [&words](const std::string &word) {
      return std::find(words.begin(), words.end(), word) != words.end();
    };
    std::vector<std::string> result;
    for (const std::string &kind : event_kinds())
      if (has("all") || has(kind))
        result.push_back(kind);
    return result;
  }



  void
  EventParameters::check(const int dim) const
  {
    const std::vector<std::string> words = split_list(names, ',');
    for (const char *const alone : {"none", "all"})
      if (words.size() > 1 &&
          std::find(words.begin(), words.end(), alone) != words.end())
        throw InputError(
          "Output/Events: found " + in_quotes(names) + "; allowed is '" +
          alone + "' alone, or a list of: " + join_names(event_kinds()) + ".");
    if (dim == 3 && !kinds().empty())
      throw InputError("Output/Events: found " + in_quotes(names) +
                       " with Geometry/Dimension = 3, allowed is none: paths "
                       "of cracks are known in 2-d only.");
    if (!(length_step > 0.))
      throw InputError("Output/Event crack length: found 0, allowed is a "
                       "number above 0.");
  }
} // namespace MixedCracks
