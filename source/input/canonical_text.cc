// SPDX-License-Identifier: GPL-2.0-or-later
// Two texts that mean the same get one form, for the question whether a run
// that is resumed has the case it had: numbers by their value to 17 digits
// ("1.0" and "1e0"), without blanks that separate nothing and without empty
// items of lists. Formulas are not evaluated: "2*t" and "t*2" are different.

#include <base/text.h>

#include <input/canonical_text.h>

#include <cctype>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    // of a name or a number
    bool
    is_in_word(const char c)
    {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
             c == '.';
    }

    // the end of the name or number that begins at @p begin; the sign of an
    // exponent belongs to a number
    std::size_t
    end_of_word(const std::string &text, const std::size_t begin)
    {
      const bool  is_number = is_digit(text[begin]) || text[begin] == '.';
      std::size_t end       = begin;
      const auto  is_exponent_sign = [&]() {
        return is_number && end > begin &&
               (text[end - 1] == 'e' || text[end - 1] == 'E') &&
               (text[end] == '+' || text[end] == '-');
      };
      while (end < text.size() && (is_in_word(text[end]) || is_exponent_sign()))
        ++end;
      return end;
    }

    // A number by its value; any other word, and what may be a label rather
    // than a number ("007"), as it is.
    std::string
    canonical_word(const std::string &word)
    {
      const bool is_label =
        word.size() > 1 && word[0] == '0' && is_digit(word[1]);
      if (is_label || !(is_digit(word[0]) || word[0] == '.'))
        return word;
      std::istringstream in(word);
      in.imbue(std::locale::classic());
      double value = 0.;
      if (!(in >> value) || in.peek() != std::istringstream::traits_type::eof())
        return word;
      std::ostringstream out;
      out.imbue(std::locale::classic());
      out << std::setprecision(std::numeric_limits<double>::max_digits10)
          << value;
      return out.str();
    }

    bool
    is_end_of_item(const std::string &text)
    {
      return text.empty() || text.back() == ';';
    }
  } // namespace



  std::string
  canonical_text(const std::string &value)
  {
    std::string result;
    for (std::size_t i = 0; i < value.size();)
      if (is_blank(value[i]))
        ++i;
      else if (is_in_word(value[i]))
      {
        const std::size_t end = end_of_word(value, i);
        if (i > 0 && is_blank(value[i - 1]) && !result.empty() &&
            is_in_word(result.back()))
          result += ' ';
        result += canonical_word(value.substr(i, end - i));
        i = end;
      }
      else
      {
        if (value[i] != ';' || !is_end_of_item(result))
          result += value[i];
        ++i;
      }
    if (!result.empty() && result.back() == ';')
      result.pop_back();
    return result;
  }
} // namespace MixedCracks
