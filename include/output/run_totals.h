// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_run_totals_h
#define mixed_cracks_output_run_totals_h

#include <map>
#include <string>

namespace MixedCracks
{
  /// What a run has cost, over all pieces it was continued in.
  struct RunTotals
  {
    unsigned int factorizations = 0; ///< of the matrix of the elastic fields
    unsigned int solves         = 0; ///< with it
    unsigned int rejected_steps = 0;
    double       wall_time      = 0.; ///< s
    /// seconds spent in each phase, the largest over the ranks of a piece
    std::map<std::string, double> phases;
  };

  /// The costs of two pieces together.
  RunTotals operator+(const RunTotals &one, const RunTotals &other);
} // namespace MixedCracks

#endif
