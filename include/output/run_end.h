// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_run_end_h
#define mixed_cracks_output_run_end_h

#include <string>

namespace MixedCracks
{
  /// Why a run has ended. It belongs to the state: a run that is resumed ends
  /// again the same way, unless its parameters let it go on.
  enum class RunEnd
  {
    none,       ///< it goes on
    separated,  ///< the cracks join two sides of the body
    force_fell, ///< below Load stepping/Stop when force falls below
    end_time,   ///< Load stepping/End time is reached
    /// only residual stiffness carries the dead loads
    no_equilibrium,
    onset,       ///< Load stepping/Stop at onset: a crack begins to run
    failed,      ///< no way on, exit status 3
    stopped,     ///< by a signal or the clock, exit status 5
    out_of_time, ///< no step fits into Output/Wall time limit, exit status 3
    /// an expression has no value that is allowed, at a later time; status 2
    refused
  };

  /// The exit status that belongs to it, as in doc/output.md.
  int exit_status(RunEnd end);

  /// exit_reason of summary.json.
  std::string in_words(RunEnd end);
} // namespace MixedCracks

#endif
