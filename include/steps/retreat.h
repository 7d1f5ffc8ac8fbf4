// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_steps_retreat_h
#define mixed_cracks_steps_retreat_h

#include <steps/step_elastic.h>

namespace MixedCracks
{
  /// The last equilibrium of a step, and the way back to it where Newton's
  /// method does not find the next one. At finite strain only: at small strain
  /// every phase field has its equilibrium within reach. Collective.
  template <int dim>
  class Retreat
  {
  public:
    explicit Retreat(ElasticStep<dim> &elastic)
      : elastic(elastic)
    {}

    /// There is none yet.
    void restart();

    /// The trial is in equilibrium with its lagged phase field.
    void keep(const State &trial);

    /// Whether what Newton's method has left is near enough to equilibrium to
    /// go on with as long as the phase field moves.
    bool is_near(const NewtonOutcome &newton) const;

    /// Whether there is an equilibrium, and the phase field has not come as
    /// near to it as it may: one that is that of the equilibrium has no way to
    /// halve.
    bool is_possible(const State &trial) const;

    /// Halve the way of the lagged phase field from the equilibrium, and begin
    /// with (u, p) of there. @p obstacle: see ElasticStep::stay_admissible.
    void go_back(State &trial, LinearAlgebra::Vector &obstacle);

  private:
    ElasticStep<dim>     &elastic;
    LinearAlgebra::Vector solution;           // (u, p)
    LinearAlgebra::Vector lagged_phase_field; // phi~
    unsigned int          n_halvings = 0;     // since then
  };
} // namespace MixedCracks

#endif
