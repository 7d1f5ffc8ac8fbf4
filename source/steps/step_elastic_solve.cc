// SPDX-License-Identifier: GPL-2.0-or-later
// How a step finds displacement and pressure: Newton's method, and what is left
// to try where it cycles.
//
// R is piecewise linear in (u, p): linear as long as no point changes the
// regime of the split (tr eps or p through 0, a principal strain through 0).
// Newton's method,
//
//   A(x_k) d = - R(x_k),   x_(k+1) = x_k + factor d,
//
// A any element of the generalised derivative, is semismooth: it ends after the
// iteration in which no regime changes. With the factors of an older matrix
// A_old it is a quasi-Newton method, that contracts by about |g - g_old|/g_old.
//
// At finite strain R is smooth but for the splits, the tangent is another one
// in every state, and Newton's method is kept where det F > 0
// (solvers/line_search.cc). An old matrix is tried where neither g nor F has
// changed much. The mixed problem is a saddle point, whose residual may have
// minima that are no solutions, near cells that break: what Newton's method for
// (u, p) does not find is sought as the minimum of Pi(u), with p eliminated
// (minimize(), assembly/elastic_potential.cc).
//
// At small strain it can cycle, where a crack that is nearly free of stiffness
// opens in one iteration and closes in the next. Then a continuation in the
// phase field of the degradation: max(phi~, m) for m = 0.1, 0.03, ... 0.001, 0,
// each solution the start for the next. The stiffness left in a crack is about
// (1-kappa) m^2
// + kappa.

#include <steps/step_elastic.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // Lower bounds of the lagged phase field, one after the other; the
    // stiffness that a crack has left is about their square.
    constexpr double least_phase_fields[] = {0.1, 0.03, 0.01, 3e-3, 1e-3, 0.};
    // Factors are used for a matrix whose degradation differs by this much at
    // most: Newton's method then needs another cheap solve or two instead of
    // a factorisation.
    constexpr double largest_degradation_change = 0.5;

    // After fewer than that a Newton's method that may take no more has not
    // stalled.
    constexpr unsigned int many_iterations = 10;

    const char *const asked_to_stop = "asked to stop";

    // NaN where the scale has overflown: nothing is small compared with it
    double
    relative(const double size, const double scale)
    {
      if (!std::isfinite(scale))
        return std::numeric_limits<double>::quiet_NaN();
      return size == 0. ? 0. : size / scale;
    }

    // result: @p values where they are above @p least
    void
    raise(const Vector &values, const double least, Vector &result)
    {
      const IndexSet owned = values.locally_owned_elements();
      Vector         raised(owned, values.get_mpi_communicator());
      for (const auto i : owned)
        raised(i) = std::max(static_cast<double>(values(i)), least);
      raised.compress(VectorOperation::insert);
      result = raised;
    }
  } // namespace



  // R with its size relative to the terms that cancel in it,
  //
  //   |R_u| / max(s_u, |F|),   |R_p| / s_p     (ElasticKernel::squared_scale),
  //
  // rows of prescribed displacements left out: what stands there is the
  // reaction.
  template <int dim>
  ResidualSize
  ElasticStep<dim>::evaluate_residual(const State &trial)
  {
    PhaseTimer::Scope scope(timer, "assembly");
    assessment = assembler.elastic_residual(trial.elastic,
                                            trial.lagged_phase_field,
                                            constraints.elastic_hanging_nodes(),
                                            full_residual);
    full_residual.add(-1., external);
    const double pressures = subtract_pressures(trial.elastic);
    residual               = full_residual;
    constraints.drop_prescribed(residual);
    crosses_regimes |= assessment.regime_changes > 0.;

    // sizes of the two fields apart: their units differ
    std::vector<double> squares(2, 0.);
    const double       *values = residual.begin();
    for (std::size_t i = 0; i < pressure_dofs.size(); ++i)
      squares[pressure_dofs[i] ? 1 : 0] += values[i] * values[i];
    Utilities::MPI::sum(squares, fields.communicator(), squares);
    const double displacement_scale =
      std::max({assessment.displacement_scale, external.l2_norm(), pressures});
    ask_to_stop("assembly of the residual");
    return {relative(std::sqrt(squares[0]), displacement_scale),
            relative(std::sqrt(squares[1]), assessment.pressure_scale),
            displacement_scale,
            assessment.pressure_scale};
  }



  // A new matrix only where the old one is not good enough: a point in another
  // regime, or g changed by more than the allowed part (direct solver) or at
  // all (iterative). Newton's method forces one when the old factors have not
  // reduced the residual enough. At finite strain F must not have changed by
  // more than the allowed part either, and what is forced is made: the distance
  // knows nothing of the pressure.
  template <int dim>
  LinearOutcome
  ElasticStep<dim>::update_matrix(const bool           force,
                                  const NewtonOptions &options)
  {
    // assembly is cheap, factors are not
    const bool   may_be_old     = !force && solver->is_direct();
    const double allowed_change = may_be_old ? largest_degradation_change : 0.;
    const bool   is_near_in_shape =
      !assembler.is_finite() ||
      (may_be_old &&
       assessment.deformation_change < options.largest_deformation_change);
    if (assessment.regime_changes == 0. && is_near_in_shape &&
        assessment.degradation_change <= allowed_change)
      return {};
    {
      PhaseTimer::Scope scope(timer, "assembly");
      if (solver->needs_matrix())
      {
        assembler.elastic_matrix(constraints.elastic_corrections(), matrix);
        follower.add_tangent(constraints.elastic_corrections(), matrix);
      }
      else
        matrix_free.update(assembler);
    }
    if (ask_to_stop("assembly of the matrix"))
      return {false, 0, asked_to_stop};
    PhaseTimer::Scope   scope(timer, "factorisation");
    const unsigned int  before  = solver->n_setups();
    const LinearOutcome outcome = solver->factorize();
    count.factorizations += solver->n_setups() - before;
    if (ask_to_stop("factorisation, " + solver->description()))
      return {false, 0, asked_to_stop};
    return outcome;
  }



  // A d = - R with d = 0 where displacements are prescribed, d at hanging nodes
  // by interpolation
  template <int dim>
  LinearOutcome
  ElasticStep<dim>::solve_for_correction(const double relative_tolerance)
  {
    PhaseTimer::Scope scope(timer, "solve");
    ++count.solves;
    crosses_regimes = false;
    search_begins   = true;
    residual *= -1.;
    const unsigned int  before = solver->n_setups();
    const LinearOutcome outcome =
      solver->solve(correction, residual, relative_tolerance);
    count.factorizations += solver->n_setups() - before;
    constraints.elastic_corrections().distribute(correction);
    if (ask_to_stop("solution, " + solver->description()))
      return {false, outcome.iterations, asked_to_stop};
    return outcome;
  }



  template <int dim>
  NewtonOutcome
  ElasticStep<dim>::solve_once(State &trial, const NewtonOptions &options)
  {
    iterate = trial.elastic;
    NewtonProblem problem;
    problem.is_to_stop    = [&]() { return is_stopped; };
    problem.residual      = [&]() { return evaluate_residual(trial); };
    problem.update_matrix = [&](const bool force) {
      return update_matrix(force, options);
    };
    problem.solve = [&](const double relative_tolerance) {
      return solve_for_correction(relative_tolerance);
    };
    problem.move = [&](const double factor) {
      iterate.add(factor, correction);
      trial.elastic = iterate;
    };
    if (!assembler.is_finite())
      return solve_newton(problem, options);
    guard(problem, trial);
    if (!fields.layout.mixed && !follower.any())
      minimize(problem, trial);
    NewtonOutcome outcome = solve_newton(problem, options);
    // no iterations: turned inside out from the start
    const bool has_stalled =
      outcome.iterations > 0 && (outcome.iterations < options.max_iterations ||
                                 outcome.iterations >= many_iterations);
    if (outcome.converged || !has_stalled || !fields.layout.mixed ||
        follower.any() || is_stopped)
      return outcome;
    const NewtonOutcome first = outcome;
    minimize(problem, trial);
    outcome = solve_newton(problem, options);
    outcome.iterations += first.iterations;
    outcome.linear_iterations += first.linear_iterations;
    return outcome;
  }



  // Pi(u) - F . u with the p that belongs to u, whatever that of the iterate. A
  // pressure that follows the boundary has no potential: its forces are those
  // where the search begins, with which the slope is the residual all the same,
  // and there is nothing to be minimised.
  template <int dim>
  void
  ElasticStep<dim>::guard(NewtonProblem &problem, const State &trial)
  {
    problem.is_admissible = [&]() { return is_admissible(trial); };
    problem.potential     = [&]() {
      PhaseTimer::Scope scope(timer, "assembly");
      return potential.value(trial.elastic, trial.lagged_phase_field) -
             work_along_search(trial.elastic, iterate);
    };
    problem.potential_terms = [&]() { return potential.terms(); };
    problem.slope           = [&]() {
      PhaseTimer::Scope scope(timer, "assembly");
      Vector            along = fields.ghosted_vector(fields.elastic_dofs);
      along                   = correction;
      return potential.slope(along, trial.lagged_phase_field) -
             work_along_search(trial.elastic, correction);
    };
  }



  // The solution is a minimum of the potential. Mixed, each iterate gets the p
  // of its u, and the potential is known with the residual.
  template <int dim>
  void
  ElasticStep<dim>::minimize(NewtonProblem &problem, State &trial)
  {
    problem.is_minimum = true;
    if (!fields.layout.mixed)
      return;
    problem.residual = [&]() {
      {
        PhaseTimer::Scope scope(timer, "assembly");
        present_potential =
          potential.value(trial.elastic, trial.lagged_phase_field);
        if (std::isfinite(present_potential))
        {
          trial.elastic = potential.equilibrium();
          iterate       = trial.elastic;
        }
      }
      present_potential -= external * iterate;
      return evaluate_residual(trial);
    };
    problem.potential = [&]() { return present_potential; };
  }



  // With little stiffness left in a crack the problem is nearly homogeneous of
  // degree one: which parts are closed does not depend on the size of the load,
  // so that smaller steps are no way out. The less a crack is broken, the
  // nearer to each other are the regimes; most parts keep theirs from one
  // bound to the next.
  template <int dim>
  NewtonOutcome
  ElasticStep<dim>::solve_by_continuation(State               &trial,
                                          const Vector        &start,
                                          const NewtonOptions &options)
  {
    const Vector  exact = trial.lagged_phase_field;
    NewtonOutcome outcome;
    unsigned int  iterations = 0, linear_iterations = 0;
    trial.elastic = start;
    for (const double least : least_phase_fields)
    {
      NewtonOptions present     = options;
      present.enough_iterations = 0;
      if (least > 0.)
        present.tolerance = std::max(tolerance_on_the_way, options.tolerance);
      raise(exact, least, trial.lagged_phase_field);
      outcome = solve_once(trial, present);
      iterations += outcome.iterations;
      linear_iterations += outcome.linear_iterations;
      if (is_stopped)
        break;
    }
    trial.lagged_phase_field  = exact;
    outcome.iterations        = iterations;
    outcome.linear_iterations = linear_iterations;
    return outcome;
  }



  template <int dim>
  NewtonOutcome
  ElasticStep<dim>::solve(State &trial, const NewtonOptions &options)
  {
    external = external_forces(trial.time, trial.lagged_phase_field);
    follower.set_level(trial.time, trial.time, 1.);
    const Vector start    = trial.elastic;
    is_stopped            = false;
    NewtonOutcome outcome = solve_once(trial, options);
    // after a line search that was cut short the regimes are those of the
    // matrix again, though full steps go from one to the other
    const bool is_cycling =
      !outcome.converged && !is_stopped && crosses_regimes;
    // what has no size any more has no regimes
    if (is_cycling && std::isfinite(outcome.last.largest()))
    {
      const NewtonOutcome first = outcome;
      outcome                   = solve_by_continuation(trial, start, options);
      outcome.iterations += first.iterations;
      outcome.linear_iterations += first.linear_iterations;
      if (!outcome.converged && !is_stopped)
        outcome.reason +=
          "; the split of the energy goes on changing its branch, where a "
          "crack opens and closes: Model/Residual stiffness (kappa) is too "
          "small for it, or Model/Energy split = none will do";
    }
    constraints.keep_prescribed(full_residual);
    if (trial.reaction.size() != full_residual.size())
      trial.reaction = trial.elastic; // ghosts of the present mesh
    trial.reaction = full_residual;
    return outcome;
  }



#define INSTANTIATE(dim)                                                      \
  template ResidualSize  ElasticStep<dim>::evaluate_residual(const State &);  \
  template LinearOutcome ElasticStep<dim>::update_matrix(                     \
    bool, const NewtonOptions &);                                             \
  template LinearOutcome ElasticStep<dim>::solve_for_correction(double);      \
  template NewtonOutcome ElasticStep<dim>::solve_once(State &,                \
                                                      const NewtonOptions &); \
  template NewtonOutcome ElasticStep<dim>::solve(State &,                     \
                                                 const NewtonOptions &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
