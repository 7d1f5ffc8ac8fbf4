// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_core_collective_h
#define mixed_cracks_core_collective_h

#include <core/errors.h>

#include <deal.II/base/mpi.h>

namespace MixedCracks
{
  /// Run @p body, which must not communicate, and throw the InputError of one
  /// rank on every rank: an expression may fail on a single one, and the
  /// others would wait for it for ever. Collective.
  template <typename Body>
  void
  together(const MPI_Comm communicator, const Body &body)
  {
    std::string message;
    try
    {
      body();
    }
    catch (const InputError &error)
    {
      message = error.what();
    }
    namespace MPI              = dealii::Utilities::MPI;
    const unsigned int n       = MPI::n_mpi_processes(communicator);
    const unsigned int failing = MPI::min(
      message.empty() ? n : MPI::this_mpi_process(communicator), communicator);
    if (failing < n)
      throw InputError(MPI::broadcast(communicator, message, failing));
  }
} // namespace MixedCracks

#endif
