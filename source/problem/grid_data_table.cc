// SPDX-License-Identifier: GPL-2.0-or-later
// Tables "x, y[, z], value", a line for each node of a grid, in any order. The
// axes are the different values of each column; as many lines as there are
// nodes, and none twice, make it a grid. Coordinates that differ by less than
// 1e-9 of the extent are one: tables are written with few digits.

#include <base/text.h>

#include <problem/grid_data.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace MixedCracks
{
  namespace
  {
    // of the extent of an axis: coordinates this close are one
    constexpr double relative_tolerance = 1e-9;

    // The numbers of a line; none when it holds anything else.
    std::vector<double>
    numbers_of(std::string line)
    {
      for (char &c : line)
        if (c == ',' || c == ';')
          c = ' ';
      std::vector<double> numbers;
      const char         *at  = line.c_str();
      char               *end = nullptr;
      for (double number = std::strtod(at, &end); end != at;
           number        = std::strtod(at, &end))
      {
        if (!std::isfinite(number))
          return {};
        numbers.push_back(number);
        at = end;
      }
      return std::string(at).find_first_not_of(" \t\r") == std::string::npos
               ? numbers
               : std::vector<double>();
    }

    // One row of numbers for each line.
    std::string
    read_rows(const std::string                &text,
              const int                         dim,
              std::vector<std::vector<double>> &rows)
    {
      unsigned int line_number  = 0;
      bool         may_be_names = true; // of the columns
      for (std::size_t begin = 0; begin < text.size();)
      {
        const std::size_t end  = std::min(text.find('\n', begin), text.size());
        const std::string line = single_spaced(text.substr(begin, end - begin));
        begin                  = end + 1;
        ++line_number;
        if (line.empty() || line[0] == '#')
          continue;
        rows.push_back(numbers_of(line));
        const std::size_t n = rows.back().size();
        if (n == 0 && may_be_names)
          rows.pop_back();
        else if (n < 3 || n > static_cast<std::size_t>(dim) + 1 ||
                 n != rows.front().size())
          return "has in line " + std::to_string(line_number) + " " +
                 in_quotes(line) + ", expected " +
                 (dim == 3 ? "'x, y, z, value' or 'x, y, value'"
                           : "'x, y, value'") +
                 ", in all lines alike";
        may_be_names = false;
      }
      return rows.empty() ? "holds no numbers" : "";
    }

    // The different values of a column, ascending.
    std::vector<double>
    axis_of(const std::vector<std::vector<double>> &rows,
            const std::size_t                       column)
    {
      std::vector<double> values;
      for (const std::vector<double> &row : rows)
        values.push_back(row[column]);
      std::sort(values.begin(), values.end());
      const double tolerance =
        relative_tolerance * (values.back() - values.front());
      values.erase(std::unique(values.begin(),
                               values.end(),
                               [tolerance](const double a, const double b) {
                                 return b - a <= tolerance;
                               }),
                   values.end());
      return values;
    }

    std::size_t
    index_on(const std::vector<double> &axis, const double x)
    {
      const double tolerance =
        relative_tolerance * (axis.back() - axis.front());
      return std::lower_bound(axis.begin(), axis.end(), x - tolerance) -
             axis.begin();
    }
  } // namespace



  std::string
  read_table(const std::string &text, const int dim, Table &table)
  {
    std::vector<std::vector<double>> rows;
    const std::string                problem = read_rows(text, dim, rows);
    if (!problem.empty())
      return problem;
    const std::size_t n_axes = rows.front().size() - 1;
    std::size_t       n      = 1;
    for (std::size_t d = 0; d < 3; ++d)
    {
      table.axes[d] =
        d < n_axes ? axis_of(rows, d) : std::vector<double>(1, 0.);
      // a product that is too large shall not overflow
      n = std::min(n * table.axes[d].size(), rows.size() + 1);
    }
    std::vector<bool> filled(rows.size(), false);
    table.values.assign(rows.size(), 0.);
    bool complete = n == rows.size();
    for (std::size_t i = 0; complete && i < rows.size(); ++i)
    {
      std::size_t at = 0;
      for (std::size_t d = n_axes; d-- > 0;)
        at = at * table.axes[d].size() + index_on(table.axes[d], rows[i][d]);
      complete         = !filled[at];
      filled[at]       = true;
      table.values[at] = rows[i].back();
    }
    if (complete)
      return "";
    std::string sizes;
    for (std::size_t d = 0; d < n_axes; ++d)
      sizes += (d == 0 ? "" : " x ") + std::to_string(table.axes[d].size());
    return "is no grid: " + std::to_string(rows.size()) + " lines with " +
           sizes +
           " different coordinates, where every combination is expected once";
  }
} // namespace MixedCracks
