// SPDX-License-Identifier: GPL-2.0-or-later
// Where Newton's method of a load step starts from.
//
// Small strain: the accepted state, in proportion to the load; else with the
// change of the mean strain of a periodic body, dE x, added everywhere.
//
// Finite strain: there is no proportion; scaled with the load, u would turn
// broken cells, which are stretched a hundredfold, inside out. With x the
// accepted (u, p), R = internal - F its residual at phi~ of the step, A the
// tangent there, e the increment of the prescribed displacements and dF that of
// the loads,
//
//   A d = - (R - dF + A e),   d = 0 where displacements are prescribed,
//   x <- x + s (d + e),       s the first of 1, 1/2, 1/4 ... for which
//                             min det F > 0.02 (or half of what it was),
//
// A e with the columns of prescribed dofs (Assembler::tangent_times); of a
// pressure that follows the boundary dF is that at u, and A has its part. If
// s < 1,
// Newton's method finds the equilibrium for F + s dF and u_D + s e, and the
// rest follows in the same way. The way is straight in (F, u_D), whatever their
// history within the step.

#include <steps/phase_field_bounds.h>
#include <steps/step_elastic.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // of det F, of the plane in 2-d
    constexpr double least_determinant = 0.02;

    // The parts of a step; and how small one of them may be.
    constexpr unsigned int most_increments   = 50;
    constexpr double       smallest_fraction = 1e-4;
  } // namespace



  // Proportional loading at small strain: with b = (u_D, F) at the accepted
  // time and a at the new one, ratio = a . b / b . b is the least-squares
  // factor, and where a = ratio b to rounding (|a - ratio b|^2 <= 1e-24 |ratio
  // b|^2) the start is ratio * (u, p): exact while phi does not change, since
  // the law is homogeneous of degree one. Otherwise (u, p) of the accepted
  // state with the new u_D. Units of u_D and F are mixed here, which does no
  // harm: each has to be proportional.
  template <int dim>
  void
  ElasticStep<dim>::predict_in_proportion(const State &accepted,
                                          State       &trial) const
  {
    Vector before = fields.owned_vector(fields.elastic_dofs);
    Vector after  = before;
    constraints.apply_prescribed(accepted.time, before);
    constraints.apply_prescribed(trial.time, after);
    const Vector forces_before =
      external_forces(accepted.time, trial.lagged_phase_field);
    Vector forces_after = external_forces(trial.time, trial.lagged_phase_field);

    const double size = before * before + forces_before * forces_before;
    const double ratio =
      size > 0. ? (before * after + forces_before * forces_after) / size : 0.;
    Vector start(after);
    start              = accepted.elastic;
    bool in_proportion = false;
    // loads near the largest number have squares beyond it
    if (size > 0. && std::isfinite(ratio))
    {
      Vector difference(after);
      difference.add(-ratio, before);
      forces_after.add(-ratio, forces_before);
      const double error =
        difference * difference + forces_after * forces_after;
      in_proportion = error <= 1e-24 * ratio * ratio * size;
    }
    if (in_proportion)
      start *= ratio;
    else
      constraints.add_mean_strain(accepted.time, trial.time, start);
    constraints.apply_prescribed(trial.time, start);
    trial.elastic = start;
  }



  template <int dim>
  bool
  ElasticStep<dim>::is_admissible(const State &state) const
  {
    return !assembler.is_finite() ||
           assembler.smallest_determinant(state.elastic,
                                          state.lagged_phase_field) > 0.;
  }



  // At the nodes of cells that are turned inside out, phi~_0 the phase field
  // with which (u, p) was found,
  //
  //   phi~ <- min(phi~, phi~_0),   obstacle <- min(obstacle, phi~).
  //
  // phi~_0 everywhere if that is no way out.
  template <int dim>
  void
  ElasticStep<dim>::stay_admissible(const Vector &before,
                                    State        &trial,
                                    Vector       &obstacle) const
  {
    if (is_admissible(trial))
      return;
    const auto &hanging = constraints.phase_field_hanging_nodes();
    Vector      marks   = fields.owned_vector(fields.phase_field_dofs);
    assembler.mark_inside_out(
      trial.elastic, trial.lagged_phase_field, hanging, marks);
    lower_where(marks, before, trial.lagged_phase_field);
    Vector fitting = marks;
    fitting        = trial.lagged_phase_field;
    hanging.distribute(fitting);
    trial.lagged_phase_field = fitting;
    if (!is_admissible(trial))
    {
      marks                    = 1.;
      trial.lagged_phase_field = before;
    }
    lower_where(marks, trial.lagged_phase_field, obstacle);
  }



  // e: what is left of the prescribed displacements
  template <int dim>
  Vector
  ElasticStep<dim>::prescribed_increment(const State &trial) const
  {
    Vector result = fields.owned_vector(fields.elastic_dofs);
    Vector old(result);
    result = trial.elastic;
    old    = result;
    constraints.apply_prescribed(trial.time, result);
    result.add(-1., old);
    return result;
  }



  // correction = d + e
  template <int dim>
  LinearOutcome
  ElasticStep<dim>::tangent_increment(const Vector        &change,
                                      const Vector        &prescribed,
                                      const State         &trial,
                                      const NewtonOptions &options)
  {
    if (!std::isfinite(evaluate_residual(trial).largest()))
      return {false,
              0,
              "the forces of the state before the step are not "
              "finite on this mesh"};
    const LinearOutcome matrix = update_matrix(false, options);
    if (!matrix.success)
      return matrix;
    Vector along = fields.ghosted_vector(fields.elastic_dofs);
    along        = prescribed;
    Vector image = fields.owned_vector(fields.elastic_dofs);
    {
      PhaseTimer::Scope scope(timer, "assembly");
      assembler.tangent_times(
        along, constraints.elastic_hanging_nodes(), image);
      follower.add_tangent_times(
        along, constraints.elastic_hanging_nodes(), image);
    }
    residual.add(1., image, -1., change);
    constraints.drop_prescribed(residual);
    const LinearOutcome outcome =
      solve_for_correction(options.loose_linear_tolerance);
    correction.add(1., prescribed);
    return outcome;
  }



  template <int dim>
  double
  ElasticStep<dim>::move_along_correction(State &trial)
  {
    iterate                  = trial.elastic;
    const Vector from        = iterate;
    const auto   determinant = [&]() {
      return assembler.smallest_determinant(trial.elastic,
                                            trial.lagged_phase_field);
    };
    const double least = std::min(least_determinant, 0.5 * determinant());
    for (double fraction = 1.; fraction > smallest_fraction; fraction *= 0.5)
    {
      iterate = from;
      iterate.add(fraction, correction);
      trial.elastic = iterate;
      if (determinant() > least)
        return fraction;
    }
    return 0.;
  }



  template <int dim>
  double
  ElasticStep<dim>::take_increment(const Vector        &change,
                                   const Vector        &prescribed,
                                   State               &trial,
                                   const NewtonOptions &options,
                                   NewtonOutcome       &outcome)
  {
    const LinearOutcome linear =
      tangent_increment(change, prescribed, trial, options);
    outcome.linear_iterations += linear.iterations;
    outcome.reason = linear.reason;
    if (!linear.success)
      return 0.;
    const double fraction = move_along_correction(trial);
    if (fraction == 0.)
      outcome.reason = "any further load turns cells inside out";
    return fraction;
  }



  // Newton's method with the forces in `external`
  template <int dim>
  bool
  ElasticStep<dim>::equilibrate_on_the_way(State               &trial,
                                           const NewtonOptions &options,
                                           NewtonOutcome       &outcome)
  {
    NewtonOptions present = options;
    present.tolerance     = std::max(tolerance_on_the_way, options.tolerance);
    const NewtonOutcome newton = solve_once(trial, present);
    outcome.iterations += newton.iterations;
    outcome.linear_iterations += newton.linear_iterations;
    if (!newton.converged)
      outcome.reason = "on the way to the load of the step: " + newton.reason;
    return newton.converged;
  }



  template <int dim>
  NewtonOutcome
  ElasticStep<dim>::predict_along_tangent(const State         &accepted,
                                          State               &trial,
                                          const NewtonOptions &options)
  {
    NewtonOutcome outcome;
    trial.elastic   = accepted.elastic;
    is_stopped      = false;
    Vector obstacle = accepted.phase_field;
    stay_admissible(accepted.lagged_phase_field, trial, obstacle);
    if (!is_admissible(trial))
    {
      outcome.reason = "the state before the step is turned inside out at a "
                       "quadrature point of this mesh";
      return outcome;
    }
    external = external_forces(accepted.time, trial.lagged_phase_field);
    const Vector target = external_forces(trial.time, trial.lagged_phase_field);
    follower.set_level(accepted.time, trial.time, 0.);
    for (unsigned int i = 0; i < most_increments; ++i)
    {
      Vector dead(target);
      dead.add(-1., external);
      Vector change(dead);
      change.add(1., pressures_to_come(trial.elastic));
      const Vector prescribed = prescribed_increment(trial);
      outcome.converged =
        change.linfty_norm() == 0. && prescribed.linfty_norm() == 0.;
      if (outcome.converged)
        return outcome;
      const double fraction =
        take_increment(change, prescribed, trial, options, outcome);
      outcome.converged = fraction == 1.;
      if (outcome.converged || fraction == 0.)
        return outcome;
      external.add(fraction, dead);
      follower.advance_level(fraction);
      if (!equilibrate_on_the_way(trial, options, outcome))
        return outcome;
    }
    outcome.reason = "the load of the step is not reached in " +
                     std::to_string(most_increments) + " parts";
    return outcome;
  }



  template <int dim>
  NewtonOutcome
  ElasticStep<dim>::predict(const State         &accepted,
                            State               &trial,
                            const NewtonOptions &options)
  {
    if (assembler.is_finite())
      return predict_along_tangent(accepted, trial, options);
    predict_in_proportion(accepted, trial);
    NewtonOutcome outcome;
    outcome.converged = true;
    return outcome;
  }



#define INSTANTIATE(dim)                                              \
  template bool ElasticStep<dim>::is_admissible(const State &) const; \
  template void ElasticStep<dim>::stay_admissible(                    \
    const Vector &, State &, Vector &) const;                         \
  template NewtonOutcome ElasticStep<dim>::predict(                   \
    const State &, State &, const NewtonOptions &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
