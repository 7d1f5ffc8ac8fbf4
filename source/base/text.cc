// SPDX-License-Identifier: GPL-2.0-or-later
// Pieces of text, and numbers in them. Numbers are read in the classic locale,
// and all of the text has to be a number: "1,5" and "3 mm" are mistakes, not 1
// and 3.

#include <base/errors.h>
#include <base/text.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    // NaN when the text is not one finite number. The classic locale: a
    // decimal comma must never depend on the machine.
    double
    number_or_nan(const std::string &text)
    {
      std::istringstream stream(text);
      stream.imbue(std::locale::classic());
      double value = 0;
      if (!(stream >> value) || !std::isfinite(value))
        return std::numeric_limits<double>::quiet_NaN();
      stream >> std::ws;
      return stream.eof() ? value : std::numeric_limits<double>::quiet_NaN();
    }
  } // namespace



  std::vector<std::string>
  split_list(const std::string &text, const char separator)
  {
    std::vector<std::string> parts;
    std::istringstream       stream(text);
    std::string              part;
    while (std::getline(stream, part, separator))
    {
      part = dealii::Utilities::trim(part);
      if (!part.empty())
        parts.push_back(part);
    }
    return parts;
  }



  std::vector<std::vector<std::string>>
  read_items(const std::string &list,
             const std::string &form,
             const std::string &parameter)
  {
    std::vector<std::vector<std::string>> items;
    for (const std::string &item : split_list(list, ';'))
    {
      items.push_back(split_list(item, ':'));
      if (items.back().size() != split_list(form, ':').size())
        throw InputError(parameter + ": found " + in_quotes(item) +
                         ", allowed is '" + form +
                         "', several separated by ';'.");
    }
    return items;
  }



  std::string
  single_spaced(const std::string &text)
  {
    std::istringstream stream(text);
    std::string        result, word;
    while (stream >> word)
      result += (result.empty() ? "" : " ") + word;
    return result;
  }



  std::string
  in_quotes(const std::string &text)
  {
    const std::size_t longest = 70;
    if (text.size() <= longest)
      return "'" + text + "'";
    return "'" + text.substr(0, longest) + "...'";
  }



  double
  parse_number(const std::string &text, const std::string &parameter)
  {
    const double value = number_or_nan(text);
    if (std::isnan(value))
      throw InputError(parameter + ": found " + in_quotes(text) +
                       ", expected a number, as in 0.5 or 1e-3.");
    return value;
  }



  std::optional<double>
  number_in(const std::string &text)
  {
    try
    {
      return parse_number(text, "");
    }
    catch (const InputError &)
    {
      return {};
    }
  }



  std::vector<double>
  parse_numbers(const std::string &text, const std::string &parameter)
  {
    std::vector<double> numbers;
    if (dealii::Utilities::trim(text).empty())
      return numbers;

    // not split_list(): a missing number between commas is a mistake
    std::istringstream stream(text + ",");
    std::string        part;
    while (std::getline(stream, part, ','))
    {
      const double value = number_or_nan(part);
      if (std::isnan(value))
        throw InputError(parameter + ": found " + in_quotes(text) +
                         ", expected numbers separated by commas; " +
                         in_quotes(dealii::Utilities::trim(part)) +
                         " is not a number.");
      numbers.push_back(value);
    }
    return numbers;
  }
} // namespace MixedCracks
