// SPDX-License-Identifier: GPL-2.0-or-later
// One rank reads, the others get the text: on a cluster a file system is not
// asked by a thousand ranks at once, and all ranks see the same bytes, or the
// same reason why there are none, and throw together.

#include <base/errors.h>

#include <problem/geometries/mesh_reader.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace MixedCracks
{
  namespace
  {
    // Returns why the file cannot be read; empty when it worked.
    std::string
    read_file(const std::string &path, std::string &text)
    {
      std::error_code no_error;
      const auto      kind = std::filesystem::status(path, no_error);
      if (std::filesystem::is_directory(kind))
        return "it is a directory";
      // some never end, and none can be read again when the run is resumed
      if (std::filesystem::exists(kind) &&
          !std::filesystem::is_regular_file(kind))
        return "it is a device or a pipe, allowed is a regular file";
      errno = 0;
      std::ifstream file(path, std::ios::binary);
      if (!file)
        return std::strerror(errno);
      text.assign(std::istreambuf_iterator<char>(file), {});
      return file.bad() ? "reading it failed" : "";
    }
  } // namespace



  std::string
  read_file_once(const std::string &path,
                 const MPI_Comm     communicator,
                 const std::string &parameter)
  {
    std::string text, reason;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      reason = read_file(path, text);
    reason = dealii::Utilities::MPI::broadcast(communicator, reason);
    if (!reason.empty())
      throw FileError(parameter + ": cannot read '" + path + "': " + reason +
                      ".");
    return dealii::Utilities::MPI::broadcast(communicator, text);
  }
} // namespace MixedCracks
