// SPDX-License-Identifier: GPL-2.0-or-later
// A name for a case that is the same wherever and however the case is written:
// a checksum of
//
//   schema 1
//   Geometry/Mesh file/File name = 5323 bytes, checksum 1234
//   Load stepping/Force boundary = top
//   Material/Critical energy release rate = 2.7
//   ...
//
// in the order of names. Which entries count is a matter of resume_rules():
// those that a resumed run may have otherwise do not (unless asked for), since
// runs and pieces of runs with them are of one problem. A default that is
// derived from other entries is written out, whether it was given or not.

#include <base/checksum.h>
#include <base/names.h>
#include <base/text.h>

#include <input/canonical_text.h>
#include <input/case_id.h>
#include <input/case_signature.h>
#include <input/parameter_paths.h>
#include <input/parameter_tree.h>

#include <cstdio>

namespace MixedCracks
{
  namespace
  {
    bool
    counts(const ParameterEntry &entry,
           const std::string    &geometry,
           const bool            with_what_may_change)
    {
      const std::string       name = entry.full_name();
      const ResumeRule *const rule = resume_rule(name);
      return entry.path.front() != "Output" &&
             !is_of_other_geometry(name, geometry) &&
             (with_what_may_change || rule == nullptr ||
              rule->change != ResumeRule::yes);
    }



    // "+6" is a number in a pattern for numbers only
    std::string
    canonical_number(const std::string &value)
    {
      const std::string number =
        canonical_text(starts_with(value, "+") ? value.substr(1) : value);
      return number == "-0" ? "0" : number;
    }



    std::string
    canonical_value(const std::string &pattern, const std::string &value)
    {
      if (starts_with(pattern, "[Double") || starts_with(pattern, "[Integer"))
        return canonical_number(value);
      if (starts_with(pattern, "[List of <[Double"))
      {
        std::vector<std::string> items = split_list(value, ',');
        for (std::string &item : items)
          item = canonical_number(item);
        return join_names(items, ",");
      }
      if (starts_with(pattern, "[Bool"))
        return value == "yes" ? "true" : value == "no" ? "false" : value;
      return canonical_text(value);
    }
  } // namespace



  unsigned int
  case_id_schema()
  {
    return 1;
  }



  const std::vector<std::string> &
  case_id_scopes()
  {
    static const std::vector<std::string> scopes{"problem", "full"};
    return scopes;
  }



  std::string
  case_id_text(const dealii::ParameterHandler &prm,
               const EffectiveValues          &derived,
               const std::string              &scope,
               const MPI_Comm                  communicator)
  {
    const ParameterTree                tree(prm);
    const ParameterEntry *const        name = tree.find({"Geometry"}, "Name");
    const std::string                  geometry = name ? name->value : "";
    std::map<std::string, std::string> lines;
    for (const ParameterEntry &entry : tree.entries())
    {
      if (!counts(entry, geometry, scope == "full"))
        continue;
      const std::string full_name = entry.full_name();
      const auto        effective = derived.find(full_name);
      const auto        canonical = [&entry](const std::string &value) {
        return canonical_value(entry.pattern_description, value);
      };
      if (effective != derived.end())
        lines[full_name] = canonical(effective->second);
      else if (canonical(entry.value) == canonical(entry.default_value))
        continue;
      else
        lines[full_name] =
          names_input_file(entry)
            ? description_of_file(entry.value, communicator)
            : canonical(with_contents_of_tables(entry.value, communicator));
    }
    std::string text = "schema " + std::to_string(case_id_schema()) + '\n';
    for (const auto &[full_name, value] : lines)
      text += full_name + " = " + value + '\n';
    return text;
  }



  // The last bytes of a text change few bits of its checksum; with the checksum
  // behind it they change all, and ids may be abbreviated.
  std::string
  case_id(const std::string &text)
  {
    const std::uint64_t sum = checksum(text + std::to_string(checksum(text)));
    char                digits[17];
    std::snprintf(
      digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(sum));
    return digits;
  }
} // namespace MixedCracks
