// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/stop_request.h>

#include <deal.II/base/mpi.h>

#include <csignal>

namespace MixedCracks
{
  namespace
  {
    volatile std::sig_atomic_t requested = 0;

    void
    remember(int)
    {
      requested = 1;
    }
  } // namespace



  void
  listen_for_stop_requests()
  {
    for (const int signal : {SIGTERM, SIGINT, SIGUSR1})
      std::signal(signal, remember);
  }



  bool
  stop_requested(const MPI_Comm communicator)
  {
    return dealii::Utilities::MPI::max(static_cast<int>(requested),
                                       communicator) == 1;
  }
} // namespace MixedCracks
