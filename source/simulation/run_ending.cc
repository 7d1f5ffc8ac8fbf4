// SPDX-License-Identifier: GPL-2.0-or-later
// How a run ends, in the order of what counts more when several are true:
// nothing carries the loads, the body is cut in two, the force has fallen.
//
// For a resumed run the question is whether anything is left to do with the
// parameters of now. What was an end then need not be one now: a later end
// time, a limit of force that was lowered. A failure is tried again only if
// something that could mend it has changed: the same input gives the same
// failure.

#include <input/case_signature.h>

#include <simulation/run_ending.h>

namespace MixedCracks
{
  namespace
  {
    std::string
    load_at_failure(const StatisticsRow &carried, const StatisticsRow &last)
    {
      return format("; load at failure: between %.6g N (t = %.6g s), which was "
                    "carried, and %.6g N (t = %.6g s), which was not",
                    carried.force_size(),
                    carried["time"],
                    last.force_size(),
                    last["time"]);
    }



    void
    log_how_it_goes_on(const RunEnd earlier, const RunEnd end, Log &log)
    {
      log.line(end != RunEnd::none ? "nothing is left to do: " + in_words(end)
               : earlier == RunEnd::none || earlier == RunEnd::stopped
                 ? "the run goes on"
                 : "the run had ended (" + in_words(earlier) +
                     ") and goes on with the parameters of now");
      if (end == RunEnd::failed || end == RunEnd::onset)
        log.line("the same step is tried again once an entry on load steps, "
                 "the linear solver or the coupling has changed");
    }
  } // namespace



  RunOutcome
  RunEnding::outcome(const std::vector<StatisticsRow> &rows,
                     const std::string                &stopped) const
  {
    std::string reason = end == RunEnd::stopped ? stopped : in_words(end);
    if (end == RunEnd::no_equilibrium && rows.size() > 1)
      reason += load_at_failure(rows[rows.size() - 2], rows.back());
    return {exit_status(end), reason + why_failed};
  }



  std::string
  way_to_mend(const std::string &error, const double time)
  {
    if (!can_be_mended(error))
      return "";
    return format(" The last accepted state, t = %.6g s, is kept: --resume "
                  "goes on from it with another expression in this entry.",
                  time);
  }



  RunEnd
  end_after_step(const double          force,
                 const bool            is_cut,
                 const bool            is_carried,
                 const LoadParameters &parameters,
                 LoadControl          &load_control)
  {
    // asked in any other case: it watches the force. A load that nothing
    // carries any more is no force that was borne.
    const bool has_fallen = is_carried && load_control.has_fallen(force);
    return !is_carried                                ? RunEnd::no_equilibrium
           : is_cut && parameters.stop_when_separated ? RunEnd::separated
           : has_fallen                               ? RunEnd::force_fell
                                                      : RunEnd::none;
  }



  RunEnding
  ending_of_resumed_run(const RunRecord             &record,
                        const std::string           &attempt,
                        const LoadParameters        &parameters,
                        const std::function<bool()> &is_cut,
                        LoadControl                 &load_control,
                        Log                         &log)
  {
    const bool is_again = is_same_attempt(record.attempt, attempt);
    RunEnding  ending;
    // no parameter that may change would mend it
    if (record.end == RunEnd::no_equilibrium)
      ending.end = RunEnd::no_equilibrium;
    else if (parameters.stop_when_separated &&
             (record.end == RunEnd::separated || is_cut()))
      ending.end = RunEnd::separated;
    else if (load_control.has_fallen(record.rows.back().force_size()))
      ending.end = RunEnd::force_fell;
    else if (load_control.at_end())
      ending.end = RunEnd::end_time;
    // the same step would come to the same
    else if (record.end == RunEnd::failed && is_again)
    {
      ending.end        = RunEnd::failed;
      ending.why_failed = record.why_failed;
    }
    else if (record.end == RunEnd::onset && is_again)
      ending.end = RunEnd::onset;
    ending.had_ended = ending.is_over();
    log_how_it_goes_on(record.end, ending.end, log);
    return ending;
  }
} // namespace MixedCracks
