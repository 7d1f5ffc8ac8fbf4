// SPDX-License-Identifier: GPL-2.0-or-later
// Steps that are not given, from those that are; T the end time, s(t) the
// schedule, in s:
//
//   largest  = the largest of T/10 (unless a schedule begins at 0), all of the
//              schedule and all given steps
//   first    = s(0), else largest
//   onset    = min(largest/10, shortest of the schedule), at least smallest
//   smallest = min(onset/100, first, shortest of the schedule)
//
// where a tenth and a hundredth are no shorter than 1e-12 T, which is known to
// four digits at t = T. A bound at time t is that of the last scheduled time
// <= t. Times that differ by less than the larger of 1e-6 smallest and 1e-15 T
// are one, since sums of steps are rounded.

#include <base/errors.h>
#include <base/log.h>
#include <base/names.h>
#include <base/text.h>

#include <steps/load_steps.h>

#include <limits>

namespace MixedCracks
{
  namespace
  {
    const std::string subsection = "Load stepping/";

    // Of the time at which a step acts. A time has 16 digits: a step of 1e-16
    // of it is none, and the run would not end; one of 1e-12 is known to four
    // digits.
    constexpr double shortest_step  = 1e-12;
    constexpr double digits_of_time = 1e-15;

    // no step of this entry may be lost in rounding at @p time
    void
    require_seen(const std::string        &name,
                 const double              step,
                 const double              time,
                 std::vector<std::string> &problems)
    {
      if (step > 0. && step < shortest_step * time)
        problems.push_back(
          subsection + name +
          format(": found %.6g s, which is lost in rounding at t = %.6g s. "
                 "Allowed are steps from %.6g s.",
                 step,
                 time,
                 shortest_step * time));
    }

    void
    require_all_seen(const GivenSteps         &given,
                     std::vector<std::string> &problems)
    {
      const auto require = [&](const std::string &name, const double step) {
        require_seen(name, step, given.end_time, problems);
      };
      require("First step", given.first);
      require("Largest step", given.largest);
      require("Onset step", given.onset);
      require("Smallest step", given.smallest);
      for (std::size_t i = 0; i < given.schedule.size(); ++i)
      {
        // until the next one takes over
        const double until =
          i + 1 < given.schedule.size()
            ? std::min(given.schedule[i + 1].time, given.end_time)
            : given.end_time;
        const ScheduledStep &entry = given.schedule[i];
        if (entry.time < until)
          require_seen(format("Step schedule at %g s", entry.time),
                       entry.step,
                       until,
                       problems);
      }
    }

    // The shortest and the longest; infinity and 0 where there is none
    std::pair<double, double>
    range_of(const std::vector<ScheduledStep> &schedule)
    {
      std::pair<double, double> range(std::numeric_limits<double>::infinity(),
                                      0.);
      for (const ScheduledStep &entry : schedule)
        range = {std::min(range.first, entry.step),
                 std::max(range.second, entry.step)};
      return range;
    }
  } // namespace



  std::vector<ScheduledStep>
  parse_schedule(const std::string &text, const std::string &parameter)
  {
    std::vector<ScheduledStep> schedule;
    std::string                commas = text;
    std::replace(commas.begin(), commas.end(), ';', ',');
    for (const std::string &item : split_list(commas, ','))
    {
      const std::vector<std::string> parts = split_list(item, ':');
      if (parts.size() != 2)
        throw InputError(parameter + ": found " + in_quotes(item) +
                         ", allowed is 'time : step', several separated by "
                         "commas, as '0 : 1e-4, 0.005 : 1e-5'.");
      const ScheduledStep entry{parse_number(parts[0], parameter),
                                parse_number(parts[1], parameter)};
      if (!(entry.time >= 0.) || !(entry.step > 0.))
        throw InputError(parameter + ": found " + in_quotes(item) +
                         ", allowed are times from 0 and steps above 0.");
      if (!schedule.empty() && entry.time <= schedule.back().time)
        throw InputError(parameter + ": found " + in_quotes(item) +
                         format(" behind the time %g s, allowed are "
                                "ascending times.",
                                schedule.back().time));
      schedule.push_back(entry);
    }
    return schedule;
  }



  std::vector<std::string>
  contradictions(const GivenSteps &given)
  {
    std::vector<std::string> problems;
    const auto               require = [&](const std::string &smaller_name,
                             const double       smaller,
                             const std::string &larger_name,
                             const double       larger) {
      if (smaller > 0. && larger > 0. && smaller > larger)
        problems.push_back(subsection + smaller_name +
                           format(": %.6g s is larger than ", smaller) +
                           subsection + larger_name +
                           format(", %.6g s. It must not be.", larger));
    };
    require("Smallest step", given.smallest, "Onset step", given.onset);
    require("Onset step", given.onset, "Largest step", given.largest);
    require("Smallest step", given.smallest, "First step", given.first);
    require("First step", given.first, "Largest step", given.largest);
    require("Smallest step", given.smallest, "Largest step", given.largest);
    for (const ScheduledStep &entry : given.schedule)
    {
      const std::string name = format("Step schedule at %g s", entry.time);
      require(name, entry.step, "Largest step", given.largest);
      require("Smallest step", given.smallest, name, entry.step);
      if (entry.time == 0.)
        require("First step", given.first, name, entry.step);
    }
    require_all_seen(given, problems);
    return problems;
  }



  LoadSteps::LoadSteps(const GivenSteps &given)
    : first(given.first)
    , largest(given.largest)
    , onset(given.onset)
    , smallest(given.smallest)
    , schedule(given.schedule)
    , rounding_of_time(digits_of_time * given.end_time)
  {
    const double shortest = shortest_step * given.end_time;
    const auto [shortest_scheduled, longest_scheduled] = range_of(schedule);
    if (largest == 0.)
    {
      const bool scheduled = !schedule.empty() && schedule.front().time == 0.;
      largest              = std::max({scheduled ? 0. : 0.1 * given.end_time,
                          longest_scheduled,
                          first,
                          onset,
                          smallest});
      derived.push_back("largest");
    }
    if (first == 0.)
    {
      first = fixed_at(0.);
      if (first == 0.)
        first = largest;
      derived.push_back("first");
    }
    if (onset == 0.)
    {
      onset =
        std::max(std::min(std::max(0.1 * largest, std::min(shortest, largest)),
                          shortest_scheduled),
                 smallest);
      derived.push_back("onset");
    }
    if (smallest == 0.)
    {
      smallest = std::min({std::max(0.01 * onset, std::min(shortest, onset)),
                           first,
                           shortest_scheduled});
      derived.push_back("smallest");
    }
  }



  const ScheduledStep *
  LoadSteps::scheduled_at(const double time) const
  {
    const ScheduledStep *result = nullptr;
    for (const ScheduledStep &entry : schedule)
      if (entry.time <= time + rounding())
        result = &entry;
    return result;
  }



  double
  LoadSteps::largest_at(const double time) const
  {
    const ScheduledStep *const entry = scheduled_at(time);
    return entry != nullptr ? std::min(entry->step, largest) : largest;
  }



  double
  LoadSteps::fixed_at(const double time) const
  {
    const ScheduledStep *const entry = scheduled_at(time);
    return entry != nullptr ? entry->step : first;
  }



  double
  LoadSteps::next_scheduled_time(const double time) const
  {
    for (const ScheduledStep &entry : schedule)
      if (entry.time > time + rounding())
        return entry.time;
    return std::numeric_limits<double>::infinity();
  }



  double
  LoadSteps::least_number(const double end_time, const bool fixed) const
  {
    double number = 0.;
    for (double time = 0.; time < end_time;)
    {
      const double next = std::min(next_scheduled_time(time), end_time);
      number += (next - time) / (fixed ? fixed_at(time) : largest_at(time));
      time = next;
    }
    return number;
  }



  std::string
  LoadSteps::in_words() const
  {
    std::string text = format("first %.4g s, largest %.4g s, onset %.4g s, "
                              "smallest %.4g s",
                              first,
                              largest,
                              onset,
                              smallest);
    for (const ScheduledStep &entry : schedule)
      text += format("; from %.4g s on at most %.4g s",
                     entry.time,
                     std::min(entry.step, largest));
    if (!derived.empty())
      text += " (derived: " + join_names(derived) + ")";
    return text;
  }
} // namespace MixedCracks
