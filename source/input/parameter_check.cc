// SPDX-License-Identifier: GPL-2.0-or-later
// Messages about names and values that the .prm must not have: what was found,
// what is allowed, and what was probably meant. In this order of preference: a
// subsection in place of an entry, the place where an entry of that name
// exists, the nearest name in the same subsection, the nearest in the whole
// tree.

#include <base/names.h>
#include <base/ranges.h>
#include <base/text.h>

#include <deal.II/base/patterns.h>

#include <input/parameter_check.h>
#include <input/pattern_words.h>

namespace MixedCracks
{
  namespace
  {
    // "; it belongs in A/B or C", or nothing
    std::string
    other_places(const std::vector<std::string> &places)
    {
      return places.empty() ? ""
                            : "; it belongs in " + join_names(places, " or ");
    }

    std::string
    did_you_mean(const std::string &nearest)
    {
      return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
    }

    // What a subsection holds, in words.
    std::string
    content(const ParameterTree &tree, const std::vector<std::string> &path)
    {
      const std::vector<std::string> names       = tree.entry_names(path);
      const std::vector<std::string> subsections = tree.subsection_names(path);
      std::string                    text;
      if (!names.empty())
        text += " Entries of " + subsection_name(path) + ": " +
                join_names(names) + ".";
      if (!subsections.empty())
        text += " Subsections of " + subsection_name(path) + ": " +
                join_names(subsections) + ".";
      return text;
    }

    // The full name of the closest entry of the whole tree.
    std::string
    nearest_elsewhere(const ParameterTree &tree, const std::string &name)
    {
      std::vector<std::string> names;
      for (const ParameterEntry &entry : tree.entries())
        names.push_back(entry.name);
      const std::string nearest = nearest_name(name, names);
      for (const ParameterEntry &entry : tree.entries())
        if (entry.name == nearest)
          return entry.full_name();
      return "";
    }

    std::string
    with_stop(const std::string &sentence)
    {
      return sentence.back() == '?' ? sentence : sentence + ".";
    }
  } // namespace



  std::string
  value_problem(const ParameterEntry &entry, const std::string &value)
  {
    if (dealii::Patterns::pattern_factory(entry.pattern_description)
          ->match(value))
      return "";
    const std::string allowed = pattern_in_words(entry.pattern_description);
    if (value.empty())
      return entry.full_name() + ": no value; expected " + allowed + ".";

    const std::vector<std::string> choices =
      pattern_choices(entry.pattern_description);
    if (!choices.empty())
      return entry.full_name() + ": " + unknown_name_message(value, choices);
    return entry.full_name() + ": found " + in_quotes(value) + ", expected " +
           allowed + ".";
  }



  std::string
  unknown_entry_message(const ParameterTree            &tree,
                        const std::vector<std::string> &path,
                        const std::string              &name)
  {
    const std::vector<std::string> names = tree.entry_names(path);
    std::vector<std::string>       places;
    for (const ParameterEntry &entry : tree.entries())
      if (entry.name == name)
        places.push_back(subsection_name(entry.path));

    std::string hint;
    if (contains(tree.subsection_names(path), name))
      hint = "; it is a subsection: 'subsection " + name + "'";
    if (hint.empty())
      hint = other_places(places);
    if (hint.empty())
      hint = did_you_mean(nearest_name(name, names));
    if (hint.empty())
      hint = did_you_mean(nearest_elsewhere(tree, name));
    return with_stop("unknown entry " + in_quotes(name) + " in " +
                     subsection_name(path) + hint) +
           content(tree, path);
  }



  std::string
  unknown_subsection_message(const ParameterTree            &tree,
                             const std::vector<std::string> &path,
                             const std::string              &name)
  {
    std::vector<std::string> places;
    for (std::vector<std::string> subsection : tree.subsections())
      if (subsection.back() == name)
      {
        subsection.pop_back();
        places.push_back(subsection_name(subsection));
      }

    std::string hint;
    if (contains(tree.entry_names(path), name))
      hint = "; it is an entry: 'set " + name + " = ...'";
    if (hint.empty())
      hint = other_places(places);
    if (hint.empty())
      hint = did_you_mean(nearest_name(name, tree.subsection_names(path)));
    return with_stop("unknown subsection " + in_quotes(name) + " in " +
                     subsection_name(path) + hint) +
           content(tree, path);
  }
} // namespace MixedCracks
