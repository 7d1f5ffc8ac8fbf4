// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_case_run_h
#define mixed_cracks_simulation_case_run_h

#include <input/command_line.h>

#include <functional>

namespace MixedCracks
{
  /// Whether this process speaks for all; also one that has not started MPI.
  bool on_first_rank();

  /// Throws FileError on all ranks when not all that was said has arrived.
  /// Where the answer is all that is wanted, it has to; a run goes on without a
  /// screen: it has its log.txt.
  void require_written_output();

  /// What the program is called for: the run, the check or the id of the case
  /// that @p command names. Together with all ranks; returns the exit status.
  int run_case(const CommandLine &command);

  /// The exit status of @p action, or of the error that it throws, with one
  /// message on one rank. Errors of the user are thrown on all ranks alike, and
  /// every rank leaves in order.
  int exit_status(const std::function<int()> &action);
} // namespace MixedCracks

#endif
