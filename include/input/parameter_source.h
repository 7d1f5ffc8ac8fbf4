// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_parameter_source_h
#define mixed_cracks_input_parameter_source_h

#include <mpi.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// One statement of a parameter file: a line without its comment, with the
  /// lines that a trailing backslash joins to it. Never empty.
  struct SourceLine
  {
    std::string  file;
    unsigned int number; ///< of its first line, from 1
    std::string  text;

    /// "case.prm:12"
    std::string place() const;
  };

  /// The statements of a parameter file, with those of every file that it
  /// includes ("include FILE", relative to the including file) in place.
  /// Rank 0 reads; every rank returns the same, or throws the same.
  ///
  /// Throws FileError when a file is missing or cannot be read, InputError
  /// when it is empty, no text, or includes itself.
  std::vector<SourceLine> read_source(const std::string &file_name,
                                      MPI_Comm           comm);
} // namespace MixedCracks

#endif
