// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_time_table_h
#define mixed_cracks_base_time_table_h

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A value over time (s), linear between the rows of a file and constant
  /// before the first and after the last one.
  class TimeTable
  {
  public:
    /// Rows 'time, value' with times that increase, at least two; lines of
    /// names at the top, empty lines and lines with # are passed over. Returns
    /// what is wrong, with the number of the line, or "".
    std::string read(const std::string &text);

    double operator()(double time) const;

    double
    last_time() const
    {
      return times.back();
    }

  private:
    std::string add_line(const std::string &line);

    std::vector<double> times, values;
  };

  /// One 'table("FILE")' in an expression.
  struct TableCall
  {
    std::size_t begin, end; ///< of the text it takes
    std::string path;
  };

  /// Those in @p text, in their order. What is written otherwise is none.
  std::vector<TableCall> table_calls(const std::string &text);

  /// @p text with each call replaced by what @p what says.
  std::string
  replace_tables(const std::string                                   &text,
                 const std::function<std::string(const TableCall &)> &what);

  /// Expressions that call for the table at @p path find @p table from now on.
  void keep_time_table(const std::string &path, const TimeTable &table);

  /// What was kept for @p path; null for nothing.
  std::shared_ptr<const TimeTable> kept_time_table(const std::string &path);
} // namespace MixedCracks

#endif
