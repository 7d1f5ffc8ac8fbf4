// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_disk_h
#define mixed_cracks_output_disk_h

#include <cstdint>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A file with the size it is to have, in bytes.
  struct SizedFile
  {
    std::string   path;
    std::uint64_t size;
  };

  /// Let a write beyond the largest size that a file may have (ulimit -f) be
  /// an error of that write, and not the end of the program.
  void survive_file_size_limit();

  /// See that new files of these sizes fit on the disk, all of them together:
  /// their space is taken under names of their own and set free again. For
  /// libraries that abort or go on when a write fails. Returns what is wrong,
  /// for a person; empty when there is room.
  std::string missing_space_for(const std::vector<SizedFile> &files);

  /// Write a file that is there whole or not at all, whatever happens: under
  /// another name, down to the disk, and renamed. Returns what went wrong.
  std::string write_durably(const std::string &path, const std::string &text);

  /// Make a folder, with those above it, that is there whatever happens: all
  /// names, its own included, are down to the disk, also that of a folder that
  /// was there. Returns what went wrong.
  std::string make_folder_durably(const std::string &path);

  /// Wait until what was written to a file is on the disk, and drop it from
  /// memory, so that it is read from the disk next. Returns what went wrong.
  std::string sync_to_disk(const std::string &path);

  /// The same for the names in a directory.
  std::string sync_directory(const std::string &path);

  /// In bytes; -1 when there is no such file.
  std::int64_t size_of_file(const std::string &path);

  /// Whether the file ends with @p ending: what was cut off does not.
  bool ends_with(const std::string &path, const std::string &ending);

  /// The whole file; empty when it cannot be read.
  std::string contents_of_file(const std::string &path);
} // namespace MixedCracks

#endif
