// SPDX-License-Identifier: GPL-2.0-or-later
// What takes the place of a file is down to the disk before it does (disk.cc).
// What is added is not: the rows of a step that is lost with the machine are
// computed again, and a resumed run writes the table anew.

#include <output/disk.h>
#include <output/small_file.h>

#include <fstream>

namespace MixedCracks
{
  std::string
  replace_small_file(const std::string &name, const std::string &text)
  {
    return write_durably(name, text).empty() ? "" : cannot_be_written(name);
  }



  std::string
  append_to_file(const std::string &name, const std::string &text)
  {
    std::ofstream file(name, std::ios::app);
    file << text << std::flush;
    return file ? "" : cannot_be_written(name);
  }



  std::string
  cannot_be_written(const std::string &name)
  {
    return "Output/Directory: '" + name +
           "' cannot be written; is the disk full?";
  }
} // namespace MixedCracks
