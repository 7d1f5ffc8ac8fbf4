// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_nested_dissection_h
#define mixed_cracks_solvers_nested_dissection_h

#include <solvers/linear_solver.h>

#include <vector>

namespace MixedCracks
{
  /// False where the program was built without METIS.
  bool nested_dissection_is_available();

  /// An order of elimination by nested dissection (METIS_NodeND): halves first,
  /// what separates them last, and so on within the halves. @p positions: on
  /// rank 0 the place of each unknown in that order, counted from 0; empty on
  /// the other ranks and without success. Collective. Needs 4 bytes per unknown
  /// of the whole on each rank; for rank 0 see the implementation.
  LinearOutcome nested_dissection(const LinearAlgebra::SparseMatrix &matrix,
                                  MatrixSymmetry                     symmetry,
                                  std::vector<int>                  &positions);
} // namespace MixedCracks

#endif
