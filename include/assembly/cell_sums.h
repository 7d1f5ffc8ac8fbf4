// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_cell_sums_h
#define mixed_cracks_assembly_cell_sums_h

#include <base/linear_algebra.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>

#include <map>
#include <vector>

namespace MixedCracks
{
  /// Adds the matrices of cells to a sparse matrix, as
  /// AffineConstraints::distribute_local_to_global() and compress() do. What
  /// depends on the mesh only is found out once: rows and columns of the cells,
  /// and which entries ranks send each other.
  class CellSums
  {
  public:
    using Indices     = std::vector<dealii::types::global_dof_index>;
    using Constraints = dealii::AffineConstraints<double>;

    /// @p matrix: with its pattern, compressed; kept by reference. @p cells:
    /// of each cell on this rank the unknowns, as many for all. @p constraints:
    /// homogeneous. Collective.
    void reinit(LinearAlgebra::SparseMatrix &matrix,
                const std::vector<Indices>  &cells,
                const Constraints           &constraints);

    /// All entries become zero.
    void set_zero();

    /// Add the matrix of a cell.
    void add(unsigned int cell, const dealii::FullMatrix<double> &local);

    /// What was added to rows of other ranks goes to them: once after each
    /// set_zero(). Collective.
    void finish();

  private:
    /// Rows one after the other, each with its columns in order.
    struct Rows
    {
      const int *starts, *columns;
      double    *entries;
    };

    /// Of unknown i of a cell: u_i = sum over r of weight v_r.
    struct Dependence
    {
      unsigned int i, r;
      double       weight;
    };

    /// A cell with constraints or with rows of other ranks. Row k of foreign
    /// is -1 - k here.
    struct SpecialCell
    {
      std::vector<int>          rows, columns; // of v, then of constrained
      std::vector<Dependence>   dependences;   // none: v is u
      std::vector<unsigned int> constrained;
    };

    /// Entries that go to another rank, or come from it.
    struct Message
    {
      unsigned int        rank;
      std::vector<int>    positions; // among the entries of foreign, or own
      std::vector<double> values;
    };

    bool is_plain(const Indices &cell, const Constraints &constraints) const;

    int row_of(dealii::types::global_dof_index unknown) const;
    int column_of(dealii::types::global_dof_index unknown);

    void find_foreign_rows(const std::vector<Indices> &unknowns);
    void find_messages(const Indices &foreign_columns);

    void add_rows(const int                        *rows,
                  const int                        *columns,
                  const dealii::FullMatrix<double> &local);

    LinearAlgebra::SparseMatrix *matrix = nullptr;
    unsigned int                 n      = 0; // unknowns of a cell

    /// Rows of this rank, as Epetra has them, and those of others that it adds
    /// to. Columns that only the latter have are numbered after the others.
    Rows                                           own, foreign;
    Indices                                        foreign_rows;
    std::vector<int>                               starts, columns;
    std::vector<double>                            entries;
    std::map<dealii::types::global_dof_index, int> further_columns;

    /// n for each cell: its rows, which are its columns, too. The first of
    /// special cell k is -1 - k.
    std::vector<int>         numbers;
    std::vector<SpecialCell> special_cells;
    std::vector<int>         offsets; // in the row before

    std::vector<Message> outgoing, incoming;
  };
} // namespace MixedCracks

#endif
