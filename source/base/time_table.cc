// SPDX-License-Identifier: GPL-2.0-or-later
// table("load.csv"): a value over time. With rows (t_i, v_i), t_0 < t_1 < ...,
//
//   v(t) = v_0                                          t <= t_0
//        = v_i + (v_(i+1) - v_i) (t - t_i)/(t_(i+1) - t_i)   between
//        = v_n                                          t >= t_n
//
// That a run ends later than its table is refused before it begins
// (simulation/time_tables.cc).
//
// Files are read once, by the first rank, before any expression is made; what
// they hold is kept here by their names, for an expression does not
// communicate.

#include <base/errors.h>
#include <base/ranges.h>
#include <base/text.h>
#include <base/time_table.h>

#include <algorithm>
#include <map>
#include <optional>

namespace MixedCracks
{
  namespace
  {
    std::map<std::string, std::shared_ptr<const TimeTable>> &
    kept_tables()
    {
      static std::map<std::string, std::shared_ptr<const TimeTable>> tables;
      return tables;
    }

    std::size_t
    behind_blanks(const std::string &text, std::size_t i)
    {
      while (i < text.size() && is_blank(text[i]))
        ++i;
      return i;
    }

    // The end of what is at @p begin if it is the character, else npos.
    std::size_t
    behind(const std::string &text, const std::size_t begin, const char c)
    {
      const std::size_t i =
        begin == std::string::npos ? begin : behind_blanks(text, begin);
      return i < text.size() && text[i] == c ? i + 1 : std::string::npos;
    }

    bool
    begins_word(const std::string &text, const std::size_t i)
    {
      return i == 0 ||
             !(std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0 ||
               text[i - 1] == '_' || text[i - 1] == '.');
    }
  } // namespace



  // "" when the line is a row, is empty, or names columns
  std::string
  TimeTable::add_line(const std::string &line)
  {
    const std::string expected =
      ", expected 'time, value', two numbers parted by a comma; decimals take "
      "a point";
    std::vector<std::optional<double>> numbers;
    for (const std::string &field : split_list(line, ','))
      numbers.push_back(number_in(field));
    const bool is_of_names =
      !any_of(numbers, [](const auto &number) { return number.has_value(); });
    const bool has_digit_first = is_digit(line[0]) || line[0] == '-';
    if (times.empty() && is_of_names && !has_digit_first)
      return "";
    if (numbers.size() != 2 || !numbers[0] || !numbers[1])
      return in_quotes(line) + expected;
    if (!times.empty() && !(*numbers[0] > times.back()))
      return in_quotes(line) + ", whose time is not later than that before; "
                               "times have to increase";
    times.push_back(*numbers[0]);
    values.push_back(*numbers[1]);
    return "";
  }



  std::string
  TimeTable::read(const std::string &text)
  {
    const std::string byte_order_mark = "\xef\xbb\xbf";
    unsigned int      line_number     = 0;
    std::size_t       begin =
      starts_with(text, byte_order_mark) ? byte_order_mark.size() : 0;
    while (begin < text.size())
    {
      const std::size_t end  = std::min(text.find('\n', begin), text.size());
      const std::string line = single_spaced(text.substr(begin, end - begin));
      begin                  = end + 1;
      ++line_number;
      if (line.empty() || line[0] == '#')
        continue;
      const std::string problem = add_line(line);
      if (!problem.empty())
        return "has in line " + std::to_string(line_number) + ' ' + problem;
    }
    return times.size() > 1
             ? ""
             : "has " + std::string(times.empty() ? "no" : "one") +
                 " row, expected at least two of 'time, value'";
  }



  double
  TimeTable::operator()(const double time) const
  {
    if (time <= times.front())
      return values.front();
    const auto        next = std::upper_bound(times.begin(), times.end(), time);
    const std::size_t i    = next - times.begin();
    if (next == times.end())
      return values.back();
    return values[i - 1] + (values[i] - values[i - 1]) * (time - times[i - 1]) /
                             (times[i] - times[i - 1]);
  }



  std::vector<TableCall>
  table_calls(const std::string &text)
  {
    const std::string      name = "table";
    std::vector<TableCall> calls;
    for (std::size_t i = text.find(name); i != std::string::npos;
         i             = text.find(name, i + 1))
    {
      const std::size_t quote =
        behind(text, behind(text, i + name.size(), '('), '"');
      const std::size_t closing =
        quote == std::string::npos ? quote : text.find('"', quote);
      const std::size_t end =
        closing == std::string::npos ? closing : behind(text, closing + 1, ')');
      if (begins_word(text, i) && end != std::string::npos && closing > quote)
        calls.push_back({i, end, text.substr(quote, closing - quote)});
    }
    return calls;
  }



  std::string
  replace_tables(const std::string                                   &text,
                 const std::function<std::string(const TableCall &)> &what)
  {
    std::string result;
    std::size_t done = 0;
    for (const TableCall &call : table_calls(text))
    {
      result += text.substr(done, call.begin - done) + what(call);
      done = call.end;
    }
    return result + text.substr(done);
  }



  void
  keep_time_table(const std::string &path, const TimeTable &table)
  {
    kept_tables()[path] = std::make_shared<const TimeTable>(table);
  }



  std::shared_ptr<const TimeTable>
  kept_time_table(const std::string &path)
  {
    const auto found = kept_tables().find(path);
    return found == kept_tables().end() ? nullptr : found->second;
  }
} // namespace MixedCracks
