// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_single_process_h
#define mixed_cracks_base_single_process_h

#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// Whether an environment ("NAME=value" each) is that of a process which a
  /// launcher of MPI programs has started (mpirun, srun, flux, jsrun, …), or
  /// may be: a name that only hints at one counts, too.
  bool has_launcher(const std::vector<std::string> &environment);

  /// Variables, names and values, for Open MPI: no shared file pointers; where
  /// all ranks are on this machine no look for Omni-Path; where this process is
  /// the only one no daemon beside it, no look at any network, and no temporary
  /// files that others of its kind would share and remove. Without those that
  /// @p environment has already.
  std::vector<std::pair<std::string, std::string>>
  single_process_settings(const std::vector<std::string> &environment);

  /// Put these settings into the environment of this process, and tell whether
  /// it is a single one. To be called before MPI_Init; other implementations of
  /// MPI ignore them.
  bool prepare_single_process();
} // namespace MixedCracks

#endif
