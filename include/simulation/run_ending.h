// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_run_ending_h
#define mixed_cracks_simulation_run_ending_h

#include <base/log.h>

#include <output/checkpoint.h>

#include <steps/load_control.h>

#include <functional>

namespace MixedCracks
{
  /// How a run ended.
  struct RunOutcome
  {
    int         exit_status = 0; ///< as in doc/output.md
    std::string reason;
  };

  /// Whether a run is over, and why.
  struct RunEnding
  {
    RunEnd      end = RunEnd::none;
    std::string why_failed; ///< behind the words for the end
    /// before it was resumed: nothing was left to do
    bool had_ended = false;

    bool
    is_over() const
    {
      return end != RunEnd::none;
    }

    void
    is(const RunEnd why, const std::string &failure = "")
    {
      end        = why;
      why_failed = failure;
    }

    /// With the load at failure, if the @p rows have it. @p stopped: the words
    /// for a run that was stopped.
    RunOutcome outcome(const std::vector<StatisticsRow> &rows,
                       const std::string                &stopped) const;
  };

  /// What to say after the @p error of an expression, where the run goes on
  /// from @p time (s) once it is mended; else nothing.
  std::string way_to_mend(const std::string &error, double time);

  /// Whether the run ends with a step of that @p force (N). @p is_cut: the
  /// cracks separate the body; @p is_carried: not only residual stiffness
  /// carries the dead loads.
  RunEnd end_after_step(double                force,
                        bool                  is_cut,
                        bool                  is_carried,
                        const LoadParameters &parameters,
                        LoadControl          &load_control);

  /// Whether a run that is resumed has no way on with the parameters of now,
  /// and why; says so in the log. @p attempt: the parameters that a failed step
  /// would be tried with. @p is_cut: asked whether the cracks separate the
  /// body, where that ends the run.
  RunEnding ending_of_resumed_run(const RunRecord             &record,
                                  const std::string           &attempt,
                                  const LoadParameters        &parameters,
                                  const std::function<bool()> &is_cut,
                                  LoadControl                 &load_control,
                                  Log                         &log);
} // namespace MixedCracks

#endif
