// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_recording_h
#define mixed_cracks_simulation_recording_h

#include <output/energy_balance.h>
#include <output/recorder.h>
#include <output/run_log.h>

#include <simulation/body.h>

namespace MixedCracks
{
  // What the .prm says of what is to be recorded, for the room output.

  template <int dim>
  RecorderOptions<dim> recorder_options(const Parameters<dim> &parameters);

  template <int dim>
  RunLogOptions run_log_options(const Parameters<dim> &parameters);

  /// When its material is known.
  template <int dim>
  ImbalanceRule imbalance_rule(const Body<dim> &body);

  /// See output/run_directory.h.
  template <int dim>
  std::vector<std::string> files_of_run(const Parameters<dim> &parameters);
} // namespace MixedCracks

#endif
