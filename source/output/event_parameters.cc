// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>
#include <base/names.h>
#include <base/ranges.h>
#include <base/text.h>

#include <cracks/crack_events.h>

#include <deal.II/base/patterns.h>

#include <output/event_parameters.h>

#include <utility>

namespace MixedCracks
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    // as the list of parameters is the same in both
    std::vector<std::string>
    kinds_of_both_dimensions()
    {
      std::vector<std::string> kinds = event_kinds(2);
      for (const std::string &kind : event_kinds(3))
        if (!contains(kinds, kind))
          kinds.push_back(kind);
      return kinds;
    }
  } // namespace



  void
  EventParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter(
      "Events",
      names,
      "What gets fields, a row of events.csv and a line of the log in the step "
      "it comes in, so that Fields every can be large: 'onset': damage begins "
      "that was not there at the start; 'crack length' (2-d): all cracks "
      "together have grown by another Event crack length; 'crack area' (3-d): "
      "by another Event crack area; 'boundary': a crack meets a boundary by "
      "name, a hole or a notch among them; 'separation': cracks join two sides "
      "of the body, in 3-d it is in two parts; or 'all' of the dimension. "
      "'none': nothing of it.",
      Patterns::MultipleSelection("none|all|" +
                                  join_names(kinds_of_both_dimensions(), "|")));
    prm.add_parameter("Event crack length",
                      length_step,
                      "Growth da of the length of all cracks, as in "
                      "crack_path.csv, from one event 'crack length' to the "
                      "next: there is one in every step in which floor((a - "
                      "a_0)/da) becomes larger, a_0 being the length at the "
                      "start. In 2-d. Unit: mm.",
                      Patterns::Double(0.));
    prm.add_parameter("Event crack area",
                      area_step,
                      "Growth dA of the area of all cracks, as in "
                      "crack_sheet.csv, from one event 'crack area' to the "
                      "next: there is one in every step in which floor((A - "
                      "A_0)/dA) becomes larger, A_0 being the area at the "
                      "start. In 3-d. Unit: mm^2.",
                      Patterns::Double(0.));
    prm.leave_subsection();
  }



  std::vector<std::string>
  EventParameters::kinds(const int dim) const
  {
    const std::vector<std::string> words = split_list(names, ',');
    std::vector<std::string>       result;
    for (const std::string &kind : event_kinds(dim))
      if (contains(words, "all") || contains(words, kind))
        result.push_back(kind);
    return result;
  }



  void
  EventParameters::check(const int dim) const
  {
    const std::vector<std::string> words   = split_list(names, ',');
    const std::vector<std::string> allowed = event_kinds(dim);
    for (const char *const alone : {"none", "all"})
      if (words.size() > 1 && contains(words, alone))
        throw InputError("Output/Events: found " + in_quotes(names) +
                         "; allowed is '" + alone +
                         "' alone, or a list of: " + join_names(allowed) + ".");
    for (const std::string &word : words)
      if (word != "none" && word != "all" && !contains(allowed, word))
        throw InputError("Output/Events: found '" + word +
                         "' with Geometry/Dimension = " + std::to_string(dim) +
                         "; allowed is 'none', 'all', or a list of: " +
                         join_names(allowed) + ".");
    for (const auto &[entry, step] :
         {std::pair("length", length_step), std::pair("area", area_step)})
      if (!(step > 0.))
        throw InputError(std::string("Output/Event crack ") + entry +
                         ": found 0, allowed is a number above 0.");
  }
} // namespace MixedCracks
