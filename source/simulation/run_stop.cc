// SPDX-License-Identifier: GPL-2.0-or-later
// Answers of a run that has been asked to stop: how far it has come decides on
// the exit status,
//
//   5   there is a checkpoint to go on from
//   6   there was nothing to write yet
//
// A resumed run that met its limit of time before it finished a step would do
// so again, with the same limit: this ends as "out of time", not as "stopped".

#include <base/stop_request.h>

#include <simulation/run_stop.h>

namespace MixedCracks
{
  namespace
  {
    constexpr int status_stopped           = 5;
    constexpr int status_nothing_to_resume = 6;
  } // namespace



  void
  RunStop::begin(const bool resumed)
  {
    is_resumed = resumed;
    poll.heed_the_clock();
  }



  bool
  RunStop::answer(const bool was_decided, const bool stop)
  {
    if (stop && !was_decided)
      log.line("  " + poll.in_words());
    return stop;
  }



  bool
  RunStop::now(const std::string &finished)
  {
    const bool was_decided = poll.is_decided();
    return answer(was_decided, poll.ask(finished));
  }



  bool
  RunStop::before_a_step()
  {
    const bool was_decided = poll.is_decided();
    return answer(was_decided, poll.ask_before_a_step());
  }



  void
  RunStop::note_checkpoint(const double begin)
  {
    poll.note_checkpoint(begin);
    if (poll.is_decided() && !poll.is_by_clock())
      log.line(format("  checkpoint written %.1f s after the request to stop",
                      poll.seconds_since_request()));
  }



  RunEnd
  RunStop::how_stopped() const
  {
    // a run that is continued with the same limit would not get further, and
    // who continues it automatically would never come to an end
    const bool got_nowhere =
      poll.is_by_clock() && is_resumed && poll.n_steps() == 0;
    return got_nowhere ? RunEnd::out_of_time : RunEnd::stopped;
  }



  std::string
  RunStop::end_in_words() const
  {
    if (!poll.is_by_clock())
      return in_words(RunEnd::stopped);
    return format("stopped before Output/Wall time limit, %.4g s, was over; "
                  "continue with --resume",
                  wall_time_limit);
  }



  void
  RunStop::leave_early_if_asked(const std::string &finished, const bool resumed)
  {
    if (!now(finished))
      return;
    if (resumed)
      throw StoppedEarly("stopped on request while the checkpoint was read, "
                         "which is as it was; continue with --resume",
                         status_stopped);
    throw StoppedEarly("stopped on request before there was a state to write; "
                       "there is nothing to continue, start again",
                       status_nothing_to_resume);
  }
} // namespace MixedCracks
