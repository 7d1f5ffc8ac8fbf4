// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_run_files_h
#define mixed_cracks_output_run_files_h

#include <string>
#include <vector>

namespace MixedCracks
{
  // What a run has written into its output directory, by its own account:
  // DIR/run_files.txt has a name per line, relative to DIR, files before they
  // are written and folders (with '/' behind) before they are made. Whatever
  // else lies there belongs to somebody else. For the rank that writes.

  /// "run_files.txt".
  extern const char *const run_files_name;

  /// Whether the directory has a list.
  bool has_run_files(const std::string &directory);

  /// What a run writes below "checkpoint", relative to the output directory;
  /// of each generation the seal first.
  std::vector<std::string> checkpoint_files();

  /// The same in one generation, relative to its folder.
  const std::vector<std::string> &files_of_generation();

  /// Begin the list with what is @p recorded otherwise, or continue the one
  /// that is there, with those @p names that do not exist yet: what exists is
  /// not the run's. False when it cannot be written.
  bool begin_run_files(const std::string              &directory,
                       const std::vector<std::string> &recorded,
                       const std::vector<std::string> &names);

  /// Add the names that are not in the list yet; without a list nothing is
  /// kept. False when it cannot be written.
  bool note_run_files(const std::string              &directory,
                      const std::vector<std::string> &names);

  /// What runs in this directory have recorded: the names in the list and
  /// those of checkpoints, whose folder is in the list or which have a seal. A
  /// run of version 0.1 kept no list; it
  /// is known by statistics.csv, log.txt and parameters.prm together, and its
  /// files by their names. Empty where there is no run.
  std::vector<std::string> files_of_runs(const std::string &directory);

  /// Files in "fields", "crack_path", "crack_sheet" and "crack_front" that have
  /// the names of those that a run writes there, whosoever wrote them.
  std::vector<std::string> numbered_files(const std::string &directory);

  /// Remove these files, and these folders where nothing is left in them; what
  /// does not exist is no error. The list itself goes last. Throws
  /// std::filesystem::filesystem_error.
  void remove_run_files(const std::string              &directory,
                        const std::vector<std::string> &names);
} // namespace MixedCracks

#endif
