// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_canonical_text_h
#define mixed_cracks_input_canonical_text_h

#include <string>

namespace MixedCracks
{
  /// The value of an entry in the form in which two that mean the same are the
  /// same text: numbers by value ("0.10" as "0.1"), without blanks but for one
  /// between two words, and without empty items of a list. Names keep their
  /// numbers: "side_01" is not "side_1".
  std::string canonical_text(const std::string &value);
} // namespace MixedCracks

#endif
