// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_small_file_h
#define mixed_cracks_output_small_file_h

#include <base/collective.h>
#include <base/errors.h>

#include <deal.II/base/mpi.h>

#include <memory>
#include <string>

namespace MixedCracks
{
  // Tables and lists that one rank writes while a run goes on. The functions
  // throw FileError.

  /// The old file stays until the new one is whole.
  void replace_small_file(const std::string &name, const std::string &text);

  /// Behind what is there.
  void append_to_file(const std::string &name, const std::string &text);

  /// What they throw about a file that cannot be written.
  FileError cannot_be_written(const std::string &name);

  /// @p body on rank 0; a FileError of its is thrown on all. Collective.
  template <typename Body>
  void
  on_first_rank(const MPI_Comm communicator, const Body &body)
  {
    std::string message;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      try
      {
        body();
      }
      catch (const FileError &error)
      {
        message = error.what();
      }
    throw_on_all_ranks(message, communicator);
  }

  /// The same with what rank 0 writes to, where that is anything.
  template <typename File, typename Body>
  void
  with_file(const std::unique_ptr<File> &file,
            const MPI_Comm               communicator,
            const Body                  &body)
  {
    on_first_rank(communicator, [&]() {
      if (file)
        body(*file);
    });
  }
} // namespace MixedCracks

#endif
