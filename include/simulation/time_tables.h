// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_time_tables_h
#define mixed_cracks_simulation_time_tables_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

namespace MixedCracks
{
  /// Read the files of all table("...") in @p prm, before any expression with
  /// one is made. Throws FileError, with the line, on all ranks. Collective.
  void read_time_tables(const dealii::ParameterHandler &prm,
                        MPI_Comm communicator = MPI_COMM_WORLD);

  /// Throws InputError for a table that ends before @p end_time (s).
  void require_time_tables_until(double                          end_time,
                                 const dealii::ParameterHandler &prm);
} // namespace MixedCracks

#endif
