// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_phase_timer_h
#define mixed_cracks_base_phase_timer_h

#include <deal.II/base/timer.h>

#include <functional>
#include <map>
#include <string>

namespace MixedCracks
{
  /// Wall time and memory of the phases of a run.
  class PhaseTimer
  {
  public:
    explicit PhaseTimer(MPI_Comm communicator);

    /// From here to the end of its block a phase goes on.
    class Scope
    {
    public:
      Scope(PhaseTimer &timer, const std::string &name);
      ~Scope();

      Scope(const Scope &)            = delete;
      Scope &operator=(const Scope &) = delete;

    private:
      dealii::TimerOutput::Scope scope;
      double                    &memory;     // MB, of this phase
      double                    &peak_known; // MB, of the run
    };

    /// Do @p work in the middle of phase @p running, but count it as @p other.
    void count_elsewhere(const std::string           &running,
                         const std::string           &other,
                         const std::function<void()> &work);

    /// s in each phase so far, the largest over the ranks. Collective.
    std::map<std::string, double> seconds() const;

    /// MB in each phase so far: what was resident at its end, and since the
    /// phase before as far as it was more than ever; the sum over the ranks, of
    /// each the most. Collective.
    std::map<std::string, double> memory() const;

    /// MB, the most that was ever resident, summed over the ranks. Collective.
    double peak_memory() const;

  private:
    MPI_Comm                      communicator;
    dealii::TimerOutput           timer;
    std::map<std::string, double> most;            // MB of this rank
    double                        peak_known = 0.; // MB of this rank
  };
} // namespace MixedCracks

#endif
