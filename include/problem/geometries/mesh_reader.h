// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_reader_h
#define mixed_cracks_problem_geometries_mesh_reader_h

#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria.h>

#include <string>

namespace MixedCracks
{
  /// The contents of a file, read by the first rank of @p communicator; the
  /// same on every rank, and so is the FileError, whose text begins with
  /// @p parameter.
  std::string read_file_once(const std::string &path,
                             MPI_Comm           communicator,
                             const std::string &parameter);

  /// Read a mesh of quadrilaterals or hexahedra from the @p text of a file into
  /// an empty serial triangulation. Returns why that is impossible, as the end
  /// of a sentence that begins "the file"; empty when it worked.
  template <int dim>
  std::string read_mesh(const std::string          &text,
                        dealii::Triangulation<dim> &triangulation);
} // namespace MixedCracks

#endif
