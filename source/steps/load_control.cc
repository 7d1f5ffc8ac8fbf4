// SPDX-License-Identifier: GPL-2.0-or-later
// The length dt of the load steps (s). After a step with the change c = max
// (phi^(n-1) - phi^n) and the bound C = 'Largest phase-field change':
//
//   converged, c <= C        accepted; dt doubles after an easy step, c < 0.3 C
//                            (the third one after a rejection for c)
//   converged, c > C         rejected: dt = max(dt/2, onset step)
//     and dt <= onset step   C is infinite there: accepted, a crack runs,
//                            however small the step; with 'Stop at onset' C
//                            holds there too, and the run ends before it
//   not converged            rejected: dt = max(dt/2, smallest step)
//     at the smallest step   the run ends with status 3
//
//            |---- largest ----|--- onset ---|--- smallest ---|
//            bounded change c    c unbounded   a failure ends the run
//
// The load at which a crack starts is known to the onset step this way, and
// what is applied to a body with a running crack does not matter: it runs at
// constant load in one step of the alternate minimisation (staggered).

#include <base/errors.h>
#include <base/log.h>
#include <base/names.h>

#include <deal.II/base/patterns.h>

#include <steps/load_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  using dealii::Patterns::Double;

  namespace
  {
    // relative to a step: what is shorter than that is rounding
    constexpr double rounding = 1e-9;

    constexpr unsigned int steps_before_growth = 2;

    // Of the peak. Strips that are cut through by a band one row of nodes wide
    // carry more, and the band widens, see doc/model.md, section 3.
    constexpr double apart_fraction = 0.15;

    // the longest runs known make some ten thousand
    constexpr double absurd_number_of_steps = 1e6;

    void
    add_steps(dealii::ParameterHandler &prm, LoadParameters &load)
    {
      prm.add_parameter("First step",
                        load.first_step,
                        "The first load step dt to be tried; 0: that of the "
                        "schedule at t = 0, or else Largest step. Unit: s.",
                        Double(0.));
      prm.add_parameter("Largest step",
                        load.largest_step,
                        "Load steps grow after easy steps, up to this; 0: a "
                        "tenth of End time, or the longest step of a schedule "
                        "that begins at t = 0. Unit: s.",
                        Double(0.));
      prm.add_parameter(
        "Onset step",
        load.onset_step,
        "At this step and below, a large change of the phase field is a "
        "running crack and is accepted; above it the step is halved. 0: a "
        "tenth of Largest step, but no more than any step of the schedule. "
        "Unit: s.",
        Double(0.));
      prm.add_parameter("Smallest step",
                        load.smallest_step,
                        "A step that fails is halved; failing at this one ends "
                        "the run with exit status 3. 0: a hundredth of Onset "
                        "step. Unit: s.",
                        Double(0.));
      prm.add_parameter(
        "Step schedule",
        load.step_schedule,
        "Largest steps over time, 'time : step, ...', as '0 : 1e-4, 0.005 : "
        "1e-5': from that time on, no step is longer. A step ends at each of "
        "the times. With Largest phase-field change = 0 these are the steps. "
        "Empty: none. No step may be shorter than 1e-12 of the time at which "
        "it acts. Unit: s.",
        dealii::Patterns::Anything());
    }
  } // namespace



  void
  LoadParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    const double tiny = std::numeric_limits<double>::min();
    prm.enter_subsection("Load stepping");
    prm.add_parameter("End time",
                      end_time,
                      "Time t at which the run ends. Unit: s.",
                      Double(tiny));
    add_steps(prm, *this);
    prm.add_parameter(
      "Largest phase-field change",
      largest_phase_field_change,
      "Bound on max(phi^(n-1) - phi^n) in one load step longer than the onset "
      "step; 0: no bound, which gives fixed steps. Unit: 1.",
      Double(0., 1.));
    prm.add_parameter(
      "Stop when force falls below",
      stop_fraction,
      "The run ends when the reaction force on the force boundary is below "
      "this fraction of its peak, whether or not the body is separated; 0: "
      "off. Unit: 1.",
      Double(0., 1.));
    prm.add_parameter(
      "Stop at onset",
      stop_at_onset,
      "The run ends, with the last accepted step, where a crack "
      "begins to run: when the phase field changes by more than "
      "its bound in an onset step. For the load at onset alone.",
      dealii::Patterns::Bool());
    prm.add_parameter(
      "Stop when separated",
      stop_when_separated,
      "The run ends when cracks (2-d: those of crack_path.csv), "
      "with the hole or without, join two sides of the body or "
      "its notch and a side, in 3-d when they leave two parts of it that come "
      "to two sides each, whatever force is left. A step in which "
      "that happens is not settled further once less than 15 % of the "
      "peak force is left.",
      dealii::Patterns::Bool());
    prm.add_parameter("Force boundary",
                      force_boundary,
                      "Name of the boundary whose reaction force is reported; "
                      "displacement must be prescribed on it, or it is one of "
                      "Geometry/Periodic sides. Empty: the first one named in "
                      "Boundary conditions/Displacement; else the second of "
                      "Periodic sides; where displacement is prescribed at "
                      "points only, the points "
                      "that move (all where none does), whose reaction is "
                      "taken as it acts on the body.");
    prm.leave_subsection();
  }



  void
  LoadParameters::check() const
  {
    const std::vector<std::string> problems = contradictions(given_steps());
    if (!problems.empty())
      throw InputError(join_names(problems, "\n"));
    if (stop_at_onset && largest_phase_field_change == 0.)
      throw InputError("Load stepping/Stop at onset is true, but Load "
                       "stepping/Largest phase-field change is 0: without a "
                       "bound there is no onset; allowed is a bound above 0.");
    if (stop_fraction >= 1.)
      throw InputError("Load stepping/Stop when force falls below: found " +
                       std::to_string(stop_fraction) +
                       ", allowed is a fraction below 1 (0: off).");
  }



  std::string
  LoadParameters::warning() const
  {
    const double n =
      steps().least_number(end_time, largest_phase_field_change == 0.);
    if (!(n > absurd_number_of_steps))
      return "";
    return format("at least %.3g load steps until the end time of %.6g s: "
                  "Load stepping/Largest step, Step schedule or, with fixed "
                  "steps, First step is far too short for it",
                  n,
                  end_time);
  }



  GivenSteps
  LoadParameters::given_steps() const
  {
    return {end_time,
            first_step,
            largest_step,
            onset_step,
            smallest_step,
            parse_schedule(step_schedule, "Load stepping/Step schedule")};
  }



  LoadControl::LoadControl(const LoadParameters &parameters)
    : parameters(parameters)
    , steps(parameters.steps())
    , time_step(steps.first)
  {
    limit_step();
  }



  double
  LoadControl::target_time() const
  {
    return time + time_step;
  }



  double
  LoadControl::phase_field_bound() const
  {
    const bool bounded = parameters.largest_phase_field_change > 0. &&
                         (parameters.stop_at_onset || !is_onset_step());
    return bounded ? parameters.largest_phase_field_change
                   : std::numeric_limits<double>::infinity();
  }



  bool
  LoadControl::is_onset_step() const
  {
    return time_step <= steps.onset * (1. + rounding);
  }



  LoadControl::Verdict
  LoadControl::judge(const bool converged, const double phase_field_change)
  {
    const double bound = phase_field_bound();
    if (converged && phase_field_change <= bound)
    {
      const double scheduled = steps.next_scheduled_time(time);
      time += time_step;
      const bool landed = std::abs(time - scheduled) <= steps.rounding();
      if (landed)
        time = scheduled;
      // one that the end time has cut says nothing of the natural step
      if (time_step < natural)
        time_step = natural;
      // a step that used little of the bound was easy; without a bound the
      // first step is the step, but for recovering from failures
      else if (parameters.largest_phase_field_change == 0.)
        time_step = landed ? steps.fixed_at(time)
                           : std::min(2. * time_step, steps.fixed_at(time));
      else if (phase_field_change < 0.3 * parameters.largest_phase_field_change)
      {
        // what was refused just now would be refused again
        if (to_wait > 0)
          --to_wait;
        else
          time_step = std::min(2. * time_step, steps.largest_at(time));
      }
      limit_step();
      return Verdict::accept;
    }
    if (converged && is_onset_step() && parameters.stop_at_onset)
      return Verdict::onset;
    ++rejected;
    if (converged)
    {
      time_step = std::max(0.5 * time_step, steps.onset);
      to_wait   = steps_before_growth;
    }
    else if (time_step <= steps.smallest * (1. + rounding))
      return Verdict::give_up;
    else
      time_step = std::max(0.5 * time_step, steps.smallest);
    natural = time_step;
    return Verdict::repeat;
  }



  bool
  LoadControl::at_end() const
  {
    return time >= parameters.end_time - rounding * steps.first;
  }



  bool
  LoadControl::has_fallen(const double force)
  {
    peak = std::max(peak, force);
    return force < fallen_force();
  }



  // max(stop fraction, 0.15 if separation is to end the run) * peak of the
  // force
  double
  LoadControl::force_when_apart() const
  {
    const double fraction =
      parameters.stop_when_separated
        ? std::max(parameters.stop_fraction, apart_fraction)
        : parameters.stop_fraction;
    return fraction * peak;
  }



  // With t_s the next scheduled time and T the end time: dt <= the scheduled
  // bound; if t + dt passes t_s, dt = t_s - t; if t + 2 dt does, dt = (t_s -
  // t)/2, so that no step is a crumb; and the last step takes all that is left
  // to T where that is less than dt + smallest step.
  void
  LoadControl::limit_step()
  {
    time_step = std::min(time_step, steps.largest_at(time));
    // to a scheduled time in one step or in two equal ones, so that none is a
    // crumb
    const double to_next = steps.next_scheduled_time(time) - time;
    if (time_step > to_next - steps.rounding())
      time_step = to_next;
    else if (2. * time_step > to_next + steps.rounding())
      time_step = 0.5 * to_next;
    natural           = time_step;
    const double left = parameters.end_time - time;
    // no crumb of a step just before the end
    if (time_step > left || time_step > left - steps.smallest)
      time_step = std::max(left, 0.);
  }



  void
  LoadControl::restore(const double       new_time,
                       const double       step,
                       const double       peak_force,
                       const unsigned int steps_to_wait)
  {
    time = new_time;
    // without a bound the first step is the largest one, too
    const double largest = parameters.largest_phase_field_change == 0.
                             ? steps.fixed_at(time)
                             : steps.largest_at(time);
    time_step            = std::min(std::max(step, steps.smallest), largest);
    peak                 = peak_force;
    to_wait              = steps_to_wait;
    limit_step();
  }
} // namespace MixedCracks
