// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_stop_poll_h
#define mixed_cracks_simulation_stop_poll_h

#include <simulation/wall_time_budget.h>

#include <mpi.h>

#include <chrono>
#include <string>

namespace MixedCracks
{
  /// Whether a run is to stop: by a signal to any rank, or by the clock. All
  /// ranks come to the same answer, and never take it back. Its clock starts
  /// with the object.
  class StopPoll
  {
  public:
    /// @p wall_time_limit in s; 0: none.
    StopPoll(const MPI_Comm communicator, const double wall_time_limit)
      : communicator(communicator)
      , start(Clock::now())
      , budget(wall_time_limit)
    {}

    /// From now on there is a state to write, and the clock counts: stopping
    /// earlier would lose the work.
    void heed_the_clock();

    /// A StopCheck. Collective.
    bool ask(const std::string &finished);

    /// The same where the next load step would begin; the time between two of
    /// these is that of a step. Collective.
    bool ask_before_a_step();

    bool
    is_decided() const
    {
      return decided;
    }

    /// Whether the clock, and no signal, has decided.
    bool
    is_by_clock() const
    {
      return decided && signal == 0;
    }

    /// Load steps that were tried to their end.
    unsigned int
    n_steps() const
    {
      return steps;
    }

    /// Note how long a checkpoint took that was written since @p begin.
    void note_checkpoint(double begin);

    /// s since the start of the process' run.
    double now() const;

    /// s since the run was asked to stop, on any rank.
    double seconds_since_request() const;

    /// What has decided, and which call could not be interrupted for more
    /// than two seconds. One sentence.
    std::string in_words() const;

  private:
    bool decide(bool out_of_time, const std::string &finished);

    using Clock = std::chrono::steady_clock;

    const MPI_Comm          communicator;
    const Clock::time_point start;
    WallTimeBudget          budget;
    bool                    heeds_clock     = false;
    bool                    decided         = false;
    int                     signal          = 0;
    unsigned int            steps           = 0;
    double                  step_begin      = -1.; // none yet
    double                  last_asked      = 0.;
    double                  decision_time   = 0.;
    double                  age_at_decision = 0.; // of the request
    std::string             call;                 // that went on until then
  };
} // namespace MixedCracks

#endif
