// SPDX-License-Identifier: GPL-2.0-or-later
// deal.II describes a pattern by a text, as "[Double 0...MAX_DOUBLE
// (inclusive)]"; here it becomes words for messages and the manual, "a number,
// at least 0". What is not recognised stays as it is.

#include <base/names.h>
#include <base/text.h>

#include <input/pattern_words.h>

#include <limits>
#include <regex>

namespace MixedCracks
{
  namespace
  {
    // with bounds that mean none left out
    std::string
    with_range(const std::string &kind,
               const std::string &lower,
               const std::string &upper)
    {
      using Limits         = std::numeric_limits<int>;
      const bool has_lower = !lower.empty() && lower != "-MAX_DOUBLE" &&
                             lower != std::to_string(Limits::min());
      const bool has_upper = !upper.empty() && upper != "MAX_DOUBLE" &&
                             upper != std::to_string(Limits::max());
      if (has_lower && has_upper)
        return kind + " between " + lower + " and " + upper;
      return kind + (has_lower   ? ", at least " + lower
                     : has_upper ? ", at most " + upper
                                 : "");
    }

    std::string
    number_of_values(const std::string &lower, const std::string &upper)
    {
      if (upper != std::to_string(std::numeric_limits<unsigned int>::max()))
        return lower + (lower == upper ? "" : " to " + upper) + " values";
      return lower == "0" ? "any number of values"
                          : "at least " + lower + " values";
    }

    // whether a description is all of this, and the parts of it in parentheses
    bool
    is(const std::string &description,
       const std::regex  &form,
       std::smatch       &parts)
    {
      return std::regex_match(description, parts, form);
    }

    std::string
    list_in_words(const std::smatch &parts)
    {
      return number_of_values(parts[2], parts[3]) + " separated by '" +
             (parts[4].length() == 0 ? "," : parts[4].str()) + "', each " +
             pattern_in_words(parts[1]);
    }
  } // namespace



  std::vector<std::string>
  pattern_choices(const std::string &description)
  {
    static const std::regex selection(R"(\s*\[Selection (.*)\]\s*)");
    std::smatch             parts;
    return is(description, selection, parts) ? split_list(parts[1], '|')
                                             : std::vector<std::string>();
  }



  std::string
  pattern_in_words(const std::string &description)
  {
    static const std::regex number(
      R"(\[Double(?: (\S+)\.\.\.(\S+) \(inclusive\))?\])"),
      integer(R"(\[Integer(?: range (\S+)\.\.\.(\S+) \(inclusive\))?\])"),
      several(R"(\[MultipleSelection (.*)\])"), file(R"(\[FileName.*\])"),
      list(R"(\[List of <(.*)> of length (\d+)\.\.\.(\d+) \(inclusive\))"
           R"((?: separated by <(.*)>)?\])");
    const std::string text = single_spaced(description);
    std::smatch       parts;
    if (is(text, number, parts))
      return with_range("a number", parts[1], parts[2]);
    if (is(text, integer, parts))
      return with_range("a whole number", parts[1], parts[2]);
    if (text == "[Bool]")
      return "true or false";
    if (!pattern_choices(text).empty())
      return "one of: " + join_names(pattern_choices(text));
    if (is(text, several, parts))
      return "any of these, separated by ',': " +
             join_names(split_list(parts[1], '|'));
    if (text == "[Anything]")
      return "any text";
    if (is(text, file, parts))
      return "a file name";
    if (text == "[DirectoryName]")
      return "a directory";
    return is(text, list, parts) ? list_in_words(parts) : description;
  }
} // namespace MixedCracks
