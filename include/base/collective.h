// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_collective_h
#define mixed_cracks_base_collective_h

#include <base/errors.h>

#include <deal.II/base/mpi.h>

namespace MixedCracks
{
  /// Run @p body, which must not communicate, and throw the InputError of one
  /// rank on every rank: an expression may fail on a single one, and the
  /// others would be in a deadlock. Collective.
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

  /// Throw a FileError with @p message on every rank when it is not empty on
  /// rank 0. Collective.
  inline void
  throw_on_all_ranks(const std::string &message, const MPI_Comm communicator)
  {
    const std::string everywhere =
      dealii::Utilities::MPI::broadcast(communicator, message, 0);
    if (!everywhere.empty())
      throw FileError(everywhere);
  }

  /// Whether all ranks have called this within @p seconds: after a failure that
  /// may have come to one rank only, while the others still wait for it. Where
  /// they do, no more collective calls are possible.
  inline bool
  all_ranks_arrive(const MPI_Comm communicator, const double seconds)
  {
    MPI_Request request;
    MPI_Ibarrier(communicator, &request);
    int          here  = 0;
    const double start = MPI_Wtime();
    while (here == 0 && MPI_Wtime() - start < seconds)
      MPI_Test(&request, &here, MPI_STATUS_IGNORE);
    return here != 0;
  }
} // namespace MixedCracks

#endif
