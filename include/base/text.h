// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_text_h
#define mixed_cracks_base_text_h

#include <cctype>
#include <optional>
#include <string>
#include <vector>

namespace MixedCracks
{
  // The functions of <cctype>, which are undefined for characters beyond ASCII
  // where char has a sign.

  inline bool
  is_blank(const char c)
  {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
  }

  inline bool
  is_digit(const char c)
  {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
  }

  inline bool
  starts_with(const std::string &text, const std::string &beginning)
  {
    return text.compare(0, beginning.size(), beginning) == 0;
  }

  /// The parts of @p text between separators, without blanks around them and
  /// without empty parts.
  std::vector<std::string> split_list(const std::string &text, char separator);

  /// The items of a list 'ITEM ; ITEM ; ...', each as its parts between colons,
  /// of which @p form has as many, as in "name : point". Throws InputError that
  /// names @p parameter, the item and the form.
  std::vector<std::vector<std::string>>
  read_items(const std::string &list,
             const std::string &form,
             const std::string &parameter);

  /// @p text without blanks around it and with single blanks inside, the form
  /// in which names are compared.
  std::string single_spaced(const std::string &text);

  /// @p text in quotes for an error message, shortened when it is long.
  std::string in_quotes(const std::string &text);

  /// One finite number and nothing else. Throws InputError that names
  /// @p parameter and the text found.
  double parse_number(const std::string &text, const std::string &parameter);

  /// The same, or nothing where parse_number() throws.
  std::optional<double> number_in(const std::string &text);

  /// Numbers separated by commas; an empty text has none. Throws InputError
  /// that names @p parameter and the text found.
  std::vector<double> parse_numbers(const std::string &text,
                                    const std::string &parameter);
} // namespace MixedCracks

#endif
