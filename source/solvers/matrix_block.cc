// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/base/exceptions.h>

#include <Epetra_Import.h>
#include <Epetra_IntVector.h>
#include <Epetra_Map.h>
#include <Epetra_Vector.h>
#include <solvers/matrix_block.h>

#include <algorithm>

namespace MixedCracks
{
  using dealii::ExcMessage;

  namespace
  {
    // Of each column of a matrix: the number it has in the block on the rank
    // that owns it, -1 if it is left out.
    Epetra_IntVector
    numbers_in_block(const Epetra_CrsMatrix  &matrix,
                     const Epetra_Map        &block_columns,
                     const std::vector<bool> &chosen)
    {
      Epetra_IntVector owned(matrix.DomainMap());
      for (int column = 0, next = 0; column < owned.MyLength(); ++column)
        owned[column] = chosen[column] ? block_columns.GID(next++) : -1;
      Epetra_IntVector numbers(matrix.ColMap());
      if (const Epetra_Import *importer = matrix.Importer())
        numbers.Import(owned, *importer, Insert);
      else
        numbers = owned;
      return numbers;
    }



    // Replaces the numbers in the block by those among the columns that this
    // rank has entries in, in the order of the matrix, and returns their map.
    Epetra_Map
    number_columns(Epetra_IntVector &numbers, const Epetra_Comm &communicator)
    {
      std::vector<int> global;
      for (int column = 0; column < numbers.MyLength(); ++column)
        if (numbers[column] >= 0)
        {
          global.push_back(numbers[column]);
          numbers[column] = global.size() - 1;
        }
      return Epetra_Map(-1, global.size(), global.data(), 0, communicator);
    }



    Epetra_Map
    map_of(const std::vector<bool> &chosen, const Epetra_Comm &communicator)
    {
      const int n_owned = std::count(chosen.begin(), chosen.end(), true);
      return Epetra_Map(-1, n_owned, 0, communicator);
    }
  } // namespace



  // A_RC of the rows R and columns C, renumbered: what ML wants is a matrix of
  // its own with the nodes of one rank behind those of the rank before. Columns
  // of other ranks are found by sending their numbers in the block along the
  // import of A.
  std::unique_ptr<Epetra_CrsMatrix>
  extract_block(const Epetra_CrsMatrix  &matrix,
                const std::vector<bool> &rows,
                const std::vector<bool> &columns)
  {
    const Epetra_Map block_rows    = map_of(rows, matrix.Comm());
    const Epetra_Map block_columns = map_of(columns, matrix.Comm());
    Epetra_IntVector numbers = numbers_in_block(matrix, block_columns, columns);
    const Epetra_Map present = number_columns(numbers, matrix.Comm());

    int    *starts, *indices;
    double *values;
    AssertThrow(matrix.ExtractCrsDataPointers(starts, indices, values) == 0,
                ExcMessage("the matrix is not compressed"));
    std::vector<int> lengths;
    for (int row = 0; row < matrix.NumMyRows(); ++row)
      if (rows[row])
        lengths.push_back(std::count_if(
          indices + starts[row],
          indices + starts[row + 1],
          [&](const int column) { return numbers[column] >= 0; }));
    auto block = std::make_unique<Epetra_CrsMatrix>(
      Copy, block_rows, present, lengths.data(), true);
    std::vector<int>    found;
    std::vector<double> found_values;
    for (int row = 0, next = 0; row < matrix.NumMyRows(); ++row)
      if (rows[row])
      {
        found.clear();
        found_values.clear();
        for (int k = starts[row]; k < starts[row + 1]; ++k)
          if (numbers[indices[k]] >= 0)
          {
            found.push_back(numbers[indices[k]]);
            found_values.push_back(values[k]);
          }
        block->InsertMyValues(
          next++, found.size(), found_values.data(), found.data());
      }
    block->FillComplete(block_columns, block_rows);
    block->OptimizeStorage();
    return block;
  }



  void
  multiply(const Epetra_CrsMatrix &matrix,
           double                 *result,
           const double           *source,
           const bool              transposed)
  {
    const Epetra_Map &from =
      transposed ? matrix.RangeMap() : matrix.DomainMap();
    const Epetra_Map &to = transposed ? matrix.DomainMap() : matrix.RangeMap();
    const Epetra_Vector in(View, from, const_cast<double *>(source));
    Epetra_Vector       out(View, to, result);
    const int           error = matrix.Multiply(transposed, in, out);
    AssertThrow(error == 0, ExcMessage("a product with a matrix failed"));
  }
} // namespace MixedCracks
