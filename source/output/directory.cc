// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/errors.h>

#include <deal.II/base/mpi.h>

#include <output/directory.h>

#include <filesystem>
#include <fstream>

namespace MixedCracks
{
  namespace
  {
    namespace fs = std::filesystem;

    // what a run writes, and hence what --overwrite may remove
    const char *const run_files[] = {"log.txt",
                                     "statistics.csv",
                                     "fields.pvd",
                                     "fields",
                                     "parameters.prm",
                                     "summary.json",
                                     "crack_path.csv",
                                     "report.html",
                                     "checkpoint"};

    bool
    holds_a_run(const fs::path &directory)
    {
      return fs::exists(directory / "statistics.csv") ||
             fs::exists(directory / "log.txt") ||
             fs::exists(directory / "parameters.prm");
    }

    void
    require_writable(const fs::path &directory)
    {
      const fs::path probe = directory / ".mixed-cracks-write-test";
      {
        std::ofstream file(probe);
        file << "test\n" << std::flush;
        if (!file)
          throw FileError("Output/Directory: files cannot be written in '" +
                          directory.string() + "'.");
      }
      fs::remove(probe);
    }

    void
    prepare(const fs::path &directory, const ExistingRun existing)
    {
      if (fs::exists(directory) && !fs::is_directory(directory))
        throw FileError("Output/Directory: '" + directory.string() +
                        "' is a file, allowed is a directory.");
      const bool found = holds_a_run(directory);
      if (found && existing == ExistingRun::refuse)
        throw FileError(
          "Output/Directory: '" + directory.string() +
          "' already holds a run. Allowed: another directory (--output DIR), "
          "--overwrite to replace it, --resume to continue it.");
      fs::create_directories(directory);
      require_writable(directory);
      if (found && existing == ExistingRun::overwrite)
        for (const char *name : run_files)
          fs::remove_all(directory / name);
      fs::create_directories(directory / "fields");
    }
  } // namespace



  void
  throw_on_all_ranks(const std::string &message, const MPI_Comm communicator)
  {
    const std::string everywhere =
      dealii::Utilities::MPI::broadcast(communicator, message, 0);
    if (!everywhere.empty())
      throw FileError(everywhere);
  }



  void
  prepare_output_directory(const std::string &directory,
                           const ExistingRun  existing,
                           const MPI_Comm     communicator)
  {
    std::string message;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          prepare(directory, existing);
        }
      catch (const FileError &error)
        {
          message = error.what();
        }
      catch (const fs::filesystem_error &error)
        {
          message = "Output/Directory: '" + directory +
                    "' cannot be made: " + error.code().message() + ".";
        }
    throw_on_all_ranks(message, communicator);
  }
} // namespace MixedCracks
