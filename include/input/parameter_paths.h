// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_parameter_paths_h
#define mixed_cracks_input_parameter_paths_h

#include <input/parameter_parser.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// Whether an entry names a file to be read: by its pattern,
  /// FileName(input).
  bool names_input_file(const ParameterEntry &entry);

  /// Where a file is that a .prm in @p folder calls @p name: there, or in the
  /// working directory when it is there only. An empty folder: the working
  /// directory, as for --set. An absolute path.
  std::string absolute_path(const std::string &name, const std::string &folder);

  /// The same assignments, relative paths of input files made absolute. Rank 0
  /// looks where the files are. Throws InputError for a folder whose name a
  /// .prm cannot hold. Collective.
  std::vector<ParameterAssignment>
  with_absolute_paths(std::vector<ParameterAssignment> assignments,
                      MPI_Comm                         comm);
} // namespace MixedCracks

#endif
