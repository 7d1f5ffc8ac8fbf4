// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_simulation_h
#define mixed_cracks_simulation_simulation_h

#include <output/run_directory.h>

#include <simulation/preflight.h>
#include <simulation/run_archive.h>
#include <simulation/trial_step.h>

namespace MixedCracks
{
  /// The driver: owns the objects of the other rooms and runs the algorithm.
  ///
  ///   preflight     mesh, material, expressions; what the log says beforehand
  ///   first state   new: step 0, phi relaxed around slits and initial cracks
  ///                 resumed: read from the checkpoint
  ///   until an end  TrialStep tries a step, LoadControl judges it:
  ///                   accept   it is recorded, then becomes the accepted state
  ///                   repeat   with a smaller step, from the same state
  ///                   onset, give up   the run ends with the accepted state
  ///   finish        fields, checkpoint, summary: whatever has ended the run
  ///
  /// A directory that holds an earlier run is not touched before the new one
  /// has its first state, or has failed at it: a case that is refused leaves it
  /// as it was. An empty one is opened at once.
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
    /// Open the files of the run unless they are open.
    void
    open_output()
    {
      if (directory.open())
        recorder.open_statistics();
    }

    /// That of a resumed run, or the initial one.
    State first_state();
    State initial_state();

    /// Steps until the end. An error that is not of a file is thrown when the
    /// last accepted state is safe.
    void advance_to_the_end(State &accepted);

    /// Try a step.
    void advance(State &accepted);

    /// Keep an accepted step, and see whether the run ends with it.
    void record(const StatisticsRow &row, const State &state);

    /// Fields and a checkpoint of the last state, and the summary.
    RunOutcome finish(const State &last, const RunOutcome &outcome);

    const Parameters<dim> &parameters;
    Log                   &log;
    PhaseTimer             timer;
    RunStop                stop;
    Body<dim>              body;
    MeshAdaptation<dim>    adaptation;
    CrackObserver<dim>     crack_observer;
    LoadControl            load_control;
    Preflight<dim>         before_the_run;
    RunDirectory           directory;
    Recorder<dim>          recorder;
    RunLog                 run_log;
    RunArchive<dim>        archive;
    RunEnding              ending;

    std::unique_ptr<TrialStep<dim>> trial_step; // needs a material
  };
} // namespace MixedCracks

#endif
