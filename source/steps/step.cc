// SPDX-License-Identifier: GPL-2.0-or-later
// One load step: alternate minimisation (staggered) of the energy in (u, p) and
// phi [Bourdin00]. With n the step, i the iteration and phi~ the phase field in
// the degradation,
//
//   1. (u, p)_i:  ( g(phi~_i) sigma+ + sigma-, eps(w) ) = loads; law of p
//   2. phi_i:     third line of (M5) with D(u_i, p_i),  0 <= phi_i <= phi^(n-1)
//   3. phi~_(i+1) = phi~_i + step(phi_i - phi~_i), within 0 and phi^(n-1),
//      until max |phi_i - phi~_i| is below the tolerance
//
// The obstacle is phi^(n-1) in all iterations: irreversibility holds from step
// to step, an iteration may take back what an earlier one has broken. At finite
// strain it is lowered to phi~_i at the nodes of cells that only a broken
// material can have: turned inside out, they do not heal.
// 'time-lagged' and 'extrapolated' do 1 and 2 once. Jacobian of all unknowns
// with phi~ given:
//
//             u, p         phi
//       u, p [ ElasticStep  0              ]  block triangular: solved in turn,
//       phi  [ dD/du        PhaseFieldStep ]  nothing is neglected
//
// The states sought are the fixed points of phi~ -> phi. With plain steps a
// running crack advances by about one cell per iteration, see fixed_point.cc.

#include <deal.II/base/mpi.h>

#include <steps/phase_field_bounds.h>
#include <steps/step.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // of the elastic residual in one round of the iterated coupling
    constexpr double inexact_reduction = 0.05;
    // Where loose pieces make Newton's method crawl, this many of its
    // iterations are enough for one round.
    constexpr unsigned int inexact_iterations = 2;

    // At finite strain a state that is farther from equilibrium says little of
    // the one that it goes to.
    constexpr double inexact_residual = 1e-2;

    // A node fell from (nearly) intact to (nearly) broken in one step.
    constexpr double running_crack_change = 0.9;

    // A tip that moves by the n-th part of a cell per iteration needs n of them
    // for the next cell, and moves the phase field by about 1/n. What it takes
    // from the stored energy tells it from nodes that break beside a crack. In
    // a strip whose crack grows stably this leaves the force wrong by 1 %.
    constexpr double energy_at_rest = 5e-5;

    // What Newton's method may take where its phase field can be brought
    // nearer.
    constexpr unsigned int iterations_to_follow = 10;

    // The force on a body that is apart changes by less than this from one
    // iteration to the next; of the force below which the run ends.
    constexpr double steady_force = 0.05;
  } // namespace



  // A run starts from equilibrium: at a loaded start a lag would not be that of
  // any step.
  template <int dim>
  bool
  StepSolver<dim>::is_iterated(const State &trial) const
  {
    return options.kind == CouplingOptions::Kind::iterated ||
           trial.time_step == 0.;
  }



  // max |phi - phi~| < tolerance, or < running_tolerance where a crack has run
  // (phi has fallen by more than 0.9 somewhere) and stands
  template <int dim>
  bool
  StepSolver<dim>::is_settled(const StepOutcome &outcome) const
  {
    const bool has_run = outcome.phase_field_change > running_crack_change;
    return outcome.is_apart ||
           outcome.coupling_change < (has_run && outcome.at_rest
                                        ? options.running_tolerance
                                        : options.tolerance);
  }



  // phi~ = phi^(n-1), or clip( phi^(n-2) + (1 + dt_n/dt_(n-1)) (phi^(n-1) -
  // phi^(n-2)) ) to [0, phi^(n-1)]
  template <int dim>
  void
  StepSolver<dim>::start_lagged_field(const State &accepted, State &trial) const
  {
    trial.lagged_phase_field = accepted.phase_field;
    if (options.kind == CouplingOptions::Kind::extrapolated &&
        accepted.time_step > 0.)
      move_within_bounds(accepted.previous_phase_field,
                         accepted.phase_field,
                         1. + trial.time_step / accepted.time_step,
                         accepted.phase_field,
                         trial.lagged_phase_field);
  }



  // phi~ <- clip(next(phi~, phi)) to [0, obstacle]
  template <int dim>
  void
  StepSolver<dim>::advance_lagged_field(State &trial)
  {
    Vector image(trial.phase_field.locally_owned_elements(), communicator);
    Vector lagged(image);
    image  = trial.phase_field;
    lagged = trial.lagged_phase_field;
    const Vector next(acceleration.next(lagged, image));
    move_within_bounds(lagged, next, 1., obstacle, trial.lagged_phase_field);
    elastic.stay_admissible(lagged, trial, obstacle);
  }



  template <int dim>
  void
  StepSolver<dim>::log_iteration(const unsigned int      iteration,
                                 const NewtonOutcome    &newton,
                                 const ActiveSetOutcome &active_set,
                                 const double            change)
  {
    log.line(format("  %5u %9.1e %9.1e %9.1e %8u %8u %7u %6u %7u %10.2e %6.2f",
                    iteration,
                    newton.first.displacement,
                    newton.last.displacement,
                    newton.last.pressure,
                    static_cast<unsigned int>(active_set.n_active),
                    static_cast<unsigned int>(active_set.n_changes),
                    active_set.iterations,
                    newton.iterations,
                    newton.linear_iterations + active_set.linear_iterations,
                    change,
                    acceleration.factor()));
  }



  template <int dim>
  NewtonOutcome
  StepSolver<dim>::solve_elastic(const StepOutcome &so_far, State &trial)
  {
    NewtonOptions present = newton_options;
    // While the phase field still moves, exact displacements are not worth
    // their solves.
    if (is_iterated(trial) &&
        (so_far.coupling_iterations == 0 || !is_settled(so_far)))
    {
      present.relative_tolerance = inexact_reduction;
      present.enough_iterations  = inexact_iterations;
      if (elastic.is_finite())
        present.enough_residual = inexact_residual;
      if (retreat.is_possible(trial))
        present.max_iterations =
          std::min(present.max_iterations, iterations_to_follow);
    }
    return elastic.solve(trial, present);
  }



  template <int dim>
  ActiveSetOutcome
  StepSolver<dim>::solve_phase_field(const State           &accepted,
                                     const FixedPhaseField &fixed,
                                     State                 &trial,
                                     StepOutcome           &outcome)
  {
    const ActiveSetOutcome active_set =
      phase_field.solve(obstacle, fixed, elastic.driving_force(), trial);
    ++outcome.coupling_iterations;
    outcome.linear_iterations += active_set.linear_iterations;
    outcome.active_set_size = active_set.n_active;
    outcome.active_set_changes += active_set.n_changes;
    outcome.phase_field_change =
      largest_difference(accepted.phase_field, trial.phase_field, false);
    outcome.coupling_change =
      largest_difference(trial.phase_field, trial.lagged_phase_field, true);
    return active_set;
  }



  template <int dim>
  void
  StepSolver<dim>::look_for_rest(const State &trial,
                                 const double factor,
                                 StepOutcome &outcome)
  {
    stored_energy.add(elastic.stored_energy(trial), factor);
    outcome.at_rest = stored_energy.is_at_rest(energy_at_rest);
  }



  // Nodes beside a crack that is through go on breaking one by one, for as many
  // iterations as the crack took. The run ends with such a step, and nothing
  // that is looked at depends on them.
  template <int dim>
  void
  StepSolver<dim>::look_for_separation(const State &trial,
                                       StepOutcome &outcome) const
  {
    outcome.is_apart = false;
    // who wants running cracks as accurate as others gets that to the end
    if (outcome.phase_field_change <= running_crack_change ||
        options.running_tolerance <= options.tolerance)
      return;
    const double before     = outcome.remaining_force;
    outcome.remaining_force = callbacks.remaining_force(trial);
    outcome.is_apart =
      before < 1. && outcome.remaining_force < 1. &&
      std::abs(outcome.remaining_force - before) < steady_force &&
      callbacks.is_cut(trial);
  }



  template <int dim>
  NewtonOutcome
  StepSolver<dim>::start(const State &accepted, State &trial)
  {
    start_lagged_field(accepted, trial);
    trial.phase_field = accepted.phase_field;
    log.line("  coupl  |r_u| in       out   out |r_p| active"
             "  changes    sets newton  linear  |phi-phi~| factor");
    return elastic.predict(accepted, trial, newton_options);
  }



  // What was predicted is the best guess there is, unless it turns cells of the
  // new mesh inside out.
  template <int dim>
  bool
  StepSolver<dim>::goes_on(const StepOutcome &so_far, const State &trial) const
  {
    return is_iterated(trial) && so_far.mesh_is_too_coarse &&
           elastic.is_admissible(trial);
  }



  template <int dim>
  StepOutcome
  StepSolver<dim>::left(StepOutcome outcome, const std::string &reason) const
  {
    outcome.interrupted = callbacks.stop_requested();
    outcome.reason = outcome.interrupted ? "the run was asked to stop" : reason;
    return outcome;
  }



  template <int dim>
  StepOutcome
  StepSolver<dim>::solve(const State           &accepted,
                         const FixedPhaseField &fixed,
                         const double           bound,
                         const StepOutcome     &so_far,
                         State                 &trial)
  {
    const bool  iterated = is_iterated(trial);
    StepOutcome outcome  = so_far;
    acceleration.restart();
    stored_energy.restart();
    retreat.restart();
    obstacle = accepted.phase_field;
    // of the step from the last iteration to this one
    double              factor = 0.;
    const bool          is_new = !goes_on(outcome, trial);
    const NewtonOutcome predicted =
      is_new ? start(accepted, trial) : NewtonOutcome();
    if (!is_new)
    {
      const Vector before      = trial.lagged_phase_field;
      trial.lagged_phase_field = trial.phase_field;
      elastic.stay_admissible(before, trial, obstacle);
    }
    outcome.mesh_is_too_coarse = false;
    outcome.newton_iterations += predicted.iterations;
    outcome.linear_iterations += predicted.linear_iterations;
    if (is_new && !predicted.converged)
      return left(outcome, predicted.reason);

    while (true)
    {
      const NewtonOutcome newton = solve_elastic(outcome, trial);
      outcome.newton_iterations += newton.iterations;
      outcome.linear_iterations += newton.linear_iterations;
      const bool is_near =
        iterated && !is_settled(outcome) && retreat.is_near(newton);
      if (!newton.converged && (callbacks.stop_requested() ||
                                !(is_near || retreat.is_possible(trial))))
        return left(outcome, newton.reason);
      if (!newton.converged && retreat.is_possible(trial))
      {
        retreat.go_back(trial, obstacle);
        acceleration.restart();
        continue;
      }
      if (newton.converged)
        retreat.keep(trial);
      const ActiveSetOutcome active_set =
        solve_phase_field(accepted, fixed, trial, outcome);
      log_iteration(outcome.coupling_iterations,
                    newton,
                    active_set,
                    outcome.coupling_change);
      if (!active_set.converged)
        return left(outcome, active_set.reason);
      if (!(outcome.phase_field_change > bound))
      {
        callbacks.watch(trial);
        outcome.mesh_is_too_coarse = callbacks.needs_finer_mesh(trial);
        if (outcome.mesh_is_too_coarse)
          return outcome;
      }
      if (iterated)
      {
        look_for_rest(trial, factor, outcome);
        look_for_separation(trial, outcome);
      }
      const bool settled = is_settled(outcome) &&
                           newton.last.largest() <= newton_options.tolerance;
      if (!iterated || settled || outcome.phase_field_change > bound)
        break;
      if (outcome.coupling_iterations >= options.max_iterations)
      {
        outcome.reason = "the iterated coupling did not settle within " +
                         std::to_string(options.max_iterations) + " iterations";
        return outcome;
      }
      if (callbacks.stop_requested())
        return left(outcome, "");
      // a settled phase field stays, for displacements that are not
      // accurate enough yet
      factor = 0.;
      if (is_settled(outcome))
        continue;
      advance_lagged_field(trial);
      factor = acceleration.factor();
      // with no stable state nearby the change would exceed any bound
      outcome.runs_away = std::isfinite(bound) && acceleration.runs_away();
      if (outcome.runs_away)
        break;
    }
    outcome.solved = true;
    return outcome;
  }



  template class StepSolver<2>;
  template class StepSolver<3>;
} // namespace MixedCracks
