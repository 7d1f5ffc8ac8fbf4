// SPDX-License-Identifier: GPL-2.0-or-later
// Where cells lose their stiffness in one iteration of a running crack, the
// next equilibrium may be too far for Newton's method. Then
//
//   phi~ <- 1/2 (phi~ + phi~_0),   (u, p) <- (u, p)_0,
//
// (u, p)_0 the last equilibrium and phi~_0 its phase field. What is found is an
// iterate of the alternate minimisation as any other, after a shorter step; the
// next one is sought from there.

#include <steps/phase_field_bounds.h>
#include <steps/retreat.h>

namespace MixedCracks
{
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    constexpr unsigned int most_halvings = 6;

    // of the residual; the next phase field changes the problem anyway, and
    // what is accepted in the end has converged
    constexpr double largest_residual = 0.1;
  } // namespace



  template <int dim>
  void
  Retreat<dim>::restart()
  {
    solution.clear();
    n_halvings = 0;
  }



  template <int dim>
  void
  Retreat<dim>::keep(const State &trial)
  {
    if (!elastic.is_finite())
      return;
    n_halvings         = 0;
    solution           = trial.elastic;
    lagged_phase_field = trial.lagged_phase_field;
  }



  // no iterations: turned inside out from the start
  template <int dim>
  bool
  Retreat<dim>::is_near(const NewtonOutcome &newton) const
  {
    return elastic.is_finite() && newton.iterations > 0 &&
           newton.last.largest() <= largest_residual;
  }



  template <int dim>
  bool
  Retreat<dim>::is_possible(const State &trial) const
  {
    return elastic.is_finite() && solution.size() > 0 &&
           n_halvings < most_halvings &&
           largest_difference(
             trial.lagged_phase_field, lagged_phase_field, true) > 0.;
  }



  template <int dim>
  void
  Retreat<dim>::go_back(State &trial, Vector &obstacle)
  {
    ++n_halvings;
    Vector halfway(trial.lagged_phase_field.locally_owned_elements(),
                   trial.lagged_phase_field.get_mpi_communicator());
    Vector last(halfway);
    halfway = trial.lagged_phase_field;
    last    = lagged_phase_field;
    halfway.sadd(0.5, 0.5, last);
    trial.lagged_phase_field = halfway;
    trial.elastic            = solution;
    elastic.stay_admissible(lagged_phase_field, trial, obstacle);
  }



  template class Retreat<2>;
  template class Retreat<3>;
} // namespace MixedCracks
