// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_steps_load_steps_h
#define mixed_cracks_steps_load_steps_h

#include <algorithm>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// From `time` on no step is longer than `step`; s.
  struct ScheduledStep
  {
    double time;
    double step;
  };

  /// "time : step, ..." with ascending times. Throws InputError that names
  /// @p parameter.
  std::vector<ScheduledStep> parse_schedule(const std::string &text,
                                            const std::string &parameter);

  /// Load steps as they are given; 0: not given. All in s.
  struct GivenSteps
  {
    double                     end_time;
    double                     first;
    double                     largest;
    double                     onset;
    double                     smallest;
    std::vector<ScheduledStep> schedule;
  };

  /// All that contradicts, one sentence each; empty when nothing does: steps
  /// that are longer than they may be, and those that are lost in rounding
  /// against the time they act at. What is not given contradicts nothing.
  std::vector<std::string> contradictions(const GivenSteps &given);

  /// Load steps with what was not given derived from the rest: largest from
  /// the end time (a tenth), first from largest, onset from largest (a tenth,
  /// but no more than any scheduled step), smallest from onset (a hundredth);
  /// moved where a given one would else contradict. All in s.
  struct LoadSteps
  {
    explicit LoadSteps(const GivenSteps &given);

    /// The bound on a step that begins at @p time.
    double largest_at(double time) const;

    /// The step at @p time in a run of fixed steps.
    double fixed_at(double time) const;

    /// The first scheduled time behind @p time; infinity when there is none.
    double next_scheduled_time(double time) const;

    /// Two times that differ by less are one.
    double
    rounding() const
    {
      return std::max(1e-6 * smallest, rounding_of_time);
    }

    /// How many steps the run makes at least; @p fixed: in a run of fixed
    /// steps. Without those that crack growth or failures take.
    double least_number(double end_time, bool fixed) const;

    /// One line: the four steps, and which of them are derived.
    std::string in_words() const;

    double                     first;
    double                     largest;
    double                     onset;
    double                     smallest;
    std::vector<ScheduledStep> schedule;

  private:
    /// The entry of the schedule that holds at @p time; null before the first.
    const ScheduledStep *scheduled_at(double time) const;

    std::vector<std::string> derived;          // their names
    double                   rounding_of_time; // s, where it is largest
  };
} // namespace MixedCracks

#endif
