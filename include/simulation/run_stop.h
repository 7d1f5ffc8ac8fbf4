// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_run_stop_h
#define mixed_cracks_simulation_run_stop_h

#include <base/log.h>

#include <output/run_end.h>

#include <simulation/stop_poll.h>

#include <string>

namespace MixedCracks
{
  /// Where a run is left when it is asked to stop, or has no time left: asks,
  /// and says the answer in the log. Collective.
  class RunStop
  {
  public:
    RunStop(const MPI_Comm communicator, const double wall_time_limit, Log &log)
      : wall_time_limit(wall_time_limit)
      , poll(communicator, wall_time_limit)
      , log(log)
    {}

    /// From here on stopping leaves something to continue from. @p resumed:
    /// the run goes on from a checkpoint.
    void begin(bool resumed);

    /// Whether the run is to stop, asked of all ranks; logs the first yes.
    bool now(const std::string &finished);

    /// The same where a step would begin: also when it would take too long.
    bool before_a_step();

    /// Throws StoppedEarly where there is nothing to be written yet.
    void leave_early_if_asked(const std::string &finished, bool resumed);

    /// To be called when stopping: whether there is something to continue.
    RunEnd how_stopped() const;

    /// The words for RunEnd::stopped: a run that its clock has stopped names
    /// the limit.
    std::string end_in_words() const;

    /// s since the start of the run, for note_checkpoint().
    double
    clock() const
    {
      return poll.now();
    }

    /// Note how long a checkpoint took that was written since @p begin.
    void note_checkpoint(double begin);

  private:
    bool answer(bool was_decided, bool stop);

    const double wall_time_limit; // s
    StopPoll     poll;
    Log         &log;
    bool         is_resumed = false;
  };
} // namespace MixedCracks

#endif
