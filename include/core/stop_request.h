// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_core_stop_request_h
#define mixed_cracks_core_stop_request_h

#include <mpi.h>

namespace MixedCracks
{
  /// From now on SIGTERM, SIGINT and SIGUSR1 ask the run to stop in order,
  /// rather than ending it.
  void listen_for_stop_requests();

  /// Whether any rank was asked to stop. Collective.
  bool stop_requested(MPI_Comm communicator);
} // namespace MixedCracks

#endif
