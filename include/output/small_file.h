// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_small_file_h
#define mixed_cracks_output_small_file_h

#include <string>

namespace MixedCracks
{
  // Tables and lists that one rank writes while a run goes on. The functions
  // return what went wrong, for a person; empty when all is well.

  /// The old file stays until the new one is whole.
  std::string replace_small_file(const std::string &name,
                                 const std::string &text);

  /// Behind what is there.
  std::string append_to_file(const std::string &name, const std::string &text);

  /// What they return of a file that cannot be written.
  std::string cannot_be_written(const std::string &name);
} // namespace MixedCracks

#endif
