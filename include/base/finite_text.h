// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_finite_text_h
#define mixed_cracks_base_finite_text_h

#include <locale>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A number for a CSV file with that many significant digits; empty where
  /// it is not finite.
  std::string csv_number(double value, int digits = 10);

  /// A name as one field of a CSV file: in quotation marks, doubled inside,
  /// where it holds a comma, a quotation mark or the end of a line (RFC 4180).
  std::string csv_field(const std::string &text);

  /// The fields of one line of a CSV file, quotation marks taken off.
  std::vector<std::string> csv_fields(const std::string &line);

  /// For streams that write CSV files: numbers in the usual form, and nothing
  /// in place of one that is not finite.
  std::locale csv_locale();

  /// The value, or where it has overflown the largest number there is: for
  /// sentences, in which "inf" and "nan" say nothing. NaN is 0.
  double printable(double value);
} // namespace MixedCracks

#endif
