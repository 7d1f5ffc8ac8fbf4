// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_recorder_h
#define mixed_cracks_output_recorder_h

#include <cracks/crack_observer.h>

#include <base/phase_timer.h>

#include <output/boundary_quantities.h>
#include <output/checkpoint.h>
#include <output/crack_opening.h>
#include <output/crack_opening_file.h>
#include <output/crack_path_writer.h>
#include <output/crack_sheet_writer.h>
#include <output/event_table.h>
#include <output/field_output.h>
#include <output/measurement.h>
#include <output/parameters.h>
#include <output/point_displacements.h>
#include <output/point_reactions.h>
#include <output/slit_watch.h>
#include <output/statistics.h>
#include <output/summary.h>
#include <output/traction_profiles.h>
#include <output/watched_boundaries.h>

namespace MixedCracks
{
  /// What is to be recorded; the parameters must outlive the recorder.
  template <int dim>
  struct RecorderOptions
  {
    const OutputParameters                 &output;
    const CrackOpeningParameters<dim>      &crack_opening;
    const PointDisplacementParameters<dim> &points;
    const EventParameters                  &events;
    double                                  thickness; ///< mm; 1 in 3-d
    /// see BoundaryQuantities
    BoundaryIds                       force_boundary;
    bool                              finite_strain = false;
    std::vector<WatchedBoundary<dim>> watched{};
    /// see PointReactions
    std::vector<PrescribedPoint<dim>> held_points{};
    TractionProfileOptions            tractions{};
  };

  /// Keeps what a run is to leave behind: the rows of statistics.csv, cracks
  /// and openings, fields, the state of the largest force, and what all of it
  /// has cost, over all pieces of the run. It does not decide anything.
  /// Throws FileError on all ranks. Collective.
  template <int dim>
  class Recorder
  {
  public:
    Recorder(const Fields<dim>          &fields,
             const Constraints<dim>     &constraints,
             const RecorderOptions<dim> &options);

    /// When the first mesh is there. Throws InputError for a point that is to
    /// be watched and lies outside.
    void find_places();

    /// To be called when the mesh changed. @p length_scale: l, mm.
    void reinit(Assembler<dim> &assembler, double length_scale);

    /// What tells the loads on the boundaries that are watched.
    void
    take_loads_from(typename WatchedBoundaries<dim>::Loads loads)
    {
      watched_boundaries.set_loads(std::move(loads));
    }

    /// Begin statistics.csv.
    void open_statistics();

    /// Begin the files on cracks, when there is a state to record.
    void open_crack_files();

    /// Write anew what an earlier piece of the run has come to. @p state: its
    /// last.
    void restore(const RunRecord &record, const State &state);

    /// Those of the last state of an earlier piece, from which the next step
    /// counts how far they have come.
    void
    remember_cracks(const TracedCracks &cracks, const State &state)
    {
      crack_sheet_writer.remember(state.time, cracks.sheets);
    }

    /// On the force boundary, with thickness; N.
    dealii::Tensor<1, dim> force(const State &state) const;

    /// What a step has come to; nothing is kept of it. @p work: external work
    /// of the step, N. @p piece: what this piece of the run has cost so far;
    /// the clock is the recorder's own.
    StatisticsRow measure(const State      &state,
                          double            work,
                          const StepEffort &effort,
                          const RunTotals  &piece) const;

    /// Keep an accepted step.
    void add(const StatisticsRow &row, const State &state);

    /// Keep the state of that step, whose loads are carried, where its force is
    /// the largest so far.
    void keep_peak(const State &state);

    /// Look whether slits are closed too far: "" or a line for the log.
    std::string
    watch_slits(const State &state)
    {
      return slit_watch.watch(state);
    }

    /// Of the last step. @p state: where they were traced. Returns what has
    /// come to pass, in lines for the log, on rank 0.
    std::vector<std::string> add_cracks(const TracedCracks &cracks,
                                        const State        &state);

    /// Those of the last step, when it is their turn, an event has come in it
    /// or the run @p ends with it; those of the peak when the force has fallen.
    void write_fields_when_due(const State &state, bool ends);

    /// Those of the peak and of the last step, unless they are there.
    void write_last_fields(const State &state);

    /// All that a checkpoint has of it; writes fields that would be lost.
    void save(RunRecord &record);

    /// Of all pieces. @p piece without times, which come from the clock and
    /// @p timer.
    RunTotals totals(const RunTotals &piece, const PhaseTimer &timer) const;

    /// Close the crack paths and write summary.json.
    void finish(const Summary &summary);

    const std::vector<StatisticsRow> &
    rows() const
    {
      return statistics.rows();
    }

    /// The last accepted step.
    const StatisticsRow &
    last() const
    {
      return statistics.rows().back();
    }

    /// Those of earlier pieces.
    const RunTotals &
    earlier_totals() const
    {
      return earlier;
    }

    /// The state with the largest force, to be carried to a new mesh.
    State &
    peak_state()
    {
      return peak;
    }

    void
    note_refinement()
    {
      ++n_refinements;
    }

    const SlitWatch<dim> &
    slits() const
    {
      return slit_watch;
    }

    /// Entries of the .prm that ask for more quantities.
    std::vector<std::string> asked_quantities() const;

  private:
    void write_fields(const State &state, unsigned int step);

    void record_opening(const StatisticsRow &row, const State &state);

    const Fields<dim>         &fields;
    const Constraints<dim>    &constraints;
    const RecorderOptions<dim> options;
    Assembler<dim>            *assembler    = nullptr; // of reinit()
    double                     length_scale = 0.;      // mm

    BoundaryQuantities<dim> boundary_quantities;
    CrackPathWriter<dim>    crack_path_writer;
    CrackSheetWriter<dim>   crack_sheet_writer;
    EventTable              event_table;
    CrackOpening<dim>       crack_opening;
    CrackOpeningFile<dim>   crack_opening_file;
    TractionProfiles<dim>   traction_profiles;
    PointDisplacements<dim> point_displacements;
    WatchedBoundaries<dim>  watched_boundaries;
    PointReactions<dim>     point_reactions;
    SlitWatch<dim>          slit_watch;
    StatisticsTable         statistics;
    FieldOutput<dim>        field_output;

    dealii::Timer wall_clock;
    RunTotals     earlier;            // pieces of the run
    double        external_work = 0.; // mJ
    unsigned int  n_refinements = 0;  // of the mesh, in all
    double        peak_force    = 0.; // that was carried, N
    unsigned int  peak_step     = 0;
    State         peak; // its fields; without a reaction
  };
} // namespace MixedCracks

#endif
