// SPDX-License-Identifier: GPL-2.0-or-later
// A_ij += local_ij for all i, j of a cell. The general way looks up every j in
// every row i, by its global number. Here the columns are those of this rank,
// and the d components of a node follow each other in each row: one search per
// pair of nodes finds d^2 entries.

#include <assembly/cell_sums.h>

#include <deal.II/base/exceptions.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  void
  CellSums::reinit(LinearAlgebra::SparseMatrix     &new_matrix,
                   std::vector<Indices>             new_cells,
                   const AffineConstraints<double> &new_constraints,
                   const unsigned int               new_n_components)
  {
    matrix       = &new_matrix;
    constraints  = &new_constraints;
    n_components = new_n_components;
    cells        = std::move(new_cells);
    int *of_rows = nullptr, *of_columns = nullptr;
    AssertThrow(matrix->trilinos_matrix().ExtractCrsDataPointers(
                  of_rows, of_columns, entries) == 0,
                ExcMessage("the matrix is not compressed"));
    starts                 = of_rows;
    columns                = of_columns;
    const Epetra_Map &rows = matrix->trilinos_matrix().RowMap();
    simple.clear();
    for (Indices &cell : cells)
    {
      simple.push_back(is_simple(cell));
      if (!simple.back())
        continue;
      for (unsigned int a = 0; n_components * a < cell.size(); ++a)
        cell[a] = rows.LID(static_cast<int>(cell[n_components * a]));
      cell.resize(cell.size() / n_components);
    }
  }



  void
  CellSums::set_zero()
  {
    const int n_rows = matrix->trilinos_matrix().NumMyRows();
    std::fill(entries, entries + starts[n_rows], 0.);
  }



  bool
  CellSums::is_simple(const Indices &cell) const
  {
    const Epetra_Map &rows    = matrix->trilinos_matrix().RowMap();
    const Epetra_Map &columns = matrix->trilinos_matrix().ColMap();
    for (unsigned int i = 0; i < cell.size(); ++i)
    {
      const int number = cell[i];
      const int row    = rows.LID(number);
      if (row < 0 || row != columns.LID(number) ||
          cell[i] != cell[i - i % n_components] + i % n_components ||
          constraints->is_constrained(cell[i]))
        return false;
    }
    return true;
  }



  void
  CellSums::add(const unsigned int cell, const FullMatrix<double> &local)
  {
    if (simple[cell])
      add_simple(cells[cell], local);
    else
      constraints->distribute_local_to_global(local, cells[cell], *matrix);
  }



  void
  CellSums::add_simple(const Indices &cell, const FullMatrix<double> &local)
  {
    const unsigned int d = n_components;
    for (unsigned int a = 0; a < cell.size(); ++a)
      for (unsigned int b = 0; b < cell.size(); ++b)
      {
        const int first = cell[b];
        // the rows of a node have the same columns, nearly everywhere
        std::ptrdiff_t offset = -1;
        for (unsigned int i = 0; i < d; ++i)
        {
          const int *row = columns + starts[cell[a] + i];
          const int *end = columns + starts[cell[a] + i + 1];
          if (offset < 0 || offset >= end - row || row[offset] != first)
            offset = std::lower_bound(row, end, first) - row;
          Assert(row[offset] == first &&
                   row[offset + d - 1] == first + static_cast<int>(d) - 1,
                 ExcInternalError());
          double       *to   = entries + starts[cell[a] + i] + offset;
          const double *from = &local(d * a + i, d * b);
          for (unsigned int j = 0; j < d; ++j)
            to[j] += from[j];
        }
      }
  }
} // namespace MixedCracks
