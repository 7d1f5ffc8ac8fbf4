// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_matrix_block_h
#define mixed_cracks_solvers_matrix_block_h

#include <Epetra_CrsMatrix.h>

#include <memory>
#include <vector>

namespace MixedCracks
{
  /// The owned rows of a square @p matrix that have @p rows set, and the
  /// columns that have @p columns set, both renumbered without gaps: a copy
  /// with values of its own. Collective.
  std::unique_ptr<Epetra_CrsMatrix>
  extract_block(const Epetra_CrsMatrix  &matrix,
                const std::vector<bool> &rows,
                const std::vector<bool> &columns);

  /// @p result = @p matrix * @p source, or with its transpose, owned entries
  /// only. Collective.
  void multiply(const Epetra_CrsMatrix &matrix,
                double                 *result,
                const double           *source,
                bool                    transposed = false);
} // namespace MixedCracks

#endif
