// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_run_archive_h
#define mixed_cracks_simulation_run_archive_h

#include <cracks/crack_observer.h>

#include <input/case_signature.h>

#include <output/recorder.h>

#include <simulation/body.h>
#include <simulation/run_ending.h>
#include <simulation/run_stop.h>

#include <steps/load_control.h>

#include <optional>

namespace MixedCracks
{
  /// What connects the pieces of a run: writes checkpoints, and begins with
  /// one. Throws FileError. Collective.
  template <int dim>
  class RunArchive
  {
  public:
    /// @p signature: the parts of the .prm that a resumed run looks at.
    RunArchive(const CaseSignature &signature,
               Body<dim>           &body,
               CrackObserver<dim>  &crack_observer,
               LoadControl         &load_control,
               Recorder<dim>       &recorder,
               RunStop             &stop,
               PhaseTimer          &timer,
               Log                 &log)
      : signature(signature)
      , body(body)
      , crack_observer(crack_observer)
      , load_control(load_control)
      , recorder(recorder)
      , stop(stop)
      , timer(timer)
      , log(log)
      , checkpoint(body.parameters.output.directory, body.communicator())
    {}

    /// Find the newest checkpoint. Throws InputError when the case is another
    /// one. An expression that has ended the run may be another one: that is
    /// noted.
    void read();

    /// What is to be known of the earlier pieces: a checkpoint that is damaged,
    /// loads that were mended on the way.
    std::vector<std::string> warnings() const;

    /// Whether there is an earlier piece of the run: after read().
    bool
    is_resumed() const
    {
      return resumed.has_value();
    }

    /// The mesh, of the earlier piece.
    void
    restore_body()
    {
      body.restore(checkpoint, resumed->cell_size);
    }

    /// The last state of the earlier piece, when everything lives on its mesh;
    /// load control goes on from there. No file of the run is touched.
    State load_state();

    /// Write anew what that piece has recorded, when its files are open.
    void restore_records(const State &state);

    /// Whether the parameters of now let a resumed run go on from that state.
    RunEnding ending(const State &state);

    /// @p cost: of all pieces so far.
    void
    write(const State &state, const RunEnding &ending, const RunTotals &cost);

  private:
    void mend_case();

    const CaseSignature      signature;
    Body<dim>               &body;
    CrackObserver<dim>      &crack_observer;
    LoadControl             &load_control;
    Recorder<dim>           &recorder;
    RunStop                 &stop;
    PhaseTimer              &timer;
    Log                     &log;
    Checkpoint<dim>          checkpoint;
    std::optional<RunRecord> resumed;
    std::string              damage; // of the newest checkpoint, in words
  };
} // namespace MixedCracks

#endif
