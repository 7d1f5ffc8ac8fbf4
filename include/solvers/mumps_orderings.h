// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_mumps_orderings_h
#define mixed_cracks_solvers_mumps_orderings_h

#include <string>

namespace MixedCracks
{
  /// What MUMPS takes for one of Mumps::orderings(), ICNTL(7).
  int mumps_number_of(const std::string &ordering);

  /// The name of what it has used, INFOG(7).
  std::string mumps_ordering_of(int number);

  /// The number of an ordering that is handed to MUMPS: nested dissection by
  /// METIS, which is called by that name.
  constexpr int mumps_given_ordering = 1;
} // namespace MixedCracks

#endif
