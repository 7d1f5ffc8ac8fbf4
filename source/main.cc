// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/collective.h>
#include <base/single_process.h>
#include <base/standard_streams.h>
#include <base/stop_request.h>
#include <base/version.h>

#include <input/case_signature.h>
#include <input/command_line.h>
#include <input/dimension.h>
#include <input/parameter_file.h>
#include <input/parameter_manual.h>

#include <output/directory.h>
#include <output/disk.h>
#include <output/run_lock.h>

#include <simulation/case_identity.h>
#include <simulation/simulation.h>
#include <simulation/time_tables.h>

#include <Trilinos_version.h>

#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <sstream>

namespace
{
  using namespace MixedCracks;

  bool
  on_first_rank()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
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



  // --help, --version and --parameters: say it and be done
  bool
  answer_question(const CommandLine &command)
  {
    std::ostringstream out;
    if (command.help)
      out << usage();
    else if (command.version)
      out << version_text();
    else if (command.parameters)
    {
      // those of 3-d are the same
      Parameters<2>            parameters;
      dealii::ParameterHandler prm;
      parameters.add_parameters(prm);
      print_parameters(out, prm, *command.parameters);
    }
    else
      return false;
    if (on_first_rank())
      std::cout << out.str();
    require_written_output();
    return true;
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
    parameters.add_parameters(prm);
    read_parameters(source, command.set, prm);
    if (command.output)
    {
      prm.enter_subsection("Output");
      prm.set("Directory", *command.output);
      prm.leave_subsection();
    }
    read_time_tables(prm);
    parameters.check();
    require_time_tables_until(parameters.load.end_time, prm);
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
    if (answer_question(command))
      return 0;
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
} // namespace



int
main(int argc, char **argv)
{
  occupy_standard_streams();
  prepare_single_process();
  survive_file_size_limit();
  const bool                               under_nohup = ignores_hangup();
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (under_nohup)
    ignore_hangup(); // PETSc has set it back
  try
  {
    return run(argc, argv);
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
  catch (const std::exception &error)
  {
    // not foreseen, and perhaps on this rank only: the others must not wait
    std::cerr << "mixed-cracks: internal error: " << error.what() << std::endl;
    MPI_Abort(MPI_COMM_WORLD, 1);
    return 1;
  }
}
