// SPDX-License-Identifier: GPL-2.0-or-later
// deal.II describes a pattern by a text, as "[Double 0...MAX_DOUBLE
// (inclusive)]"; here it becomes words for messages and the manual, "a number,
// at least 0". What is not recognised stays as it is.

#include <base/names.h>
#include <base/text.h>

#include <input/pattern_words.h>

#include <limits>

namespace MixedCracks
{
  namespace
  {
    // Between the last "behind" and the next "before" that follows it; empty
    // when one of them is missing.
    std::string
    between(const std::string &text,
            const std::string &behind,
            const std::string &before)
    {
      const std::size_t mark = text.rfind(behind);
      if (mark == std::string::npos)
        return "";
      const std::size_t begin = mark + behind.size();
      const std::size_t end   = text.find(before, begin);
      return end == std::string::npos ? "" : text.substr(begin, end - begin);
    }

    struct Range
    {
      std::string lower;
      std::string upper;
    };

    // "a...b" with bounds that mean none left out
    Range
    range_of(const std::string &text)
    {
      const std::size_t dots = text.find("...");
      if (dots == std::string::npos)
        return {"", ""};
      Range range{single_spaced(text.substr(0, dots)),
                  single_spaced(text.substr(dots + 3))};
      using Limits = std::numeric_limits<int>;
      if (range.lower == "-MAX_DOUBLE" ||
          range.lower == std::to_string(Limits::min()))
        range.lower.clear();
      if (range.upper == "MAX_DOUBLE" ||
          range.upper == std::to_string(Limits::max()))
        range.upper.clear();
      return range;
    }

    std::string
    with_range(const std::string &kind, const Range &range)
    {
      if (range.lower.empty() && range.upper.empty())
        return kind;
      if (range.upper.empty())
        return kind + ", at least " + range.lower;
      if (range.lower.empty())
        return kind + ", at most " + range.upper;
      return kind + " between " + range.lower + " and " + range.upper;
    }

    std::string
    number_of_values(const std::string &lower, const std::string &upper)
    {
      const std::string unlimited =
        std::to_string(std::numeric_limits<unsigned int>::max());
      const bool has_upper = !upper.empty() && upper != unlimited;
      if (has_upper && lower == upper)
        return lower + " values";
      if (has_upper)
        return lower + " to " + upper + " values";
      if (lower.empty() || lower == "0")
        return "any number of values";
      return "at least " + lower + " values";
    }

    // "List of <[...]> of length a...b (inclusive) separated by <;>"
    std::string
    list_in_words(const std::string &text)
    {
      const std::size_t begin = text.find('<') + 1;
      const std::size_t end   = text.rfind("> of length ");
      if (end == std::string::npos || end < begin)
        return "";
      const std::string lengths = between(text, "> of length ", " (inclusive)");
      const std::size_t dots    = lengths.find("...");
      if (dots == std::string::npos)
        return "";
      const std::string separator = between(text, " separated by <", ">");
      return number_of_values(lengths.substr(0, dots),
                              lengths.substr(dots + 3)) +
             " separated by '" + (separator.empty() ? "," : separator) +
             "', each " + pattern_in_words(text.substr(begin, end - begin));
    }

    // without the brackets, and without the word if it starts with it
    std::string
    inner(const std::string &description, const std::string &word = "")
    {
      const std::string text = single_spaced(description);
      if (text.size() < 2 || text.front() != '[' || text.back() != ']')
        return "";
      const std::string body = text.substr(1, text.size() - 2);
      return starts_with(body, word) ? body.substr(word.size()) : "";
    }
  } // namespace



  std::vector<std::string>
  pattern_choices(const std::string &description)
  {
    return split_list(inner(description, "Selection "), '|');
  }



  std::string
  pattern_in_words(const std::string &description)
  {
    const std::string body  = inner(description);
    const std::string range = body.substr(0, body.rfind(" (inclusive)"));
    std::string       words;
    if (starts_with(body, "Double"))
      words = with_range("a number", range_of(range.substr(6)));
    else if (starts_with(body, "Integer range "))
      words = with_range("a whole number", range_of(range.substr(14)));
    else if (body == "Integer")
      words = "a whole number";
    else if (body == "Bool")
      words = "true or false";
    else if (starts_with(body, "Selection "))
      words = "one of: " + join_names(pattern_choices(description));
    else if (starts_with(body, "MultipleSelection "))
      words =
        "any of these, separated by ',': " +
        join_names(split_list(inner(description, "MultipleSelection "), '|'));
    else if (body == "Anything")
      words = "any text";
    else if (starts_with(body, "FileName"))
      words = "a file name";
    else if (body == "DirectoryName")
      words = "a directory";
    else if (starts_with(body, "List of <"))
      words = list_in_words(body);
    return words.empty() ? description : words;
  }
} // namespace MixedCracks
