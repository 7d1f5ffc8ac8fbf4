// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_names_h
#define mixed_cracks_base_names_h

#include <string>
#include <vector>

namespace MixedCracks
{
  /// The candidate with the smallest edit distance to @p word (case and
  /// surrounding blanks ignored), or an empty string when none is close
  /// enough to be what somebody meant.
  std::string nearest_name(const std::string              &word,
                           const std::vector<std::string> &candidates);

  /// "a, b, c": the names as they stand in an error message.
  std::string join_names(const std::vector<std::string> &names,
                         const std::string              &separator = ", ");

  /// "unknown 'x'; did you mean 'y'? Allowed: a, b, c", the tail of an error
  /// message about @p word.
  std::string unknown_name_message(const std::string              &word,
                                   const std::vector<std::string> &allowed);
} // namespace MixedCracks

#endif
