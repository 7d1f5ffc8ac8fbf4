// SPDX-License-Identifier: GPL-2.0-or-later
// A signal asks the run to stop. The handler only notes which one and when: in
// a handler hardly a function may be called, and a rank that left its work
// there would leave the others waiting in a collective call (deadlock).
// StopPoll asks at places where a run can be left and decides for all ranks.
//
// Written in the handler, read outside: the time first, then the number, so
// that who sees a number has its time. Both are free of locks.
//
// SIGTERM, SIGUSR1 and SIGHUP come from schedulers and launchers, several times
// perhaps; they never end the process. A second Ctrl-C does: it is a person who
// does not want to wait. SA_RESTART: reading and writing files goes on.

#include <base/stop_request.h>

#include <atomic>
#include <csignal>

#include <signal.h>
#include <time.h>

namespace MixedCracks
{
  namespace
  {
    // a second Ctrl-C sooner than this is the same one
    constexpr double same_request = 2.; // s

    volatile std::sig_atomic_t requested = 0;
    std::atomic<double>        time_of_request{0.}; // s
    static_assert(std::atomic<double>::is_always_lock_free,
                  "the handler of a signal must not wait");

    double
    now()
    {
      timespec time{};
      clock_gettime(CLOCK_MONOTONIC, &time); // allowed in a handler
      return time.tv_sec + 1e-9 * time.tv_nsec;
    }

    void
    remember(const int signal)
    {
      if (requested == 0)
      {
        time_of_request = now();
        requested       = signal;
      }
      else if (signal == SIGINT && now() - time_of_request > same_request)
      {
        std::signal(SIGINT, SIG_DFL);
        std::raise(SIGINT); // delivered when the handler is left
      }
    }
  } // namespace



  bool
  ignores_hangup()
  {
    struct sigaction present
    {};
    return sigaction(SIGHUP, nullptr, &present) == 0 &&
           present.sa_handler == SIG_IGN;
  }



  void
  ignore_hangup()
  {
    std::signal(SIGHUP, SIG_IGN);
  }



  void
  listen_for_stop_requests()
  {
    struct sigaction action
    {};
    action.sa_handler = remember;
    action.sa_flags   = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGTERM, SIGINT, SIGUSR1})
      sigaction(signal, &action, nullptr);
    if (!ignores_hangup())
      sigaction(SIGHUP, &action, nullptr);
  }



  StopRequest
  stop_request()
  {
    const int signal = requested;
    if (signal == 0)
      return {};
    return {signal, now() - time_of_request};
  }



  std::string
  name_of_signal(const int signal)
  {
    switch (signal)
    {
      case SIGTERM:
        return "SIGTERM";
      case SIGINT:
        return "SIGINT";
      case SIGHUP:
        return "SIGHUP";
      case SIGUSR1:
        return "SIGUSR1";
    }
    return "signal " + std::to_string(signal);
  }
} // namespace MixedCracks
