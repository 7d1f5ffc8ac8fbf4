// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_reader_h
#define mixed_cracks_problem_geometries_mesh_reader_h

#include <deal.II/base/mpi.h>

#include <string>

namespace MixedCracks
{
  /// The contents of a file, read by the first rank of @p communicator; the
  /// same on every rank, and so is the FileError, whose text begins with
  /// @p parameter.
  std::string read_file_once(const std::string &path,
                             MPI_Comm           communicator,
                             const std::string &parameter);
} // namespace MixedCracks

#endif
