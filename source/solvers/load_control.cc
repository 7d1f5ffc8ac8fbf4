// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/errors.h>

#include <deal.II/base/patterns.h>

#include <solvers/load_control.h>

#include <algorithm>
#include <limits>
#include <sstream>

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

    void
    require_order(const std::string &smaller_name,
                  const double       smaller,
                  const std::string &larger_name,
                  const double       larger)
    {
      if (smaller <= larger)
        return;
      std::ostringstream message;
      message << "Load stepping/" << smaller_name << ": " << smaller
              << " s is larger than Load stepping/" << larger_name << ", "
              << larger << " s. It must not be.";
      throw InputError(message.str());
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
    prm.add_parameter("First step",
                      first_step,
                      "The first load step dt to be tried. Unit: s.",
                      Double(tiny));
    prm.add_parameter("Largest step",
                      largest_step,
                      "Load steps grow after easy steps, up to this. Unit: s.",
                      Double(tiny));
    prm.add_parameter(
      "Onset step",
      onset_step,
      "At this step and below, a large change of the phase field is a running "
      "crack and is accepted; above it the step is halved. Unit: s.",
      Double(tiny));
    prm.add_parameter(
      "Smallest step",
      smallest_step,
      "A step that fails is halved; failing below this one ends the run with "
      "exit status 3. Unit: s.",
      Double(tiny));
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
      "its notch and a side, whatever force is left. A step in which "
      "that happens is not settled further once less than 15 % of the "
      "peak force is left.",
      dealii::Patterns::Bool());
    prm.add_parameter("Force boundary",
                      force_boundary,
                      "Name of the boundary whose reaction force is reported; "
                      "displacement must be prescribed on it. Empty: the first "
                      "one named in Boundary conditions/Displacement.");
    prm.leave_subsection();
  }



  void
  LoadParameters::check() const
  {
    require_order("Smallest step", smallest_step, "Onset step", onset_step);
    require_order("Onset step", onset_step, "Largest step", largest_step);
    require_order("Smallest step", smallest_step, "First step", first_step);
    require_order("First step", first_step, "Largest step", largest_step);
    if (stop_at_onset && largest_phase_field_change == 0.)
      throw InputError("Load stepping/Stop at onset is true, but Load "
                       "stepping/Largest phase-field change is 0: without a "
                       "bound there is no onset; allowed is a bound above 0.");
    if (stop_fraction >= 1.)
      throw InputError("Load stepping/Stop when force falls below: found " +
                       std::to_string(stop_fraction) +
                       ", allowed is a fraction below 1 (0: off).");
  }



  LoadControl::LoadControl(const LoadParameters &parameters)
    : parameters(parameters)
    , time_step(parameters.first_step)
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
    return time_step <= parameters.onset_step * (1. + rounding);
  }



  LoadControl::Verdict
  LoadControl::judge(const bool converged, const double phase_field_change)
  {
    const double bound = phase_field_bound();
    if (converged && phase_field_change <= bound)
    {
      time += time_step;
      // one that the end time has cut says nothing of the natural step
      if (time_step < natural)
        time_step = natural;
      // a step that used little of the bound was easy; without a bound the
      // first step is the step, but for recovering from failures
      else if (parameters.largest_phase_field_change == 0.)
        time_step = std::min(2. * time_step, parameters.first_step);
      else if (phase_field_change < 0.3 * parameters.largest_phase_field_change)
      {
        // what was refused just now would be refused again
        if (to_wait > 0)
          --to_wait;
        else
          time_step = std::min(2. * time_step, parameters.largest_step);
      }
      limit_step();
      return Verdict::accept;
    }
    if (converged && is_onset_step() && parameters.stop_at_onset)
      return Verdict::onset;
    ++rejected;
    if (converged)
    {
      time_step = std::max(0.5 * time_step, parameters.onset_step);
      to_wait   = steps_before_growth;
    }
    else if (time_step <= parameters.smallest_step * (1. + rounding))
      return Verdict::give_up;
    else
      time_step = std::max(0.5 * time_step, parameters.smallest_step);
    natural = time_step;
    return Verdict::repeat;
  }



  bool
  LoadControl::at_end() const
  {
    return time >= parameters.end_time - rounding * parameters.first_step;
  }



  bool
  LoadControl::has_fallen(const double force)
  {
    peak = std::max(peak, force);
    return force < fallen_force();
  }



  double
  LoadControl::force_when_apart() const
  {
    const double fraction =
      parameters.stop_when_separated
        ? std::max(parameters.stop_fraction, apart_fraction)
        : parameters.stop_fraction;
    return fraction * peak;
  }



  void
  LoadControl::limit_step()
  {
    natural           = time_step;
    const double left = parameters.end_time - time;
    // no crumb of a step just before the end
    if (time_step > left || time_step > left - parameters.smallest_step)
      time_step = std::max(left, 0.);
  }



  void
  LoadControl::restore(const double       new_time,
                       const double       step,
                       const double       peak_force,
                       const unsigned int steps_to_wait)
  {
    // without a bound the first step is the largest one, too
    const double largest = parameters.largest_phase_field_change == 0.
                             ? parameters.first_step
                             : parameters.largest_step;
    time                 = new_time;
    time_step = std::min(std::max(step, parameters.smallest_step), largest);
    peak      = peak_force;
    to_wait   = steps_to_wait;
    limit_step();
  }
} // namespace MixedCracks
