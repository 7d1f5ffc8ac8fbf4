// SPDX-License-Identifier: GPL-2.0-or-later
// Statements of a .prm, checked against the tree of known entries:
//
//   subsection NAME ... end        set ENTRY = VALUE
//
// and "Subsection/.../Entry=value" of --set. Errors are collected, not thrown.
// One mistake shall not cause others: what is inside of an unknown subsection
// is skipped, and a forgotten "end" is guessed where a subsection appears that
// exists further out; as many superfluous "end" are then forgiven.
//
// An entry that is set twice is an error, in the files as by --set, since the
// last value would win in silence. --set wins over the files: it is assigned
// later.

#include <base/text.h>

#include <deal.II/base/utilities.h>

#include <input/parameter_check.h>
#include <input/parameter_parser.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace MixedCracks
{
  namespace
  {
    using dealii::Utilities::trim;

    std::string
    lower_case(std::string text)
    {
      std::transform(
        text.begin(), text.end(), text.begin(), [](unsigned char c) {
          return static_cast<char>(std::tolower(c));
        });
      return text;
    }
  } // namespace



  ParameterParser::ParameterParser(const ParameterTree &tree)
    : tree(tree)
  {}



  void
  ParameterParser::parse_file(const std::vector<SourceLine> &lines)
  {
    for (const SourceLine &line : lines)
      parse_statement(line);
    for (const OpenSubsection &subsection : open)
      report(subsection.line.place(),
             "the 'end' of subsection " + in_quotes(subsection.name) +
               " is missing.");
    open.clear();
  }



  void
  ParameterParser::parse_statement(const SourceLine &line)
  {
    const std::size_t blank   = line.text.find_first_of(" \t");
    const std::string keyword = lower_case(line.text.substr(0, blank));
    const std::string rest =
      blank == std::string::npos ? "" : trim(line.text.substr(blank));
    if (keyword == "subsection")
      open_subsection(line, single_spaced(rest));
    else if (keyword == "end")
      close_subsection(line, rest);
    else if (keyword == "set")
      set(line, rest);
    else
      report_malformed(line);
  }



  std::vector<std::string>
  ParameterParser::path() const
  {
    std::vector<std::string> names;
    for (const OpenSubsection &subsection : open)
      names.push_back(subsection.name);
    return names;
  }



  void
  ParameterParser::open_subsection(const SourceLine  &line,
                                   const std::string &name)
  {
    std::vector<std::string> deeper = path();
    deeper.push_back(name);
    bool is_known = open.empty() || open.back().is_known;
    if (name.empty())
    {
      report(line.place(), "expected 'subsection NAME', found no name.");
      is_known = false;
    }
    else if (is_known && !tree.has_subsection(deeper) &&
             !recover_from_missing_end(line, name))
    {
      report(line.place(), unknown_subsection_message(tree, path(), name));
      is_known = false;
    }
    open.push_back({name, line, is_known});
  }



  // A forgotten 'end' would make everything behind it unknown. When the
  // subsection exists further out, go there.
  bool
  ParameterParser::recover_from_missing_end(const SourceLine  &line,
                                            const std::string &name)
  {
    for (std::size_t depth = open.size(); depth-- > 0;)
    {
      std::vector<std::string> outer = path();
      outer.resize(depth);
      outer.push_back(name);
      if (!tree.has_subsection(outer))
        continue;
      const OpenSubsection &unclosed = open[depth];
      report(line.place(),
             "subsection " + in_quotes(name) + " does not belong in " +
               subsection_name(path()) + "; is the 'end' of subsection " +
               in_quotes(unclosed.name) + " of " + unclosed.line.place() +
               " missing?");
      n_ends_to_forgive += static_cast<unsigned int>(open.size() - depth);
      open.resize(depth);
      return true;
    }
    return false;
  }



  void
  ParameterParser::close_subsection(const SourceLine  &line,
                                    const std::string &rest)
  {
    if (!rest.empty())
      report(line.place(),
             "'end' stands alone on its line, found " + in_quotes(line.text) +
               ".");
    if (open.empty())
    {
      if (n_ends_to_forgive == 0)
        report(line.place(), "'end' without a subsection to close.");
      else
        --n_ends_to_forgive;
      return;
    }
    const OpenSubsection &closed = open.back();
    if (closed.line.file != line.file)
      report(line.place(),
             "this 'end' would close subsection " + in_quotes(closed.name) +
               " of another file (" + closed.line.place() +
               "); every file closes its own subsections.");
    open.pop_back();
  }



  void
  ParameterParser::set(const SourceLine &line, const std::string &assignment)
  {
    const std::size_t equals = assignment.find('=');
    const std::string name   = single_spaced(assignment.substr(0, equals));
    if (equals == std::string::npos || name.empty())
      return report(line.place(),
                    "expected 'set ENTRY = VALUE', found " +
                      in_quotes(line.text) + ".");
    if (!open.empty() && !open.back().is_known)
      return;

    const std::string full_name =
      (open.empty() ? "" : subsection_name(path()) + "/") + name;
    const auto [first, is_new] =
      first_settings.emplace(line.file + '\n' + full_name, line);
    if (!is_new && first->second.number != line.number)
      return report(line.place(),
                    full_name + " is set twice, first in line " +
                      std::to_string(first->second.number) + ".");
    const std::string folder =
      std::filesystem::path(line.file).parent_path().string();
    assign(line.place(),
           folder.empty() ? "." : folder,
           path(),
           name,
           trim(assignment.substr(equals + 1)));
  }



  void
  ParameterParser::report_malformed(const SourceLine &line)
  {
    std::string hint;
    if (line.text.find('=') != std::string::npos)
      hint = "; is 'set' missing in front?";
    else
      hint = "; expected 'subsection NAME', 'set ENTRY = VALUE', 'end' or "
             "'include FILE'.";
    report(line.place(), "cannot understand " + in_quotes(line.text) + hint);
  }



  void
  ParameterParser::parse_override(const std::string &text)
  {
    const std::string        place  = "--set " + in_quotes(text);
    const std::size_t        equals = text.find('=');
    std::vector<std::string> names  = split_list(text.substr(0, equals), '/');
    if (equals == std::string::npos || names.empty())
      return report(place, "expected 'Subsection/.../Entry=value'.");

    const std::string value = trim(text.substr(equals + 1));
    // parameters.prm could not hold these
    if (value.find_first_of("#\n\r") != std::string::npos ||
        (!value.empty() && value.back() == '\\'))
      return report(place,
                    "a value cannot hold '#' or a line break, nor end with a "
                    "backslash.");
    for (std::string &name : names)
      name = single_spaced(name);
    if (!first_settings
           .emplace("--set\n" + subsection_name(names), SourceLine{})
           .second)
      return report(place, subsection_name(names) + " is set twice by --set.");
    const std::string name = names.back();
    names.pop_back();

    for (std::size_t depth = 1; depth <= names.size(); ++depth)
      if (!tree.has_subsection({names.begin(), names.begin() + depth}))
        return report(
          place,
          unknown_subsection_message(tree,
                                     {names.begin(), names.begin() + depth - 1},
                                     names[depth - 1]));
    assign(place, "", names, name, value);
  }



  void
  ParameterParser::assign(const std::string              &place,
                          const std::string              &folder,
                          const std::vector<std::string> &path,
                          const std::string              &name,
                          const std::string              &value)
  {
    const ParameterEntry *const entry = tree.find(path, name);
    if (entry == nullptr)
      return report(place, unknown_entry_message(tree, path, name));
    const std::string problem = value_problem(*entry, value);
    if (!problem.empty())
      return report(place, problem);
    accepted.push_back({entry, value, place, folder});
  }



  void
  ParameterParser::report(const std::string &place, const std::string &message)
  {
    messages.push_back(place + ": " + message);
  }
} // namespace MixedCracks
