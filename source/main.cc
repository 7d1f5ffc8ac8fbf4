// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/collective.h>
#include <base/memory.h>
#include <base/single_process.h>
#include <base/standard_streams.h>
#include <base/stop_request.h>
#include <base/version.h>

#include <input/case_signature.h>
#include <input/command_line.h>
#include <input/dimension.h>
#include <input/example_case.h>
#include <input/parameter_file.h>
#include <input/parameter_manual.h>

#include <output/directory.h>
#include <output/disk.h>
#include <output/run_lock.h>

#include <simulation/case_identity.h>
#include <simulation/simulation.h>

#include <Trilinos_version.h>

#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

namespace
{
  using namespace MixedCracks;

  // Also of a process that has not started MPI, and is the only one.
  bool
  on_first_rank()
  {
    int has_mpi = 0;
    MPI_Initialized(&has_mpi);
    return has_mpi == 0 ||
           dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }



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



  // Where the answer is all that is wanted, it has to arrive. A run goes on
  // without a screen: it has its log.txt.
  void
  require_written_output()
  {
    throw_on_all_ranks(on_first_rank() ? failure_of_output() : "",
                       MPI_COMM_WORLD);
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
  print_case_id(const std::string &id)
  {
    if (on_first_rank())
      std::cout << id << '\n';
    require_written_output();
    return 0;
  }



  // Keeps other processes out of the output directory. Rank 0 has it.
  std::unique_ptr<const RunLock>
  lock_output(const std::string &directory)
  {
    std::unique_ptr<const RunLock> lock;
    std::string                    message;
    if (on_first_rank())
      try
      {
        lock = std::make_unique<const RunLock>(directory);
      }
      catch (const FileError &error)
      {
        message = error.what();
      }
    throw_on_all_ranks(message, MPI_COMM_WORLD);
    if (lock && !lock->warning().empty())
      std::cerr << "mixed-cracks: warning: " << lock->warning() << '.'
                << std::endl;
    return lock;
  }



  // Errors of the user are kept until the simulation is gone: its timers and
  // its files must not be cleared away while an exception is on its way, and
  // a run that was refused before its first result leaves no files.
  template <int dim>
  RunOutcome
  simulate(const Parameters<dim>                              &parameters,
           const std::string                                  &effective,
           const CaseSignature                                &signature,
           const std::function<RunOutcome(Simulation<dim> &)> &action)
  {
    const OutputTrace  trace(parameters.output.directory, MPI_COMM_WORLD);
    std::exception_ptr refusal, failure;
    RunOutcome         outcome;
    {
      Log             log(on_first_rank());
      Simulation<dim> simulation(
        parameters, effective, signature, MPI_COMM_WORLD, log);
      try
      {
        outcome = action(simulation);
      }
      catch (const InputError &)
      {
        refusal = std::current_exception();
      }
      catch (const FileError &)
      {
        refusal = std::current_exception();
      }
      catch (const StoppedEarly &)
      {
        refusal = std::current_exception();
      }
      catch (const SolverError &)
      {
        failure = std::current_exception();
      }
    }
    if (failure)
      std::rethrow_exception(failure);
    if (refusal)
    {
      trace.remove_refused_run();
      std::rethrow_exception(refusal);
    }
    return outcome;
  }



  template <int dim>
  int
  run_case(const CommandLine &command, const std::vector<SourceLine> &source)
  {
    Parameters<dim>          parameters;
    dealii::ParameterHandler prm;
    read_case(source, command, parameters, prm);
    if (command.case_id)
      return print_case_id(case_identity(parameters, prm, *command.case_id));
    std::ostringstream effective;
    print_parameters(effective, prm, "prm");

    const auto action = [&command](Simulation<dim> &simulation) {
      if (command.check)
      {
        simulation.preflight(true);
        require_written_output();
        return RunOutcome();
      }
      return simulation.run(command.overwrite ? ExistingRun::overwrite
                            : command.resume  ? ExistingRun::resume
                                              : ExistingRun::refuse);
    };
    std::unique_ptr<const RunLock> lock;
    if (!command.check)
    {
      survive_closed_pipes();
      listen_for_stop_requests();
      lock = lock_output(parameters.output.directory);
    }
    return simulate<dim>(
             parameters, effective.str(), case_signature(prm), action)
      .exit_status;
  }



  int
  run(const int argc, char **argv)
  {
    const CommandLine command = parse_command_line(argc, argv);
    if (command.is_question())
      return answer_question(command);
    const std::vector<SourceLine> source =
      read_source(command.file, MPI_COMM_WORLD);
    return chosen_dimension(source, command.set) == 3
             ? run_case<3>(command, source)
             : run_case<2>(command, source);
  }



  // One message on one rank. Errors of the user are thrown on all ranks
  // alike, and every rank leaves in order.
  int
  report(const char *what, const int status)
  {
    // at once, so that mpirun puts nothing in between
    if (on_first_rank())
      std::cerr << "mixed-cracks: error: " + std::string(what) + "\n"
                << std::flush;
    return status;
  }



  // The exit status of @p action, or of what it throws.
  int
  exit_status(const std::function<int()> &action)
  {
    try
    {
      return action();
    }
    catch (const InputError &error)
    {
      return report(error.what(), 2);
    }
    catch (const SolverError &error)
    {
      return report(error.what(), 3);
    }
    catch (const FileError &error)
    {
      return report(error.what(), 4);
    }
    catch (const StoppedEarly &stop)
    {
      if (on_first_rank())
        std::cerr << "mixed-cracks: " + std::string(stop.what()) + "\n"
                  << std::flush;
      return stop.exit_status;
    }
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
