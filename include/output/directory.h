// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_directory_h
#define mixed_cracks_output_directory_h

#include <output/disk.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  enum class ExistingRun
  {
    refuse,
    overwrite,
    resume
  };

  /// Look at @p directory and change nothing: whether it is free for a run,
  /// with nothing of another run to be replaced or continued. @p names: what
  /// the run will write, relative to the directory, folders with '/' behind.
  /// Throws FileError when a run is there and @p existing refuses it, and when
  /// a file would be overwritten that no run has recorded. Collective.
  bool inspect_output_directory(const std::string              &directory,
                                ExistingRun                     existing,
                                const std::vector<std::string> &names,
                                MPI_Comm                        communicator);

  /// Make @p directory ready for a run: create it, and in it "fields" where
  /// that is among the @p names, see that files can be written, and begin
  /// run_files.txt. Where a run is to be overwritten, what it has recorded is
  /// removed, and nothing else, and not before there is room for the list and
  /// the @p first_files of the new one, whose paths are relative to the
  /// directory. Throws FileError. Collective.
  void prepare_output_directory(const std::string              &directory,
                                ExistingRun                     existing,
                                const std::vector<std::string> &names,
                                const std::vector<SizedFile>   &first_files,
                                MPI_Comm                        communicator);

  /// What is at a directory before a run, so that a run that is refused later,
  /// for a mesh that cannot be read or a load that is infinite at the start,
  /// leaves nothing behind.
  class OutputTrace
  {
  public:
    /// Collective; rank 0 looks.
    OutputTrace(const std::string &directory, MPI_Comm communicator);

    /// Remove the files and folders that the run has made, as its list has
    /// them, unless there was another run already or a load step has been
    /// computed. Its files must be closed. Never throws. Collective.
    void remove_refused_run() const;

  private:
    const std::string        directory;
    const MPI_Comm           communicator;
    bool                     held_a_run = false;
    std::vector<std::string> new_folders; ///< innermost first
  };
} // namespace MixedCracks

#endif
