// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_core_case_signature_h
#define mixed_cracks_core_case_signature_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <string>

namespace MixedCracks
{
  /// "Subsection/Entry = value" lines of the entries that make up a case, and
  /// hence must not change when a run is resumed: all but those on load
  /// steps, solvers and output, except for points that are watched. An entry
  /// "File name" is followed by a checksum of what the file holds. Collective;
  /// the first rank reads the files.
  std::string case_signature(const dealii::ParameterHandler &prm,
                             MPI_Comm communicator = MPI_COMM_WORLD);

  /// Throws InputError with the first difference when @p now is not the case
  /// that @p before is of.
  void require_same_case(const std::string &before, const std::string &now);
} // namespace MixedCracks

#endif
