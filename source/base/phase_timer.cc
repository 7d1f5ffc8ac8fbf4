// SPDX-License-Identifier: GPL-2.0-or-later
// The system keeps the peak of the whole run alone. A phase in which it grows
// has reached it; of another one, which stays below, the end is known.

#include <base/phase_timer.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <iostream>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    struct Memory
    {
      double resident, peak; // MB
    };



    Memory
    memory_now()
    {
      Utilities::System::MemoryStats stats;
      Utilities::System::get_memory_stats(stats);
      return {stats.VmRSS / 1024., stats.VmHWM / 1024.};
    }
  } // namespace



  PhaseTimer::PhaseTimer(const MPI_Comm communicator)
    : communicator(communicator)
    , timer(communicator,
            std::cout,
            TimerOutput::never,
            TimerOutput::wall_times)
  {}



  PhaseTimer::Scope::Scope(PhaseTimer &timer, const std::string &name)
    : scope(timer.timer, name)
    , memory(timer.most[name])
    , peak_known(timer.peak_known)
  {}



  PhaseTimer::Scope::~Scope()
  {
    const Memory now = memory_now();
    memory =
      std::max({memory, now.resident, now.peak > peak_known ? now.peak : 0.});
    peak_known = now.peak;
  }



  void
  PhaseTimer::count_elsewhere(const std::string           &running,
                              const std::string           &other,
                              const std::function<void()> &work)
  {
    timer.leave_subsection(running);
    {
      Scope scope(*this, other);
      work();
    }
    timer.enter_subsection(running);
  }



  std::map<std::string, double>
  PhaseTimer::seconds() const
  {
    std::map<std::string, double> result;
    for (const auto &[name, here] :
         timer.get_summary_data(TimerOutput::total_wall_time))
      result[name] = Utilities::MPI::max(here, communicator);
    return result;
  }



  std::map<std::string, double>
  PhaseTimer::memory() const
  {
    std::map<std::string, double> result;
    for (const auto &[name, here] : most)
      result[name] = Utilities::MPI::sum(here, communicator);
    return result;
  }



  double
  PhaseTimer::peak_memory() const
  {
    return Utilities::MPI::sum(memory_now().peak, communicator);
  }
} // namespace MixedCracks
