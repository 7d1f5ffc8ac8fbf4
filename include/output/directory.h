// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_directory_h
#define mixed_cracks_output_directory_h

#include <mpi.h>

#include <string>

namespace MixedCracks
{
  enum class ExistingRun
  {
    refuse,
    overwrite,
    resume
  };

  /// Make @p directory ready for a run: create it and its subdirectories, see
  /// that files can be written, and treat a run that is there already as
  /// @p existing says. Done on rank 0; throws FileError on every rank alike.
  void
  prepare_output_directory(const std::string &directory,
                           ExistingRun        existing,
                           MPI_Comm           communicator);

  /// Throw a FileError with @p message on every rank when it is not empty on
  /// rank 0. Collective.
  void
  throw_on_all_ranks(const std::string &message, MPI_Comm communicator);
} // namespace MixedCracks

#endif
