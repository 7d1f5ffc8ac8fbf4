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
                                     "fields.xdmf",
                                     "fields",
                                     "parameters.prm",
                                     "summary.json",
                                     "crack_path.csv",
                                     "crack_path.pvd",
                                     "crack_surface.pvd",
                                     "crack_path",
                                     "report.html",
                                     "checkpoint"};

    bool
    holds_a_run(const fs::path &directory)
    {
      std::error_code error;
      return fs::exists(directory / "statistics.csv", error) ||
             fs::exists(directory / "log.txt", error) ||
             fs::exists(directory / "parameters.prm", error);
    }

    // more than a header
    bool
    has_results(const fs::path &directory)
    {
      std::ifstream file(directory / "statistics.csv");
      std::string   line;
      return std::getline(file, line) && std::getline(file, line);
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
    prepare(const fs::path   &directory,
            const ExistingRun existing,
            const bool        with_fields)
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
      if (with_fields)
        fs::create_directories(directory / "fields");
    }
  } // namespace



  OutputTrace::OutputTrace(const std::string &directory,
                           const MPI_Comm     communicator)
    : directory(directory)
    , communicator(communicator)
  {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) > 0)
      return;
    std::error_code error; // what is wrong with it is said when it is made
    held_a_run      = holds_a_run(directory);
    fs::path folder = fs::absolute(directory, error).lexically_normal();
    for (; folder.has_relative_path(); folder = folder.parent_path())
      if (!fs::exists(folder, error) && folder.has_filename())
        new_folders.push_back(folder.string());
  }



  void
  OutputTrace::remove_refused_run() const
  {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0 &&
        !held_a_run && !has_results(directory))
    {
      std::error_code error;
      for (const char *name : run_files)
        fs::remove_all(fs::path(directory) / name, error);
      for (const std::string &folder : new_folders)
        fs::remove(folder, error); // unless something else is in it
    }
    MPI_Barrier(communicator);
  }



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
                           const bool         with_fields,
                           const MPI_Comm     communicator)
  {
    std::string message;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      try
      {
        prepare(directory, existing, with_fields);
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
