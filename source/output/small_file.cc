// SPDX-License-Identifier: GPL-2.0-or-later
// What takes the place of a file is down to the disk before it does (disk.cc).
// What is added is not: the rows of a step that is lost with the machine are
// computed again, and a resumed run writes the table anew.

#include <output/disk.h>
#include <output/small_file.h>

#include <fstream>

namespace MixedCracks
{
  void
  replace_small_file(const std::string &name, const std::string &text)
  {
    if (!write_durably(name, text).empty())
      throw cannot_be_written(name);
  }



  void
  append_to_file(const std::string &name, const std::string &text)
  {
    std::ofstream file(name, std::ios::app);
    if (!(file << text << std::flush))
      throw cannot_be_written(name);
  }



  FileError
  cannot_be_written(const std::string &name)
  {
    return FileError("Output/Directory: '" + name +
                     "' cannot be written; is the disk full?");
  }
} // namespace MixedCracks
