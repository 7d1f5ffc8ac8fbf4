// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_steps_step_elastic_h
#define mixed_cracks_steps_step_elastic_h

#include <assembly/assembler.h>
#include <assembly/auxiliary_matrices.h>
#include <assembly/elastic_potential.h>
#include <assembly/fluid_assembler.h>
#include <assembly/matrix_free_elastic.h>
#include <assembly/normal_loads.h>
#include <assembly/point_forces.h>

#include <base/stop_request.h>

#include <base/phase_timer.h>

#include <discretization/constraints.h>
#include <discretization/state.h>

#include <solvers/parameters.h>

namespace MixedCracks
{
  /// Loads on the body, as the assembler takes them.
  template <int dim>
  struct Loads
  {
    std::shared_ptr<dealii::Function<dim>> body_force;
    std::map<dealii::types::boundary_id, std::shared_ptr<dealii::Function<dim>>>
                                         tractions;
    BoundaryFunctions<dim>               normal_tractions; ///< along n
    BoundaryFunctions<dim>               pressures; ///< press on the body
    PointForces<dim>                     at_points{};
    std::shared_ptr<FluidAssembler<dim>> fluid; ///< in the cracks; or null

    /// Of those that do not depend on the cracks.
    bool
    any() const
    {
      return body_force || !tractions.empty() || !normal_tractions.empty() ||
             !pressures.empty() || !at_points.empty();
    }
  };

  /// Displacement and pressure for a given lagged phase field: matrix,
  /// factors and Newton's method. Analysis is kept per mesh, factors as long
  /// as the matrix is (nearly) unchanged.
  template <int dim>
  class ElasticStep
  {
  public:
    struct Counts
    {
      unsigned int factorizations = 0; ///< or hierarchies of multigrid
      unsigned int solves         = 0;
    };

    ElasticStep(const Fields<dim>      &fields,
                const Constraints<dim> &constraints,
                Assembler<dim>         &assembler,
                Loads<dim>              loads,
                PhaseTimer             &timer,
                const SolverParameters &solver_parameters = {},
                StopCheck               stop              = {});

    /// To be called when the mesh changed.
    LinearOutcome reinit();

    /// A start for the step to trial.time from the accepted state, with
    /// trial.lagged_phase_field. At small strain: scaled where the load is
    /// proportional, which is exact while nothing breaks. At finite strain:
    /// along the tangent, by way of equilibria in between where cells would be
    /// turned inside out otherwise; the outcome says why where there is none,
    /// and counts the iterations.
    NewtonOutcome
    predict(const State &accepted, State &trial, const NewtonOptions &options);

    bool
    is_finite() const
    {
      return assembler.is_finite();
    }

    /// Take back the lagged phase field of @p trial to @p before where it has
    /// become larger and cells that only broken material can have would be
    /// turned inside out; @p obstacle is lowered to it there: they do not heal.
    void stay_admissible(const LinearAlgebra::Vector &before,
                         State                       &trial,
                         LinearAlgebra::Vector       &obstacle) const;

    /// Whether no cell is turned inside out: det F > 0 at all quadrature
    /// points. Always so at small strain. Collective.
    bool is_admissible(const State &state) const;

    /// Solve for trial.elastic with trial.lagged_phase_field; sets
    /// trial.reaction too. Where Newton's method cycles between the regimes
    /// of the split, again by way of cracks that are less broken.
    NewtonOutcome solve(State &trial, const NewtonOptions &options);

    /// 2 psi+, what drives the phase field, in the state that solve() left.
    DrivingForce driving_force() const;

    /// state.reaction from its other members, as after a change of the mesh.
    void update_reaction(State &state);

    /// Whether there are loads that do not depend on the cracks.
    bool
    has_dead_loads() const
    {
      return loads.any();
    }

    /// Of these, at the time of the state, on its displacement; N (mJ per mm
    /// thickness). 0 without them.
    double work_of_loads(const State &state);

    /// Nodal forces of the loads on one boundary in a state, N/mm. Collective.
    LinearAlgebra::Vector loads_on_boundary(dealii::types::boundary_id boundary,
                                            const State               &state);

    /// Work of the loads between two states by the trapezoidal rule, of the
    /// supports, and of the fluid in the cracks; N (mJ per mm thickness).
    double external_work(const State &before, const State &after);

    /// Of the state that solve() left, with its lagged phase field; N (mJ per
    /// mm thickness). At small strain half of loads and reactions times the
    /// displacements they act on.
    double stored_energy(const State &state) const;

    const Counts &
    counts() const
    {
      return count;
    }

    /// After reinit().
    const LinearSolver &
    linear_solver() const
    {
      return *solver;
    }

    /// Which linear solver is used and why, for the log.
    std::string linear_solver_in_words() const;

  private:
    /// Of problems on the way to one, which are but starts for what follows.
    static constexpr double tolerance_on_the_way = 1e-4;

    NewtonOutcome predict_along_tangent(const State         &accepted,
                                        State               &trial,
                                        const NewtonOptions &options);

    void predict_in_proportion(const State &accepted, State &trial) const;

    LinearAlgebra::Vector prescribed_increment(const State &trial) const;

    /// Set `correction` to the displacements that @p change of the forces and
    /// @p prescribed, the increment of prescribed displacements, lead to along
    /// the tangent at @p trial, whose forces are in `external`.
    LinearOutcome tangent_increment(const LinearAlgebra::Vector &change,
                                    const LinearAlgebra::Vector &prescribed,
                                    const State                 &trial,
                                    const NewtonOptions         &options);

    /// Move @p trial along `correction`, by the first of 1, 1/2, ... that
    /// turns no cell inside out; 0: there is none.
    double move_along_correction(State &trial);

    /// Both; 0 with the reason in @p outcome, or the fraction.
    double take_increment(const LinearAlgebra::Vector &change,
                          const LinearAlgebra::Vector &prescribed,
                          State                       &trial,
                          const NewtonOptions         &options,
                          NewtonOutcome               &outcome);

    bool equilibrate_on_the_way(State               &trial,
                                const NewtonOptions &options,
                                NewtonOutcome       &outcome);

    /// What keeps Newton's method among states that are none inside out.
    void guard(NewtonProblem &problem, const State &trial);

    /// ... and makes it a minimisation of the potential.
    void minimize(NewtonProblem &problem, State &trial);

    /// Newton's method from trial.elastic, once.
    NewtonOutcome solve_once(State &trial, const NewtonOptions &options);

    /// From @p start, with a lower bound of the lagged phase field that goes
    /// to 0.
    NewtonOutcome solve_by_continuation(State                       &trial,
                                        const LinearAlgebra::Vector &start,
                                        const NewtonOptions         &options);

    /// Make the linear solver for this mesh, if it has to be another one.
    void choose_solver();

    LinearSystem describe_system();

    /// Ask, and remember the answer for Newton's method.
    bool ask_to_stop(const std::string &finished);

    /// Of body force, tractions and forces at points.
    LinearAlgebra::Vector dead_loads(double time) const;

    /// These and the pressures that follow the boundary, in a state.
    LinearAlgebra::Vector loads_in(const State &state);

    /// Take the forces of the pressures at @p elastic, which has ghosts, from
    /// `full_residual`; their size.
    double subtract_pressures(const LinearAlgebra::Vector &elastic);

    /// Forces at @p elastic, which has ghosts, of the pressures that have not
    /// come yet.
    LinearAlgebra::Vector
    pressures_to_come(const LinearAlgebra::Vector &elastic);

    /// The loads that a line search takes for constant.
    double work_along_search(const LinearAlgebra::Vector &elastic,
                             const LinearAlgebra::Vector &displacement);

    /// These and those of the fluid in the cracks of @p phase_field, with
    /// ghosts.
    LinearAlgebra::Vector
    external_forces(double                       time,
                    const LinearAlgebra::Vector &phase_field) const;

    double fluid_work(const State &before, const State &after) const;

    ResidualSize evaluate_residual(const State &trial);

    LinearOutcome update_matrix(bool force, const NewtonOptions &options);

    LinearOutcome solve_for_correction(double relative_tolerance);

    const Fields<dim>      &fields;
    const Constraints<dim> &constraints;
    Assembler<dim>         &assembler;
    Loads<dim>              loads;
    PhaseTimer             &timer;

    const std::string             solver_name;
    const LinearSolverOptions     solver_options;
    const StopCheck               stop;
    bool                          is_stopped = false;
    LinearSolverChoice            choice;
    AssembledAuxiliaries<dim>     auxiliaries;
    std::vector<bool>             pressure_dofs; // owned ones, in order
    LinearAlgebra::SparseMatrix   matrix;
    MatrixFreeElastic<dim>        matrix_free; // one of the two is used
    std::unique_ptr<LinearSolver> solver;      // lives shorter than the matrix
    LinearAlgebra::Vector         iterate;
    LinearAlgebra::Vector         full_residual;
    LinearAlgebra::Vector         residual;
    LinearAlgebra::Vector         correction;
    LinearAlgebra::Vector         external;
    ElasticAssessment             assessment;
    ElasticPotential<dim>         potential;              // at finite strain
    double                        present_potential = 0.; // of the iterate
    FollowerPressure<dim>         follower;               // at finite strain
    LinearAlgebra::Vector         search_forces; // of it, for a line search
    bool                          search_begins = false;
    /// whether any place that the present correction led to has another regime
    /// of the split than the matrix
    bool   crosses_regimes = false;
    Counts count;
  };
} // namespace MixedCracks

#endif
