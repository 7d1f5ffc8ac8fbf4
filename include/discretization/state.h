// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_state_h
#define mixed_cracks_discretization_state_h

#include <base/linear_algebra.h>

#include <discretization/damage_origins.h>

#include <vector>

namespace MixedCracks
{
  /// One state of the body, a value: a step works on a copy (the trial) and
  /// the accepted one is replaced or kept, nobody restores vectors by hand.
  /// All vectors have ghosts.
  struct State
  {
    double time      = 0.; ///< s
    double time_step = 0.; ///< that led here, s; 0: the initial state

    LinearAlgebra::Vector elastic;     ///< displacement (mm), pressure (MPa)
    LinearAlgebra::Vector phase_field; ///< 1 intact, 0 broken
    /// phi~, the phase field the degradation was evaluated with, (M9)
    LinearAlgebra::Vector lagged_phase_field;
    /// one step earlier, for the extrapolated coupling
    LinearAlgebra::Vector previous_phase_field;
    /// internal minus external nodal forces per mm thickness (N/mm): what the
    /// supports give, 0 at free nodes
    LinearAlgebra::Vector reaction;
    /// where damage was seen first, on the way to this state
    DamageOrigins damage_origins;
  };



  /// Which degrees of freedom a vector of a state belongs to.
  enum class StateDofs
  {
    elastic,
    phase_field
  };

  /// What has to be known of a vector to keep it, and to carry it to another
  /// mesh.
  struct StateVector
  {
    LinearAlgebra::Vector State::*member;
    StateDofs                     dofs;
    /// whether it is a field, which can be interpolated; forces cannot
    bool is_field;
  };

  /// All vectors of a state. Refinement and checkpoints go through this list;
  /// the order within each kind of dofs is that of the file of a checkpoint.
  constexpr StateVector state_vectors[] = {
    {&State::elastic, StateDofs::elastic, true},
    {&State::reaction, StateDofs::elastic, false},
    {&State::phase_field, StateDofs::phase_field, true},
    {&State::lagged_phase_field, StateDofs::phase_field, true},
    {&State::previous_phase_field, StateDofs::phase_field, true}};

  static_assert(sizeof(State) == 2 * sizeof(double) +
                                   sizeof(state_vectors) / sizeof(StateVector) *
                                     sizeof(LinearAlgebra::Vector) +
                                   sizeof(DamageOrigins),
                "every vector of a state has to be in the list of them");

  /// Those of @p dofs, in the order of the list; pointers to constant vectors
  /// for a constant @p state.
  template <typename AnyState>
  auto
  vectors_on(const StateDofs dofs, AnyState &state)
  {
    std::vector<decltype(&state.elastic)> result;
    for (const StateVector &vector : state_vectors)
      if (vector.dofs == dofs)
        result.push_back(&(state.*vector.member));
    return result;
  }

  /// Those of them that can be interpolated.
  inline std::vector<LinearAlgebra::Vector *>
  fields_on(const StateDofs dofs, State &state)
  {
    std::vector<LinearAlgebra::Vector *> result;
    for (const StateVector &vector : state_vectors)
      if (vector.dofs == dofs && vector.is_field)
        result.push_back(&(state.*vector.member));
    return result;
  }
} // namespace MixedCracks

#endif
