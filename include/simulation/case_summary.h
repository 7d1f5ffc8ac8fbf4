// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_case_summary_h
#define mixed_cracks_simulation_case_summary_h

#include <output/recorder.h>
#include <output/summary.h>

#include <simulation/preflight.h>
#include <simulation/run_ending.h>

namespace MixedCracks
{
  /// What a run has come to.
  struct EndOfRun
  {
    RunOutcome  outcome;
    RunEnd      end;
    RunTotals   cost; ///< of all pieces
    Outcome     cracks;
    double      fallen_force; ///< below this the force has fallen, N
    std::string linear_solver;
    /// MB, see PhaseTimer
    std::map<std::string, double> memory;
    double                        peak_memory;
  };

  /// All that summary.json says. Collective.
  template <int dim>
  Summary summarize(const Body<dim>      &body,
                    const Preflight<dim> &before_the_run,
                    const Recorder<dim>  &recorder,
                    const EndOfRun       &end);
} // namespace MixedCracks

#endif
