// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_steps_load_control_h
#define mixed_cracks_steps_load_control_h

#include <deal.II/base/parameter_handler.h>

#include <steps/load_steps.h>

#include <string>

namespace MixedCracks
{
  /// Subsection "Load stepping". Steps that are 0 are derived: see steps().
  struct LoadParameters
  {
    double      end_time      = 1.;
    double      first_step    = 0.;
    double      largest_step  = 0.;
    double      onset_step    = 0.;
    double      smallest_step = 0.;
    std::string step_schedule;
    double      largest_phase_field_change = 0.3;
    double      stop_fraction              = 0.;
    bool        stop_at_onset              = false;
    bool        stop_when_separated        = false;
    std::string force_boundary;

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError with all steps that contradict each other.
    void check() const;

    /// As they are given.
    GivenSteps given_steps() const;

    /// A sentence where the run would make an absurd number of steps, or "".
    std::string warning() const;

    /// As they hold; after check().
    LoadSteps
    steps() const
    {
      return LoadSteps(given_steps());
    }
  };

  /// Chooses the load steps: halves them when a step failed or the phase
  /// field changed too much, lets them grow after easy steps, and knows two
  /// floors, see doc/model.md, section 5.
  class LoadControl
  {
  public:
    enum class Verdict
    {
      accept,
      repeat, ///< with the smaller step that is set now
      onset,  ///< a crack begins to run, and the run is to end there
      give_up ///< the smallest step failed
    };

    explicit LoadControl(const LoadParameters &parameters);

    /// Time after the step that is to be tried, s.
    double target_time() const;

    /// The step that is to be tried, s.
    double
    step() const
    {
      return time_step;
    }

    /// The step that would be tried if there were no end time, s.
    double
    natural_step() const
    {
      return natural;
    }

    /// The bound on the change of the phase field that holds for the present
    /// step; infinity at the onset step and below, unless the run is to end
    /// there.
    double phase_field_bound() const;

    /// Judge the step that was tried.
    Verdict judge(bool converged, double phase_field_change);

    /// Whether the end time is reached.
    bool at_end() const;

    /// Watch the force: true when it has fallen below the fraction of its
    /// peak at which the run is to stop.
    bool has_fallen(double force);

    double
    peak_force() const
    {
      return peak;
    }

    unsigned int
    n_rejected() const
    {
      return rejected;
    }

    /// Below this the force has fallen; 0 when that does not end the run. Of
    /// the unit of the forces.
    double
    fallen_force() const
    {
      return parameters.stop_fraction * peak;
    }

    /// A body whose cracks join two sides, and that carries less than this, is
    /// apart, and the run ends with it: what it still carries is that of broken
    /// cells. 0 when the run goes on. Of the unit of the forces.
    double force_when_apart() const;

    /// Easy steps to come before the step grows again.
    unsigned int
    steps_to_wait() const
    {
      return to_wait;
    }

    /// Continue from a checkpoint; @p step: the natural one, which is kept
    /// within what the parameters allow now.
    void restore(double       time,
                 double       step,
                 double       peak_force,
                 unsigned int steps_to_wait);

  private:
    bool is_onset_step() const;

    void limit_step();

    LoadParameters parameters;
    LoadSteps      steps;
    double         time = 0.;
    double         time_step; // to be tried
    double         natural;   // the same, were there no end time
    double         peak     = 0.;
    unsigned int   rejected = 0;
    unsigned int   to_wait  = 0; // easy steps before the step may grow
  };
} // namespace MixedCracks

#endif
