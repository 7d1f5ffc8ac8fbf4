// SPDX-License-Identifier: GPL-2.0-or-later
// What may happen to a directory, by what is there and what was asked for:
//
//                nothing   a run                      foreign file in the way
//   (neither)    begin     refuse                     refuse
//   --overwrite  begin     remove its files, begin    refuse
//   --resume     Checkpoint::read() finds a whole checkpoint, or refuses
//
// Foreign is what would be overwritten and is in no list of a run
// (run_files.cc). The first look, inspect(), changes nothing but for a file
// made to test writing and removed again; prepare() comes when no input can be
// refused any more. There the order is: see that files can be written, that the
// first ones find room, and only then remove the old run. If anything before
// fails, that run is as it was.

#include <base/errors.h>
#include <base/ranges.h>

#include <deal.II/base/mpi.h>

#include <output/directory.h>
#include <output/run_files.h>
#include <output/small_file.h>

#include <filesystem>
#include <fstream>

namespace MixedCracks
{
  namespace
  {
    namespace fs = std::filesystem;

    bool
    holds_a_run(const std::string &directory)
    {
      std::error_code error;
      for (const char *name : {"statistics.csv",
                               "log.txt",
                               "parameters.prm",
                               "checkpoint/generation-0/seal.txt",
                               "checkpoint/generation-1/seal.txt"})
        if (fs::exists(fs::path(directory) / name, error))
          return true;
      return has_run_files(directory);
    }

    // more than a header
    bool
    has_results(const std::string &directory)
    {
      std::ifstream file(fs::path(directory) / "statistics.csv");
      std::string   line;
      return std::getline(file, line) && std::getline(file, line);
    }

    // What is there, would be overwritten, and is not in the way by order of
    // the user: the files of a run that are not @p known as those of a run.
    std::string
    foreign_file(const std::string              &directory,
                 std::vector<std::string>        names,
                 const std::vector<std::string> &known)
    {
      if (!has_run_files(directory))
        names.push_back(run_files_name);
      for (const std::string &name : numbered_files(directory))
        if (contains(names, name.substr(0, name.find('/') + 1)))
          names.push_back(name);
      for (const std::string &name : checkpoint_files())
        names.push_back(name);
      std::error_code error;
      for (const std::string &name : names)
      {
        const auto kind      = fs::status(fs::path(directory) / name, error);
        const bool is_folder = name.back() == '/';
        const bool is_known  = is_folder || contains(known, name);
        // a folder in the place of a file would stay there, and the reverse
        if (fs::exists(kind) &&
            (!is_known || fs::is_directory(kind) != is_folder))
          return is_folder ? name.substr(0, name.size() - 1) : name;
      }
      return "";
    }

    void
    require_writable(const fs::path &directory)
    {
      const fs::path probe      = directory / ".mixed-cracks-write-test";
      bool           is_written = false;
      {
        std::ofstream file(probe);
        file << "test\n" << std::flush;
        is_written = static_cast<bool>(file);
      }
      std::error_code error; // it may be there, and empty
      fs::remove(probe, error);
      if (!is_written)
        throw FileError("Output/Directory: files cannot be written in '" +
                        directory.string() + "'.");
    }

    void
    require_room(const std::string              &directory,
                 const std::vector<std::string> &names,
                 std::vector<SizedFile>          files)
    {
      std::uint64_t size_of_list = 1024; // its head
      for (const std::string &name : names)
        size_of_list += name.size() + 1;
      files.push_back({run_files_name, size_of_list});
      for (SizedFile &file : files)
        file.path = (fs::path(directory) / file.path).string();
      const std::string problem = missing_space_for(files);
      if (!problem.empty())
        throw FileError(
          "Output/Directory: the run cannot be begun: " + problem + ".");
    }

    // whether there is nothing that would have to go first
    bool
    inspect(const std::string              &directory,
            const ExistingRun               existing,
            const std::vector<std::string> &names)
    {
      if (fs::exists(directory) && !fs::is_directory(directory))
        throw FileError("Output/Directory: '" + directory +
                        "' is a file, allowed is a directory.");
      const bool found = holds_a_run(directory);
      if (found && existing == ExistingRun::refuse)
        throw FileError(
          "Output/Directory: '" + directory +
          "' already holds a run. Allowed: another directory (--output DIR), "
          "--overwrite to replace it, --resume to continue it.");
      if (existing == ExistingRun::resume)
        return false;
      const std::string foreign =
        foreign_file(directory, names, files_of_runs(directory));
      if (!foreign.empty())
        throw FileError("Output/Directory: '" + directory + "' holds '" +
                        foreign +
                        "', which would be overwritten and is not recorded "
                        "there as the file of a run. Allowed: another "
                        "directory (--output DIR), or to move this file away.");
      if (found)
        require_writable(directory);
      return !found;
    }

    // what lies in it is to be found again, whatever happens
    void
    make_folder(const std::string &path)
    {
      const std::string problem = make_folder_durably(path);
      if (!problem.empty())
        throw FileError(
          "Output/Directory: a folder cannot be made: " + problem + ".");
    }

    void
    prepare(const std::string              &directory,
            const ExistingRun               existing,
            const std::vector<std::string> &names,
            const std::vector<SizedFile>   &first_files)
    {
      make_folder(directory);
      require_writable(directory);
      require_room(directory, names, first_files);
      if (existing == ExistingRun::overwrite)
        remove_run_files(directory, files_of_runs(directory));
      if (!begin_run_files(directory, files_of_runs(directory), names))
        throw FileError("Output/Directory: files cannot be written in '" +
                        directory + "'; is the disk full?");
      if (contains(names, "fields/"))
        make_folder((fs::path(directory) / "fields").string());
    }

    // on rank 0, with what goes wrong there thrown on all
    template <typename Body>
    void
    on_first_rank(const std::string &directory,
                  const MPI_Comm     communicator,
                  const Body        &body)
    {
      MixedCracks::on_first_rank(communicator, [&]() {
        try
        {
          body();
        }
        catch (const fs::filesystem_error &error)
        {
          throw FileError("Output/Directory: '" + directory +
                          "' cannot be made: " + error.code().message() + ".");
        }
      });
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
    // a list that was not there before is that of this run
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0 &&
        !held_a_run && !has_results(directory))
    {
      std::error_code error;
      try
      {
        if (has_run_files(directory))
          remove_run_files(directory, files_of_runs(directory));
      }
      catch (const fs::filesystem_error &)
      {
        // the refusal is what the user is to read
      }
      for (const std::string &folder : new_folders)
        fs::remove(folder, error); // unless something else is in it
    }
    MPI_Barrier(communicator);
  }


  bool
  inspect_output_directory(const std::string              &directory,
                           const ExistingRun               existing,
                           const std::vector<std::string> &names,
                           const MPI_Comm                  communicator)
  {
    int is_free = 0;
    on_first_rank(directory, communicator, [&]() {
      is_free = inspect(directory, existing, names) ? 1 : 0;
    });
    return dealii::Utilities::MPI::broadcast(communicator, is_free, 0) != 0;
  }



  void
  prepare_output_directory(const std::string              &directory,
                           const ExistingRun               existing,
                           const std::vector<std::string> &names,
                           const std::vector<SizedFile>   &first_files,
                           const MPI_Comm                  communicator)
  {
    on_first_rank(directory, communicator, [&]() {
      prepare(directory, existing, names, first_files);
    });
  }
} // namespace MixedCracks
