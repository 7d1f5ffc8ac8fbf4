// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers and texts in CSV files for other programs. There is no word for
// infinity or NaN that readers agree on: an empty field stands for it.

#include <base/finite_text.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace MixedCracks
{
  namespace
  {
    // Writes no number that is not finite.
    class FiniteNumbers : public std::num_put<char>
    {
    protected:
      iter_type
      do_put(iter_type      out,
             std::ios_base &stream,
             const char     fill,
             const double   value) const override
      {
        return std::isfinite(value)
                 ? std::num_put<char>::do_put(out, stream, fill, value)
                 : out;
      }
    };

    std::string
    printed_number(const double value, const int digits)
    {
      char buffer[64];
      std::snprintf(buffer, sizeof(buffer), "%.*g", digits, value);
      return buffer;
    }
  } // namespace



  std::string
  csv_number(const double value, const int digits)
  {
    return std::isfinite(value) ? printed_number(value, digits) : "";
  }



  std::string
  csv_field(const std::string &text)
  {
    if (text.find_first_of(",\"\r\n") == std::string::npos)
      return text;
    std::string result = "\"";
    for (const char c : text)
      result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
  }



  std::vector<std::string>
  csv_fields(const std::string &line)
  {
    std::vector<std::string> fields(1);
    bool                     quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      const char c = line[i];
      if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
        fields.back() += line[++i];
      else if (c == '"' && (quoted || fields.back().empty()))
        quoted = !quoted;
      else if (c == ',' && !quoted)
        fields.emplace_back();
      else if (c != '\r' || quoted)
        fields.back() += c;
    }
    return fields;
  }



  std::locale
  csv_locale()
  {
    return std::locale(std::locale::classic(), new FiniteNumbers);
  }



  double
  printable(const double value)
  {
    const double largest = std::numeric_limits<double>::max();
    return std::isnan(value) ? 0. : std::clamp(value, -largest, largest);
  }
} // namespace MixedCracks
