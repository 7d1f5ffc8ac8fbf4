// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_pattern_words_h
#define mixed_cracks_input_pattern_words_h

#include <string>
#include <vector>

namespace MixedCracks
{
  /// What a deal.II pattern allows, in words: "a number between 0 and 1",
  /// "one of: a, b". @p description is the pattern's machine description, as
  /// in "[Double 0...1 (inclusive)]"; an unknown kind comes back as it is.
  std::string pattern_in_words(const std::string &description);

  /// The names a selection offers; none for every other pattern.
  std::vector<std::string> pattern_choices(const std::string &description);
} // namespace MixedCracks

#endif
