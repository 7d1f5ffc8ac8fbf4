// SPDX-License-Identifier: GPL-2.0-or-later
#include <simulation/case_run.h>

#include <base/collective.h>
#include <base/standard_streams.h>
#include <base/stop_request.h>

#include <input/case_signature.h>
#include <input/dimension.h>
#include <input/parameter_manual.h>

#include <output/directory.h>
#include <output/run_lock.h>
#include <output/small_file.h>

#include <simulation/case_identity.h>
#include <simulation/simulation.h>

#include <exception>
#include <iostream>
#include <memory>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
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
      on_first_rank(MPI_COMM_WORLD, [&]() {
        lock = std::make_unique<const RunLock>(directory);
      });
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
    run_in(const CommandLine &command, const std::vector<SourceLine> &source)
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
        // whoever sees a sign of life may ask: all ranks listen by then
        MPI_Barrier(MPI_COMM_WORLD);
        lock = lock_output(parameters.output.directory);
      }
      return simulate<dim>(
               parameters, effective.str(), case_signature(prm), action)
        .exit_status;
    }



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



  bool
  on_first_rank()
  {
    int has_mpi = 0;
    MPI_Initialized(&has_mpi);
    return has_mpi == 0 ||
           dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }



  void
  require_written_output()
  {
    throw_on_all_ranks(on_first_rank() ? failure_of_output() : "",
                       MPI_COMM_WORLD);
  }



  int
  run_case(const CommandLine &command)
  {
    const std::vector<SourceLine> source =
      read_source(command.file, MPI_COMM_WORLD);
    return chosen_dimension(source, command.set) == 3
             ? run_in<3>(command, source)
             : run_in<2>(command, source);
  }



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
} // namespace MixedCracks
