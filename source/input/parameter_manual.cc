// SPDX-License-Identifier: GPL-2.0-or-later
// What --parameters prints: all entries as a .prm with comments, as JSON for
// programs, or as Markdown, which is doc/parameters.md
// (tests/house/check_manual.py compares). One list, ParameterTree, for all
// three.

#include <base/errors.h>
#include <base/names.h>

#include <input/parameter_manual.h>
#include <input/parameter_tree.h>
#include <input/pattern_words.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    using Path = ParameterTree::Path;

    // The text as comment lines of at most 80 characters. A word that is
    // longer stays whole.
    void
    print_comment(std::ostream      &out,
                  const std::string &indent,
                  const std::string &text)
    {
      std::istringstream stream(text);
      std::string        line, word;
      while (stream >> word)
      {
        if (!line.empty() && indent.size() + line.size() + word.size() + 3 > 80)
        {
          out << indent << '#' << line << '\n';
          line.clear();
        }
        line += " " + word;
      }
      if (!line.empty())
        out << indent << '#' << line << '\n';
    }

    // Leave and enter subsections until @p open is @p wanted.
    void
    change_subsection(std::ostream &out, Path &open, const Path &wanted)
    {
      const auto common = static_cast<std::size_t>(
        std::mismatch(open.begin(), open.end(), wanted.begin(), wanted.end())
          .first -
        open.begin());
      while (open.size() > common)
      {
        open.pop_back();
        out << std::string(2 * open.size(), ' ') << "end\n";
      }
      while (open.size() < wanted.size())
      {
        out << '\n'
            << std::string(2 * open.size(), ' ') << "subsection "
            << wanted[open.size()] << '\n';
        open.push_back(wanted[open.size()]);
      }
    }

    void
    print_prm(std::ostream &out, const ParameterTree &tree)
    {
      Path open;
      bool needs_blank_line = false;
      for (const ParameterEntry &entry : tree.entries())
      {
        needs_blank_line = needs_blank_line && entry.path == open;
        change_subsection(out, open, entry.path);
        const std::string indent(2 * open.size(), ' ');
        if (needs_blank_line)
          out << '\n';
        needs_blank_line = true;
        print_comment(out, indent, entry.documentation);
        print_comment(
          out,
          indent,
          "Allowed: " + pattern_in_words(entry.pattern_description) +
            ". Default: " +
            (entry.default_value.empty() ? std::string("empty")
                                         : entry.default_value) +
            ".");
        out << indent << "set " << entry.name << " ="
            << (entry.value.empty() ? "" : " ") << entry.value << '\n';
      }
      change_subsection(out, open, {});
    }

    void
    print_json(std::ostream &out, const ParameterTree &tree)
    {
      nlohmann::ordered_json all = nlohmann::ordered_json::array();
      for (const ParameterEntry &entry : tree.entries())
        all.push_back({{"full_name", entry.full_name()},
                       {"subsections", entry.path},
                       {"name", entry.name},
                       {"value", entry.value},
                       {"default_value", entry.default_value},
                       {"allowed", pattern_in_words(entry.pattern_description)},
                       {"pattern", entry.pattern_description},
                       {"documentation", entry.documentation}});
      out << all.dump(
               2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
          << '\n';
    }

    // Formulas must not turn into emphasis or tags.
    std::string
    markdown_text(const std::string &text)
    {
      std::string result;
      for (const char c : text)
      {
        if (std::string("\\*_<`[]|").find(c) != std::string::npos)
          result += '\\';
        result += c;
      }
      return result;
    }

    void
    print_markdown_entry(std::ostream &out, const ParameterEntry &entry)
    {
      out << "\n### " << markdown_text(entry.name) << "\n\n";
      if (!entry.documentation.empty())
        out << markdown_text(entry.documentation) << "\n\n";
      if (entry.default_value.empty())
        out << "- Default: empty\n";
      else
        out << "- Default: `" << entry.default_value << "`\n";
      out << "- Allowed: "
          << markdown_text(pattern_in_words(entry.pattern_description)) << '\n';
    }

    void
    print_markdown(std::ostream &out, const ParameterTree &tree)
    {
      out << "# Parameters\n\nEvery entry of a parameter file, by subsection. "
             "Units: mm, N, MPa, s.\n";
      std::vector<Path> subsections = tree.subsections();
      subsections.insert(subsections.begin(), Path());
      for (const Path &path : subsections)
      {
        if (tree.entry_names(path).empty())
          continue;
        out << "\n## "
            << (path.empty() ? "Top level"
                             : markdown_text(subsection_name(path)))
            << '\n';
        for (const ParameterEntry &entry : tree.entries())
          if (entry.path == path)
            print_markdown_entry(out, entry);
      }
    }
  } // namespace



  const std::vector<std::string> &
  parameter_formats()
  {
    static const std::vector<std::string> formats{"prm", "json", "markdown"};
    return formats;
  }



  void
  print_parameters(std::ostream                   &out,
                   const dealii::ParameterHandler &prm,
                   const std::string              &format)
  {
    const ParameterTree tree(prm);
    if (format == "prm")
      print_prm(out, tree);
    else if (format == "json")
      print_json(out, tree);
    else if (format == "markdown")
      print_markdown(out, tree);
    else
      throw InputError("--parameters: " +
                       unknown_name_message(format, parameter_formats()));
  }
} // namespace MixedCracks
