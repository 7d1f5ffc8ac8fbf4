// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/case_signature.h>
#include <core/command_line.h>
#include <core/parameter_file.h>
#include <core/parameter_manual.h>
#include <core/simulation.h>
#include <core/stop_request.h>
#include <core/version.h>

#include <output/directory.h>

#include <Trilinos_version.h>

#include <exception>
#include <functional>
#include <iostream>
#include <sstream>

namespace
{
  using namespace MixedCracks;

  constexpr int dimension = 2;

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



  // --help, --version and --parameters: say it and be done
  bool
  answer_question(const CommandLine              &command,
                  const dealii::ParameterHandler &prm)
  {
    std::ostringstream out;
    if (command.help)
      out << usage();
    else if (command.version)
      out << version_text();
    else if (command.parameters)
      print_parameters(out, prm, *command.parameters);
    else
      return false;
    if (on_first_rank())
      std::cout << out.str() << std::flush;
    return true;
  }



  // Errors of the user are kept until the simulation is gone: its timers and
  // its files must not be cleared away while an exception is on its way, and
  // a run that was refused before its first result leaves no files.
  RunOutcome
  simulate(const Parameters<dimension>                              &parameters,
           const std::string                                        &effective,
           const std::string                                        &signature,
           const std::function<RunOutcome(Simulation<dimension> &)> &action)
  {
    const OutputTrace  trace(parameters.output.directory, MPI_COMM_WORLD);
    std::exception_ptr refusal, failure;
    RunOutcome         outcome;
    {
      Log                   log(on_first_rank());
      Simulation<dimension> simulation(
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



  int
  run(const int argc, char **argv)
  {
    const CommandLine        command = parse_command_line(argc, argv);
    Parameters<dimension>    parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    if (answer_question(command, prm))
      return 0;

    read_parameters(command.file, command.set, prm, MPI_COMM_WORLD);
    if (command.output)
    {
      prm.enter_subsection("Output");
      prm.set("Directory", *command.output);
      prm.leave_subsection();
    }
    parameters.check();
    std::ostringstream effective;
    print_parameters(effective, prm, "prm");

    const auto action = [&command](Simulation<dimension> &simulation) {
      if (command.check)
      {
        simulation.preflight();
        return RunOutcome();
      }
      return simulation.run(command.overwrite ? ExistingRun::overwrite
                            : command.resume  ? ExistingRun::resume
                                              : ExistingRun::refuse);
    };
    listen_for_stop_requests();
    return simulate(parameters, effective.str(), case_signature(prm), action)
      .exit_status;
  }



  // One message on one rank. Errors of the user are thrown on all ranks
  // alike, and every rank leaves in order.
  int
  report(const char *what, const int status)
  {
    if (on_first_rank())
      std::cerr << "mixed-cracks: error: " << what << std::endl;
    return status;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
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
  catch (const std::exception &error)
  {
    // not foreseen, and perhaps on this rank only: the others must not wait
    std::cerr << "mixed-cracks: internal error: " << error.what() << std::endl;
    MPI_Abort(MPI_COMM_WORLD, 1);
    return 1;
  }
}
