// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_parameter_file_h
#define mixed_cracks_input_parameter_file_h

#include <deal.II/base/parameter_handler.h>

#include <input/parameter_source.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// Read a .prm file and then the overrides, each "Subsection/.../Entry=value"
  /// as `--set` takes them, into the entries declared in @p prm. Collective;
  /// rank 0 reads the file and every rank gets, or throws, the same.
  ///
  /// The file language is deal.II's: subsection, end, set, include, comments
  /// with #, a trailing backslash. Stricter: every subsection is closed in
  /// its own file, and nothing is set twice in one file.
  ///
  /// A relative path in an entry that names a file to be read (one whose
  /// pattern is FileName(input)) becomes an absolute one: from the folder of
  /// the .prm that sets it, or from the working directory when the file is
  /// there only; in an override from the working directory.
  ///
  /// Throws FileError when a file cannot be read, and InputError with up to
  /// ten mistakes, one per line, each with file and line or "--set". No entry
  /// is touched unless all values match their patterns.
  void read_parameters(const std::string              &file_name,
                       const std::vector<std::string> &overrides,
                       dealii::ParameterHandler       &prm,
                       MPI_Comm                        comm);

  /// The same from the statements that read_source() returned. Collective.
  void read_parameters(const std::vector<SourceLine>  &source,
                       const std::vector<std::string> &overrides,
                       dealii::ParameterHandler       &prm,
                       MPI_Comm                        comm = MPI_COMM_WORLD);
} // namespace MixedCracks

#endif
