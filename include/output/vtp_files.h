// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_vtp_files_h
#define mixed_cracks_output_vtp_files_h

#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  // What the files of cracks for ParaView have in common, in 2-d and 3-d: VTK
  // PolyData in ASCII, one file for each step in a folder, and a list of them.

  /// "FOLDER/FOLDER_NNNNNN.vtp", as "crack_path/crack_path_000012.vtp".
  std::string vtp_name(const std::string &folder, unsigned int step);

  /// @p attributes: type and name.
  std::string vtp_array(const std::string &attributes,
                        const std::string &content);

  /// Whether there is a file of that name that ends as such files do.
  bool is_whole_vtp(const std::string &file_name);

  /// Note file @p name in the register of @p directory, then write it, its
  /// folder too. Throws FileError.
  void write_vtp_file(const std::string &directory,
                      const std::string &name,
                      const std::string &content);

  /// A list of such files, @p steps_and_times, as "FOLDER.pvd" has it.
  std::string list_of_vtp(
    const std::string                                  &folder,
    const std::vector<std::pair<unsigned int, double>> &steps_and_times);
} // namespace MixedCracks

#endif
