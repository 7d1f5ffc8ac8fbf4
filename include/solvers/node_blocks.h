// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_node_blocks_h
#define mixed_cracks_solvers_node_blocks_h

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_Map.h>
#include <Epetra_Vector.h>

#include <memory>
#include <vector>

namespace MixedCracks
{
  /// Products with a copy of a matrix whose entries are in single precision
  /// and in blocks, one per pair of nodes; vectors and sums in double
  /// precision. A fixed linear operator that differs from the matrix by
  /// 6e-8 of each entry: for preconditioners.
  class NodeBlocks
  {
  public:
    /// @p matrix: square, @p n_components (2 or 3) consecutive rows per node,
    /// all of them on one rank. Collective.
    NodeBlocks(const Epetra_CrsMatrix &matrix, unsigned int n_components);

    /// @p result = A @p source, owned entries only. Collective.
    void vmult(double *result, const double *source) const;

  private:
    std::vector<int> find_columns(const Epetra_CrsMatrix &matrix);
    void             copy_entries(const Epetra_CrsMatrix &matrix,
                                  const std::vector<int> &places);

    const int n_components;
    const int n_nodes;
    /// of each node's row its first block; of each block its node
    std::vector<std::size_t> starts;
    std::vector<int>         columns;
    /// of each block column after column, 4 x 3 or 2 x 2 entries
    std::vector<float> entries;
    /// owned entries, then those of other ranks
    std::unique_ptr<Epetra_Import>         importer;
    mutable std::unique_ptr<Epetra_Vector> source_here;
  };
} // namespace MixedCracks

#endif
