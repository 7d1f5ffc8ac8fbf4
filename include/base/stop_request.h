// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_stop_request_h
#define mixed_cracks_base_stop_request_h

#include <functional>
#include <stdexcept>
#include <string>

namespace MixedCracks
{
  /// Whether a SIGHUP, as of a closed terminal, does nothing to this process.
  bool ignores_hangup();

  /// As nohup does it, for libraries that set it back when they are started.
  void ignore_hangup();

  /// From now on SIGTERM, SIGINT, SIGHUP and SIGUSR1 ask the run to stop in
  /// order, rather than ending it. A SIGHUP that is ignored, as under nohup,
  /// stays ignored. A second SIGINT, two seconds after the first request or
  /// later, ends the process at once.
  void listen_for_stop_requests();

  /// What this process was asked.
  struct StopRequest
  {
    int    signal = 0;  ///< its number; 0: nothing
    double age    = 0.; ///< s since the first one
  };

  StopRequest stop_request();

  /// "SIGTERM" and the like.
  std::string name_of_signal(int signal);

  /// Asks, together with all ranks, whether the run is to stop. To be called
  /// wherever it can be left; @p finished names what was done since the last
  /// time, for the log. Once true it stays true. May be empty.
  using StopCheck = std::function<bool(const std::string &finished)>;

  inline bool
  is_to_stop(const StopCheck &check, const std::string &finished)
  {
    return check && check(finished);
  }

  /// The run was asked to stop before this process had a state to write.
  /// Thrown on all ranks.
  class StoppedEarly : public std::runtime_error
  {
  public:
    StoppedEarly(const std::string &what, const int exit_status)
      : std::runtime_error(what)
      , exit_status(exit_status)
    {}

    const int exit_status;
  };
} // namespace MixedCracks

#endif
