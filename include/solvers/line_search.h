// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_line_search_h
#define mixed_cracks_solvers_line_search_h

#include <solvers/newton.h>

namespace MixedCracks
{
  /// What a line search came to; the same on every rank.
  struct SearchOutcome
  {
    bool         found  = false; ///< otherwise the iterate is where it was
    double       factor = 0.;    ///< of the correction; negative: against it
    ResidualSize size;           ///< of the residual that is kept
    bool         met_barrier = false; ///< a trial was not admissible
  };

  /// Along the correction of a problem with NewtonProblem::is_admissible: the
  /// first of 1, 1/2, 1/4, ... that leads to an admissible iterate whose
  /// residual is smaller or whose potential has fallen enough (Armijo). Against
  /// the correction where the potential grows along it. @p before: of the
  /// iterate. Collective.
  SearchOutcome guarded_line_search(const NewtonProblem &problem,
                                    const NewtonOptions &options,
                                    const ResidualSize  &before);
} // namespace MixedCracks

#endif
