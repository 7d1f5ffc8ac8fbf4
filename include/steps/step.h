// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_steps_step_h
#define mixed_cracks_steps_step_h

#include <base/log.h>

#include <steps/coupling.h>
#include <steps/fixed_point.h>
#include <steps/rest.h>
#include <steps/retreat.h>
#include <steps/step_elastic.h>
#include <steps/step_phase_field.h>

#include <functional>
#include <limits>

namespace MixedCracks
{
  /// What a load step came to; the same on every rank.
  struct StepOutcome
  {
    /// the equations are solved, or were left because the phase field has
    /// changed by more than allowed
    bool solved      = false;
    bool interrupted = false; ///< the user asked to stop
    /// the predicted phase field damages cells that are to be refined
    bool mesh_is_too_coarse = false;
    /// left because the phase field was seen to run away from the accepted one
    bool   runs_away          = false;
    double phase_field_change = 0.; ///< max(phi^(n-1) - phi^n)
    double coupling_change    = 0.; ///< last max|phi - phi~|
    /// the stored energy hardly changes any more: no crack goes on
    bool at_rest = false;
    /// of the last iteration in which a crack ran, see Callbacks
    double remaining_force = std::numeric_limits<double>::infinity();
    /// a crack ran through the body, and no force is left that could change
    bool                            is_apart            = false;
    unsigned int                    coupling_iterations = 0;
    unsigned int                    newton_iterations   = 0;
    unsigned int                    linear_iterations   = 0;
    dealii::types::global_dof_index active_set_size     = 0;
    dealii::types::global_dof_index active_set_changes  = 0;
    std::string                     reason; ///< why it failed, in words
  };

  /// One load step: elastic fields and phase field in turn, as the block
  /// triangular Jacobian of the lagged coupling has it; iterated, this is
  /// alternate minimisation (staggered).
  template <int dim>
  class StepSolver
  {
  public:
    struct Callbacks
    {
      /// asked wherever a step can be left; collective
      std::function<bool()> stop_requested;
      /// told of every phase field that is predicted within the bound; may
      /// note in the trial what was seen in it
      std::function<void(State &)> watch;
      /// whether the phase field of that state needs finer cells
      std::function<bool(const State &)> needs_finer_mesh;
      /// the force on the body over that below which the run ends if the body
      /// is cut; infinite where it goes on
      std::function<double(const State &)> remaining_force;
      /// whether cracks of that state separate the body
      std::function<bool(const State &)> is_cut;
    };

    StepSolver(ElasticStep<dim>      &elastic,
               PhaseFieldStep<dim>   &phase_field,
               const CouplingOptions &options,
               const NewtonOptions   &newton_options,
               Callbacks              callbacks,
               const MPI_Comm         communicator,
               Log                   &log)
      : elastic(elastic)
      , phase_field(phase_field)
      , options(options)
      , newton_options(newton_options)
      , callbacks(std::move(callbacks))
      , communicator(communicator)
      , log(log)
      , acceleration(options.acceleration)
      , retreat(elastic)
    {}

    /// Solve for @p trial, whose time and time step are set, from @p accepted;
    /// iterated until it is in equilibrium where the time step is 0, that is
    /// for the initial state, whatever the coupling. Left early
    /// when the phase field changed by more than @p bound, and when the mesh
    /// is too coarse: then both states are to be carried to a finer one, and
    /// this is called again with the outcome so far. The iterated coupling
    /// goes on where it was, the others redo the step.
    StepOutcome solve(const State           &accepted,
                      const FixedPhaseField &fixed,
                      double                 bound,
                      const StepOutcome     &so_far,
                      State                 &trial);

  private:
    bool is_settled(const StepOutcome &outcome) const;

    /// With any coupling, the initial state is.
    bool is_iterated(const State &trial) const;

    /// Sets the phase fields and the prediction of the elastic ones.
    NewtonOutcome start(const State &accepted, State &trial);

    /// Whether the trial, of another mesh, is where the step goes on.
    bool goes_on(const StepOutcome &so_far, const State &trial) const;

    void start_lagged_field(const State &accepted, State &trial) const;

    void advance_lagged_field(State &trial);

    NewtonOutcome solve_elastic(const StepOutcome &so_far, State &trial);

    ActiveSetOutcome solve_phase_field(const State           &accepted,
                                       const FixedPhaseField &fixed,
                                       State                 &trial,
                                       StepOutcome           &outcome);

    /// @p factor: length of the step to this iteration over a plain one.
    void look_for_rest(const State &trial, double factor, StepOutcome &outcome);

    /// The outcome of a step that was not solved, for @p reason or because the
    /// run is to stop.
    StepOutcome left(StepOutcome outcome, const std::string &reason) const;

    void look_for_separation(const State &trial, StepOutcome &outcome) const;

    void log_iteration(unsigned int            iteration,
                       const NewtonOutcome    &newton,
                       const ActiveSetOutcome &active_set,
                       double                  change);

    ElasticStep<dim>     &elastic;
    PhaseFieldStep<dim>  &phase_field;
    const CouplingOptions options;
    const NewtonOptions   newton_options;
    const Callbacks       callbacks;
    const MPI_Comm        communicator;
    Log                  &log;

    FixedPointAcceleration acceleration;
    RestWatch              stored_energy;
    Retreat<dim>           retreat;
    LinearAlgebra::Vector  obstacle; // of the phase field in this step
  };
} // namespace MixedCracks

#endif
