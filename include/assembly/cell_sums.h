// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_cell_sums_h
#define mixed_cracks_assembly_cell_sums_h

#include <base/linear_algebra.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace MixedCracks
{
  /// Adds the matrices of cells to a sparse matrix, as
  /// AffineConstraints::distribute_local_to_global() does, which it leaves the
  /// cells to that have constrained unknowns or rows of other ranks. In all
  /// others an entry is found once for the components of a pair of nodes.
  class CellSums
  {
  public:
    using Indices = std::vector<dealii::types::global_dof_index>;

    /// @p matrix: with its pattern, compressed. @p cells: the unknowns of each
    /// cell, those of a node one after the other, @p n_components of them.
    /// Matrix and constraints are kept by reference.
    void reinit(LinearAlgebra::SparseMatrix             &matrix,
                std::vector<Indices>                     cells,
                const dealii::AffineConstraints<double> &constraints,
                unsigned int                             n_components);

    /// All entries become zero. As rows of other ranks are since compress(),
    /// nothing is sent, which dealii's operator= would do.
    void set_zero();

    /// Add the matrix of a cell. compress() of the sparse matrix is up to the
    /// caller.
    void add(unsigned int cell, const dealii::FullMatrix<double> &local);

  private:
    /// whether its unknowns are all owned and free, and follow each other
    bool is_simple(const Indices &cell) const;

    void add_simple(const Indices                    &cell,
                    const dealii::FullMatrix<double> &local);

    LinearAlgebra::SparseMatrix             *matrix       = nullptr;
    const dealii::AffineConstraints<double> *constraints  = nullptr;
    unsigned int                             n_components = 1;
    /// of simple cells the first rows of their nodes, on this rank; of the
    /// others all unknowns
    std::vector<Indices> cells;
    std::vector<bool>    simple;
    /// the rows of this rank, as Epetra has them
    const int *starts = nullptr, *columns = nullptr;
    double    *entries = nullptr;
  };
} // namespace MixedCracks

#endif
