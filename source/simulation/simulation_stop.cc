// SPDX-License-Identifier: GPL-2.0-or-later
// Where a run is left when it is asked to stop, or has no time left.
#include <base/stop_request.h>

#include <simulation/simulation.h>

namespace MixedCracks
{
  namespace
  {
    constexpr int status_stopped           = 5;
    constexpr int status_nothing_to_resume = 6;
  } // namespace



  template <int dim>
  bool
  Simulation<dim>::stop_now(const std::string &finished)
  {
    const bool was_decided = stop_poll.is_decided();
    const bool stop        = stop_poll.ask(finished);
    if (stop && !was_decided)
      log.line("  " + stop_poll.in_words());
    return stop;
  }



  template <int dim>
  bool
  Simulation<dim>::stop_before_a_step()
  {
    const bool was_decided = stop_poll.is_decided();
    const bool stop        = stop_poll.ask_before_a_step();
    if (stop && !was_decided)
      log.line("  " + stop_poll.in_words());
    return stop;
  }



  template <int dim>
  void
  Simulation<dim>::note_checkpoint(const double begin)
  {
    stop_poll.note_checkpoint(begin);
    if (stop_poll.is_decided() && !stop_poll.is_by_clock())
      log.line(printed("  checkpoint written %.1f s after the request to stop",
                       stop_poll.seconds_since_request()));
  }



  template <int dim>
  RunEnd
  Simulation<dim>::how_stopped() const
  {
    // a run that is continued with the same limit would not get further, and
    // who continues it automatically would do so for ever
    const bool got_nowhere =
      stop_poll.is_by_clock() && resumed && stop_poll.n_steps() == 0;
    return got_nowhere ? RunEnd::out_of_time : RunEnd::stopped;
  }



  template <int dim>
  void
  Simulation<dim>::leave_early_if_asked(const std::string &finished)
  {
    if (!stop_now(finished))
      return;
    if (resumed)
      throw StoppedEarly("stopped on request while the checkpoint was read, "
                         "which is as it was; continue with --resume",
                         status_stopped);
    throw StoppedEarly("stopped on request before there was a state to write; "
                       "there is nothing to continue, start again",
                       status_nothing_to_resume);
  }



#define INSTANTIATE(dim)                                          \
  template bool   Simulation<dim>::stop_now(const std::string &); \
  template bool   Simulation<dim>::stop_before_a_step();          \
  template void   Simulation<dim>::note_checkpoint(double);       \
  template RunEnd Simulation<dim>::how_stopped() const;           \
  template void   Simulation<dim>::leave_early_if_asked(const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
