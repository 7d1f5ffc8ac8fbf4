// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>

#include <deal.II/base/patterns.h>

#include <output/parameters.h>
#include <output/xdmf_output.h>

namespace MixedCracks
{
  namespace Patterns = dealii::Patterns;

  void
  OutputParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter("Directory",
                      directory,
                      "Everything a run writes goes there; it is made when it "
                      "does not exist, and refused when it holds a run "
                      "already.",
                      Patterns::Anything());
    prm.add_parameter("Fields every",
                      fields_every,
                      "Fields for ParaView are written every so many accepted "
                      "steps, and always at the start, at the peak of the "
                      "force, at separation, in the steps of Events and at the "
                      "end; 0: only then. Unit: 1.",
                      Patterns::Integer(0));
    prm.add_parameter("Field format",
                      field_format,
                      "'VTU': fields.pvd, one compressed file for each rank "
                      "and step; 'XDMF': fields.xdmf, one HDF5 file for each "
                      "step and one for each mesh, for large runs; 'both'; "
                      "'none': no fields at all, for sweeps of which only "
                      "curves, paths and tables are wanted. The scripts that "
                      "draw pictures read VTU.",
                      Patterns::Selection("VTU|XDMF|both|none"));
    prm.add_parameter("Checkpoint every",
                      checkpoint_every,
                      "A checkpoint to continue from with --resume is written "
                      "every so many accepted steps, and of the last state "
                      "whenever the run ends, for whatever reason; 0: only "
                      "then. Unit: 1.",
                      Patterns::Integer(0));
    prm.add_parameter("Energy imbalance tolerance",
                      energy_imbalance_tolerance,
                      "The log warns of a load step in which the external work "
                      "differs from the growth of stored and crack energy by "
                      "more than this, relative to the external work so far, "
                      "or to the stored energy where that is larger; steps in "
                      "which no crack ran are among the warnings of "
                      "summary.json, too. 0: off. Unit: 1.",
                      Patterns::Double(0.));
    prm.add_parameter("Wall time limit",
                      wall_time_limit,
                      "The run stops with a checkpoint and exit status 5 in "
                      "good time before this one is over, counted from the "
                      "start of the process: when the longest load step and "
                      "the longest writing of a checkpoint so far would not "
                      "fit into the rest. A resumed run that finishes no load "
                      "step before ends with exit status 3, for with this "
                      "limit it never will. 0: no limit. Unit: s.",
                      Patterns::Double(0.));
    prm.leave_subsection();
  }



  void
  OutputParameters::check() const
  {
    if (directory.empty())
      throw InputError("Output/Directory: found nothing, allowed is the name "
                       "of a directory.");
    const bool needs_hdf5 = field_format == "XDMF" || field_format == "both";
    if (needs_hdf5 && !has_hdf5())
      throw InputError("Output/Field format: found '" + field_format +
                       "', which needs a deal.II that was built with HDF5; "
                       "this one was not. Allowed: VTU, none.");
  }
} // namespace MixedCracks
