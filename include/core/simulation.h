// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_core_simulation_h
#define mixed_cracks_core_simulation_h

#include <core/parameters.h>
#include <core/simulation_material.h>
#include <core/simulation_setup.h>

#include <deal.II/distributed/tria.h>

#include <discretization/adaptation.h>

#include <output/checkpoint.h>
#include <output/crack_observer.h>
#include <output/crack_opening.h>
#include <output/crack_opening_file.h>
#include <output/directory.h>
#include <output/field_output.h>
#include <output/point_displacements.h>
#include <output/quantities.h>
#include <output/run_end.h>
#include <output/slit_overlap.h>
#include <output/statistics.h>
#include <output/summary.h>

#include <solvers/load_control.h>

#include <optional>

namespace MixedCracks
{
  /// How a run ended.
  struct RunOutcome
  {
    int         exit_status = 0; ///< as in doc/output.md
    std::string reason;
  };

  /// The hall: owns the rooms and runs the algorithm.
  template <int dim>
  class Simulation
  {
  public:
    /// @p effective_parameters: the complete .prm, to be kept with the
    /// results. @p signature: the part of it that a resumed run must share.
    /// The parameters have passed their checks and must outlive the
    /// simulation.
    Simulation(const Parameters<dim> &parameters,
               const std::string     &effective_parameters,
               const std::string     &signature,
               MPI_Comm               communicator,
               Log                   &log);

    /// Mesh, degrees of freedom and what can be said of them beforehand.
    void preflight();

    /// The whole calculation, into the output directory.
    RunOutcome run(ExistingRun existing);

  private:
    void make_mesh_and_material();

    void make_solvers();

    /// Everything that depends on the mesh, after it changed.
    void reinit_on_mesh();

    AdaptationRule adaptation_rule() const;

    /// Whether the phase field damages cells that are to be finer; sets the
    /// places.
    bool needs_finer_mesh(const LinearAlgebra::Vector &phase_field);

    void refine_initial_mesh();

    /// Refine around the places; the states are carried over.
    void refine(State &accepted, State &trial);

    void prepare_output(ExistingRun existing);

    State initial_state();

    /// Try steps until one is accepted, or there is no way on: then why.
    RunEnd advance(State &accepted);

    State resumed_state();

    void write_checkpoint(const State &state);

    bool stop_now() const;

    /// Predict the step, refine where the prediction damages coarse cells
    /// and correct it, until nothing is left to refine.
    StepOutcome solve_step(State &accepted, State &trial, double bound);

    void
    record(const State &before, const State &state, const StepOutcome &outcome);

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

    /// What is measured of open cracks.
    void record_opening(const State &state, StatisticsRow &row);

    void write_fields(const State &state, unsigned int step);

    void write_fields_when_due(const State &state);

    RunOutcome finish(const State &last);

    Summary summarize(const RunOutcome &outcome);

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

    /// Warn when the last step is not balanced.
    void check_energy_balance();

    const Parameters<dim> &parameters;
    const std::string      effective_parameters;
    const std::string      signature;
    const MPI_Comm         communicator;
    Log                   &log;
    dealii::TimerOutput    timer;
    dealii::Timer          wall_clock;

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
    AdaptationPlaces<dim>                             places; // to refine
    LoadControl                                       load_control;

    BoundaryQuantities<dim>  boundary_quantities;
    CrackObserver<dim>       crack_observer;
    CrackOpening<dim>        crack_opening;
    CrackOpeningFile<dim>    crack_opening_file;
    PointDisplacements<dim>  point_displacements;
    SlitOverlap<dim>         slit_overlap;
    StatisticsTable          statistics;
    FieldOutput<dim>         field_output;
    double                   external_work = 0.; // mJ
    Checkpoint<dim>          checkpoint;
    std::optional<RunRecord> resumed;
    State                    peak_state;
    unsigned int             peak_step          = 0;
    RunEnd                   run_end            = RunEnd::none;
    unsigned int             n_refinements      = 0; // of the mesh, in all
    unsigned int             n_imbalanced_steps = 0;
    std::string              case_in_words;
    std::string              linear_solver_in_words;
    std::vector<std::string> warnings;
    unsigned int             n_overlapping_steps = 0;
    double                   deepest_overlap     = 0.; // mm
    std::string              overlap_in_words;
  };
} // namespace MixedCracks

#endif
