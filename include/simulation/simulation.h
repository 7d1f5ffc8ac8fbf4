// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_simulation_h
#define mixed_cracks_simulation_simulation_h

#include <cracks/crack_observer.h>

#include <deal.II/distributed/tria.h>

#include <discretization/adaptation.h>

#include <input/case_signature.h>

#include <output/checkpoint.h>
#include <output/crack_opening.h>
#include <output/crack_opening_file.h>
#include <output/crack_path_writer.h>
#include <output/directory.h>
#include <output/energy_balance.h>
#include <output/field_output.h>
#include <output/point_displacements.h>
#include <output/quantities.h>
#include <output/run_end.h>
#include <output/slit_overlap.h>
#include <output/statistics.h>
#include <output/summary.h>

#include <simulation/parameters.h>
#include <simulation/simulation_material.h>
#include <simulation/simulation_setup.h>
#include <simulation/stop_poll.h>

#include <steps/load_control.h>

#include <optional>

namespace MixedCracks
{
  /// How a run ended.
  struct RunOutcome
  {
    int         exit_status = 0; ///< as in doc/output.md
    std::string reason;
  };

  /// The driver: owns the objects of the other rooms and runs the algorithm.
  template <int dim>
  class Simulation
  {
  public:
    /// @p effective_parameters: the complete .prm, to be kept with the
    /// results. @p signature: the parts of it that a resumed run looks at.
    /// The parameters have passed their checks and must outlive the
    /// simulation.
    Simulation(const Parameters<dim> &parameters,
               const std::string     &effective_parameters,
               const CaseSignature   &signature,
               MPI_Comm               communicator,
               Log                   &log);

    /// Mesh, degrees of freedom and what can be said of them beforehand. With
    /// @p only_check a large mesh is not built but counted.
    void preflight(bool only_check = false);

    /// The whole calculation, into the output directory.
    RunOutcome run(ExistingRun existing);

  private:
    void make_mesh_and_material(bool only_check);

    /// Throws InputError when the prescribed displacements leave the body free
    /// to move.
    void require_held_body() const;

    /// Throws InputError when the linear solver cannot do with kappa = 0.
    void require_solver_for_stiffness() const;

    /// As given, but for what kappa = 0 does to the automatic choice.
    SolverParameters solver_parameters() const;

    /// What to think of when a step failed with kappa = 0; else nothing.
    std::string hint_at_no_stiffness() const;

    /// Of the first mesh: counted, or what `--check` knows of it.
    MeshEstimate mesh_counts() const;

    /// What `--check` has not looked at.
    void log_not_checked();

    void make_solvers();

    /// Everything that depends on the mesh, after it changed.
    void reinit_on_mesh();

    AdaptationRule adaptation_rule() const;

    /// Whether the phase field damages cells that are to be finer.
    bool needs_finer_mesh(const LinearAlgebra::Vector &phase_field) const;

    void refine_initial_mesh();

    /// Refine where the trial damages coarse cells; the states are carried
    /// over.
    void refine(State &accepted, State &trial);

    /// Refuse a directory that must not be written into, and prepare one that
    /// is free at once: there is nothing to lose.
    void inspect_output(ExistingRun existing);

    /// Open the files of the run unless they are open. An earlier run that is
    /// to be replaced or continued is left as it is until then: until nothing
    /// of the input can be refused any more.
    void prepare_output();

    /// That of a resumed run, or the initial one.
    State first_state();

    State initial_state();

    /// Try steps until one is accepted, or there is no way on: then why.
    RunEnd advance(State &accepted);

    State resumed_state();

    /// Throws InputError unless the run that is resumed is of the same case. An
    /// expression that has ended it may be another one: that is noted.
    void mend_resumed_case();

    /// Whether a run that is resumed has no way on with the parameters of
    /// now, and why.
    RunEnd end_of_resumed_run(const State &state);

    /// Steps until the end. An error that is not of a file is thrown when the
    /// last accepted state is safe.
    void advance_to_the_end(State &accepted);

    /// Fields and a checkpoint of the last state, and the summary.
    RunOutcome finish(const State &last, const RunOutcome &outcome);

    /// What the run has cost, with the pieces before this one.
    RunTotals totals();

    void write_checkpoint(const State &state, const RunTotals &cost);

    /// Whether the run is to stop, asked of all ranks; logs the first yes.
    bool stop_now(const std::string &finished);

    /// The same where a step would begin: also when it would take too long.
    bool stop_before_a_step();

    /// Note how long a checkpoint took that was written since @p begin.
    void note_checkpoint(double begin);

    /// To be called when stopping: whether there is something to continue.
    RunEnd how_stopped() const;

    /// Throws StoppedEarly where there is nothing to be written yet.
    void leave_early_if_asked(const std::string &finished);

    /// Predict the step, refine where the prediction damages coarse cells
    /// and correct it, until nothing is left to refine.
    StepOutcome solve_step(State &accepted, State &trial, double bound);

    /// What a step has come to; nothing is kept of it.
    StatisticsRow measure(const State       &before,
                          const State       &state,
                          const StepOutcome &outcome);

    /// What of a state and its row is no finite number, in words; empty when
    /// all of it is.
    std::string not_finite(const State &state, const StatisticsRow &row) const;

    /// Of an accepted step.
    void record(const StatisticsRow &row, const State &state);

    /// Along the lines that are given.
    void record_opening(const State &state, const StatisticsRow &row);

    /// Say which slits a mesh from a file has.
    void log_slits();

    /// Warn where the faces of slits pass through each other.
    void watch_slits(const State &state);

    /// Those of the start, and what the steps have added.
    std::vector<std::string> all_warnings() const;

    /// Whether more than the residual stiffness carries the dead loads.
    bool loads_are_carried(const State &state) const;

    double broken_part_of_energy(const State &state) const;

    /// Why the run has ended, with the load at failure.
    std::string end_in_words() const;


    void write_fields(const State &state, unsigned int step);

    void write_fields_when_due(const State &state);

    Summary summarize(const RunOutcome &outcome, const RunTotals &cost);

    /// On the force boundary, with thickness; N.
    dealii::Tensor<1, dim> force(const State &state) const;

    double smallest_phase_field(const State &state) const;

    /// Of cells that adaptation has refined as far as it may; mm.
    double cell_size_at_cracks() const;

    void log_header();

    void collect_warnings();

    /// When it is another one than before.
    void log_linear_solver();

    void log_end(const RunOutcome &outcome, const Summary &summary);

    void log_step(const StatisticsRow &row);

    ImbalanceRule imbalance_rule() const;

    /// Warn when the last step is not balanced.
    void check_energy_balance();

    /// On where there is damage, or ""; see damage_in_words(). Collective.
    std::string damage_warning();

    /// Say it once. Collective.
    void check_damage();

    const Parameters<dim> &parameters;
    const std::string      effective_parameters;
    const CaseSignature    signature;
    const MPI_Comm         communicator;
    Log                   &log;
    dealii::TimerOutput    timer;
    dealii::Timer          wall_clock;
    StopPoll               stop_poll;

    dealii::parallel::distributed::Triangulation<dim> triangulation;
    double                                            cell_size = 0.; // mm
    std::unique_ptr<Material<dim>>                    material;
    std::unique_ptr<const MaterialField<dim>>         material_field;
    MaterialRange                                     material_range{};
    Fields<dim>                                       fields;
    Constraints<dim>                                  constraints;
    std::unique_ptr<Assembler<dim>>                   assembler;
    std::unique_ptr<ElasticStep<dim>>                 elastic_step;
    std::unique_ptr<PhaseFieldStep<dim>>              phase_field_step;
    std::unique_ptr<StepSolver<dim>>                  step_solver;
    FixedPhaseField                                   fixed_phase_field;
    LoadControl                                       load_control;

    BoundaryQuantities<dim>  boundary_quantities;
    CrackObserver<dim>       crack_observer;
    CrackPathWriter<dim>     crack_path_writer;
    CrackOpening<dim>        crack_opening;
    CrackOpeningFile<dim>    crack_opening_file;
    PointDisplacements<dim>  point_displacements;
    SlitOverlap<dim>         slit_overlap;
    StatisticsTable          statistics;
    FieldOutput<dim>         field_output;
    double                   external_work = 0.; // mJ
    Checkpoint<dim>          checkpoint;
    std::optional<RunRecord> resumed;
    RunTotals                earlier;           // pieces of the run
    bool                     had_ended = false; // before it was resumed
    State                    peak_state; // its fields; without a reaction
    unsigned int             peak_step = 0;
    RunEnd                   run_end   = RunEnd::none;
    std::string              why_failed; // behind the words for the end
    unsigned int             n_refinements   = 0; // of the mesh, in all
    bool                     damage_is_known = false;
    std::string              case_in_words;
    std::string              linear_solver_in_words;
    std::vector<std::string> warnings;

    std::optional<ExistingRun> waiting_output; // see prepare_output()
    /// the first mesh, when `--check` has not built it
    std::optional<MeshEstimate> not_built;
    unsigned int                n_overlapping_steps = 0;
    double                      deepest_overlap     = 0.; // mm
    std::string                 overlap_in_words;
  };
} // namespace MixedCracks

#endif
