// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/collective.h>
#include <base/memory.h>
#include <base/single_process.h>
#include <base/standard_streams.h>
#include <base/stop_request.h>
#include <base/version.h>

#include <input/command_line.h>
#include <input/example_case.h>
#include <input/parameter_manual.h>

#include <output/disk.h>

#include <simulation/case_run.h>
#include <simulation/parameters.h>

#include <Trilinos_version.h>

#include <exception>
#include <iostream>
#include <optional>
#include <sstream>

namespace
{
  using namespace MixedCracks;

  std::string
  version_text()
  {
    char mpi[MPI_MAX_LIBRARY_VERSION_STRING];
    int  length = 0;
    MPI_Get_library_version(mpi, &length);
    std::ostringstream out;
    out << "mixed-cracks " << MIXED_CRACKS_VERSION << " (revision "
        << MIXED_CRACKS_REVISION << ")\ndeal.II " << DEAL_II_PACKAGE_VERSION
        << "\nTrilinos " << TRILINOS_VERSION_STRING << "\np4est "
        << DEAL_II_P4EST_VERSION_MAJOR << '.' << DEAL_II_P4EST_VERSION_MINOR
        << "\n"
        << std::string(mpi, length) << '\n';
    return out.str();
  }



  // --help, --version and the like
  std::string
  answer(const CommandLine &command)
  {
    if (command.help)
      return usage();
    if (command.version)
      return version_text();
    if (command.cite)
      return citation;
    if (command.example)
      return command.example->empty()
               ? list_of_examples(example_folder())
               : write_example(example_folder(), *command.example, ".");
    // those of 3-d are the same
    Parameters<2>            parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    std::ostringstream out;
    print_parameters(out, prm, *command.parameters);
    return out.str();
  }



  // By one rank, which alone writes what an example consists of.
  int
  answer_question(const CommandLine &command)
  {
    std::string failure;
    together(MPI_COMM_WORLD, [&]() {
      if (on_first_rank())
        try
        {
          std::cout << answer(command);
          failure = failure_of_output();
        }
        catch (const FileError &error)
        {
          failure = error.what();
        }
    });
    throw_on_all_ranks(failure, MPI_COMM_WORLD);
    return 0;
  }



  int
  run(const int argc, char **argv)
  {
    const CommandLine command = parse_command_line(argc, argv);
    return command.is_question() ? answer_question(command) : run_case(command);
  }



  // A single process need not start MPI to answer a question. Without a value:
  // there is a case to be run.
  std::optional<int>
  answer_at_once(const int argc, char **argv)
  {
    std::optional<int> status;
    const int          result = exit_status([&]() {
      const CommandLine command = parse_command_line(argc, argv);
      if (!command.is_question())
        return 0;
      status = 0;
      std::cout << answer(command);
      const std::string failure = failure_of_output();
      if (!failure.empty())
        throw FileError(failure);
      return 0;
    });
    return result == 0 ? status : result;
  }
} // namespace



int
main(int argc, char **argv)
{
  occupy_standard_streams();
  return_large_blocks();
  if (prepare_single_process())
    if (const std::optional<int> status = answer_at_once(argc, argv))
      return *status;
  survive_file_size_limit();
  const bool                               under_nohup = ignores_hangup();
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (under_nohup)
    ignore_hangup(); // PETSc has set it back
  try
  {
    return exit_status([&]() { return run(argc, argv); });
  }
  catch (const std::exception &error)
  {
    // not foreseen, and perhaps on this rank only: the others must not wait
    std::cerr << "mixed-cracks: internal error: " << error.what() << std::endl;
    MPI_Abort(MPI_COMM_WORLD, 1);
    return 1;
  }
}
