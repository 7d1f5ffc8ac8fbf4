// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_run_lock_holder_h
#define mixed_cracks_output_run_lock_holder_h

#include <string>

namespace MixedCracks
{
  /// What a lock file says about the process that has written it.
  struct LockHolder
  {
    std::string host;                  ///< empty: nothing is known
    std::string process;               ///< its number there
    std::string since;                 ///< date and time, UTC
    bool        has_heartbeat = false; ///< the file counts, not a lock on it
  };

  /// The text a process writes into its lock file.
  std::string describe_this_process(bool has_heartbeat);

  LockHolder read_holder(const std::string &path);

  /// "process 12 on host a since ...", or as much as is known.
  std::string in_words_of(const LockHolder &holder);

  /// Age of a file by the clock of its file system, s; 0 when that cannot be
  /// found out.
  double seconds_since_touched(const std::string &path);

  /// Put a file with @p text there at once, in place of what is there.
  bool replace_file(const std::string &path, const std::string &text);
} // namespace MixedCracks

#endif
