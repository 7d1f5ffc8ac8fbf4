// SPDX-License-Identifier: GPL-2.0-or-later
// What a linear solver costs: iterations, seconds of the processor, memory.
#ifndef mixed_cracks_tests_benchmark_measurement_h
#define mixed_cracks_tests_benchmark_measurement_h

#include "../unit/elastic_system.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <sys/resource.h>

#include <fstream>
#include <iostream>

#ifdef __GLIBC__
#  include <malloc.h>
#endif

namespace MixedCracks
{
  namespace Testing
  {
    // memory of all ranks, MB: now, and the largest since forget_peak()
    struct Memory
    {
      double resident = 0.;
      double peak     = 0.;
    };

    inline Memory
    memory()
    {
      dealii::Utilities::System::MemoryStats stats;
      dealii::Utilities::System::get_memory_stats(stats);
      return {dealii::Utilities::MPI::sum(stats.VmRSS / 1024., MPI_COMM_WORLD),
              dealii::Utilities::MPI::sum(stats.VmHWM / 1024., MPI_COMM_WORLD)};
    }



    // what is free goes back to the system first, or nobody sees it used again
    inline void
    forget_peak()
    {
#ifdef __GLIBC__
      malloc_trim(0);
#endif
      std::ofstream("/proc/self/clear_refs") << 5;
    }



    inline void
    print(const std::string &line)
    {
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << line << std::endl;
    }



    // in the program and in the kernel, which hands it memory
    inline double
    seconds_of_the_processor()
    {
      rusage used;
      getrusage(RUSAGE_SELF, &used);
      return used.ru_utime.tv_sec + used.ru_stime.tv_sec +
             1e-6 * (used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    }



    // of the processor, on the rank that takes longest: what else the machine
    // does matters less
    inline double
    seconds_of(const std::function<void()> &work)
    {
      MPI_Barrier(MPI_COMM_WORLD);
      const double start = seconds_of_the_processor();
      work();
      return dealii::Utilities::MPI::max(seconds_of_the_processor() - start,
                                         MPI_COMM_WORLD);
    }



    // main() of a benchmark: an error ends it on all ranks
    inline int
    run_benchmark(int argc, char **argv, const std::function<void()> &body)
    {
      dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
      try
      {
        body();
        return 0;
      }
      catch (const std::exception &error)
      {
        std::cerr << error.what() << std::endl;
        MPI_Abort(MPI_COMM_WORLD, 1);
        return 1;
      }
    }



    struct Measurement
    {
      std::string  solver;
      unsigned int iterations = 0;
      double       analysis = 0., setup = 0., solve = 0.; // s
      double       resident = 0., peak = 0.;              // kB per unknown
    };

    // The set-up of an iterative solver contains a solution to no tolerance.
    // Seconds of set-up and solution are those of the last pass: later ones use
    // memory that the first has got from the system, as in a load step.
    template <int dim>
    Measurement
    measure(const std::string  &name,
            ElasticSystem<dim> &system,
            const double        tolerance,
            const unsigned int  passes = 1)
    {
      Measurement result;
      forget_peak();
      const Memory        before = memory();
      LinearSolverOptions options;
      options.tolerated_growth = 0.; // a new hierarchy in each pass
      const auto solver        = all_linear_solvers().make(name, options);
      auto       solution      = system.right_hand_side;
      const auto require       = [](const LinearOutcome &outcome) {
        if (!outcome.success)
          print("failed: " + outcome.reason);
      };
      result.analysis =
        seconds_of([&]() { require(solver->initialize(system.system())); });
      LinearOutcome outcome;
      for (unsigned int pass = 0; pass < passes; ++pass)
      {
        solution     = system.right_hand_side;
        result.setup = seconds_of([&]() {
          require(solver->factorize());
          require(solver->solve(solution, system.right_hand_side, 0.99));
        });
        result.solve = seconds_of([&]() {
          outcome = solver->solve(solution, system.right_hand_side, tolerance);
        });
        require(outcome);
      }
      const Memory after = memory();
      const double kB    = 1024. / system.fields.elastic.n_dofs();
      result.solver      = solver->description();
      result.iterations  = outcome.iterations;
      result.resident    = (after.resident - before.resident) * kB;
      result.peak        = (after.peak - before.resident) * kB;
      return result;
    }
  } // namespace Testing
} // namespace MixedCracks

#endif
