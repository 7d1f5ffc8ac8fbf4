// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers and texts in files for other programs. CSV and JSON have no word for
// infinity or NaN that readers agree on: an empty field and null stand for it.
// JSON has to be UTF-8; bytes that are not become U+FFFD, with RFC 3629's rules
// for which sequences are characters.

#include <base/finite_text.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
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

    // Length of the UTF-8 character that begins at text[i]; 0 when none does.
    std::size_t
    length_of_character(const std::string &text, const std::size_t i)
    {
      const auto byte = [&text](const std::size_t k) -> unsigned int {
        return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
      };
      const unsigned int first = byte(i);
      const std::size_t  n     = first < 0x80   ? 1
                                 : first < 0xc2 ? 0
                                 : first < 0xe0 ? 2
                                 : first < 0xf0 ? 3
                                 : first < 0xf5 ? 4
                                                : 0;
      for (std::size_t k = 1; k < n; ++k)
        if ((byte(i + k) & 0xc0) != 0x80)
          return 0;
      // longer than need be, halves of pairs, beyond the last one
      if ((first == 0xe0 && byte(i + 1) < 0xa0) ||
          (first == 0xed && byte(i + 1) > 0x9f) ||
          (first == 0xf0 && byte(i + 1) < 0x90) ||
          (first == 0xf4 && byte(i + 1) > 0x8f))
        return 0;
      return n;
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



  std::string
  json_number(const double value, const int digits)
  {
    return std::isfinite(value) ? printed_number(value, digits) : "null";
  }



  std::string
  json_string(const std::string &text)
  {
    std::string result = "\"";
    for (std::size_t i = 0; i < text.size();)
    {
      const unsigned char c = static_cast<unsigned char>(text[i]);
      const std::size_t   n = length_of_character(text, i);
      if (c < 0x20)
      {
        char buffer[8];
        std::snprintf(buffer, sizeof(buffer), "\\u%04x", c);
        result += buffer;
      }
      else if (n == 0)
        result += "\\ufffd";
      else
        result += (c == '"' || c == '\\' ? "\\" : "") + text.substr(i, n);
      i += n == 0 ? 1 : n;
    }
    return result + '"';
  }
} // namespace MixedCracks
