// SPDX-License-Identifier: GPL-2.0-or-later
// Whether to stop, decided by all ranks together: a signal may have reached
// only one of them, and clocks differ. One reduction,
//
//   code = max over the ranks of  1000 + signal   asked by a signal
//                                 1000            time is over
//                                 0               go on.
//
// Once decided it stays so, without further communication: every rank asks as
// often as the others. The age of a request is the largest one, and the log
// says what could not be interrupted when it is more than 2 s.

#include <base/log.h>
#include <base/stop_request.h>

#include <deal.II/base/mpi.h>

#include <simulation/stop_poll.h>

namespace MixedCracks
{
  namespace
  {
    // a request that waited longer is explained
    constexpr double prompt = 2.; // s
    // no signal has this number
    constexpr int clock_code = 1000;
  } // namespace



  double
  StopPoll::now() const
  {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }



  void
  StopPoll::heed_the_clock()
  {
    heeds_clock = true;
    last_asked  = now(); // calls of the start-up do not come again
  }



  bool
  StopPoll::ask(const std::string &finished)
  {
    if (decided)
      return true;
    const double time = now();
    if (heeds_clock)
      budget.note_call(time - last_asked);
    return decide(heeds_clock && budget.is_over(time), finished);
  }



  bool
  StopPoll::ask_before_a_step()
  {
    if (decided)
      return true;
    const double time = now();
    if (step_begin >= 0.)
    {
      budget.note_step(time - step_begin);
      ++steps;
    }
    step_begin = time;
    return decide(budget.is_over_for_a_step(time), "output of the step");
  }



  bool
  StopPoll::decide(const bool out_of_time, const std::string &finished)
  {
    using dealii::Utilities::MPI::max;
    const StopRequest request = stop_request();
    // a signal wins: it says who wants it
    const int code = max(request.signal > 0 ? clock_code + request.signal
                         : out_of_time      ? clock_code
                                            : 0,
                         communicator);
    last_asked = now();
    if (code == 0)
      return false;
    decided         = true;
    signal          = code - clock_code;
    call            = finished;
    decision_time   = last_asked;
    age_at_decision = signal == 0 ? 0. : max(request.age, communicator);
    return true;
  }



  void
  StopPoll::note_checkpoint(const double begin)
  {
    budget.note_checkpoint(now() - begin);
    last_asked = now(); // it is no call that goes on when the time is over
  }



  double
  StopPoll::seconds_since_request() const
  {
    return decided ? age_at_decision + now() - decision_time : 0.;
  }



  std::string
  StopPoll::in_words() const
  {
    if (!decided)
      return "";
    if (signal == 0)
      return format("Output/Wall time limit: %.4g s have gone of %.4g s, and "
                    "the longest load step took %.3g s, leaving in order "
                    "%.3g s at most",
                    decision_time,
                    budget.limit(),
                    budget.longest_step(),
                    budget.reserve());
    std::string text = "asked to stop by " + name_of_signal(signal);
    if (age_at_decision > prompt)
      text += format(", %.1f s ago: not to be interrupted was: %s",
                     age_at_decision,
                     call.c_str());
    return text;
  }
} // namespace MixedCracks
