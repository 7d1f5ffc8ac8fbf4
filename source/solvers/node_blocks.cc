// SPDX-License-Identifier: GPL-2.0-or-later
// y = A x with A in blocks of nodes, d = 2 or 3 unknowns each:
//
//   y_I = sum over nodes J of  A_IJ x_J,      A_IJ in R^(d x d)
//
// A product reads each entry once, so that its time is that of the memory: 12
// bytes per entry in the rows of Epetra, 5 to 5.8 here (one index per block,
// and in space a fourth row of zeros, for four entries of a column are one
// register). x, y and the sums are in double precision: the product is linear
// to all digits, which GMRES with a fixed preconditioner relies on, and A
// differs from what it was copied from by 2^-24 = 6e-8 of each entry.

#include <base/lanes.h>

#include <solvers/node_blocks.h>

#include <algorithm>

namespace MixedCracks
{
  namespace
  {
    struct Rows
    {
      int                n_nodes;
      const std::size_t *starts;
      const int         *columns;
      const float       *entries;
    };

    // in space: a column of a block is one register
    inline __attribute__((always_inline)) void
    multiply_3(const Rows &rows, double *result, const double *source)
    {
      const float *entries = rows.entries;
      for (int node = 0; node < rows.n_nodes; ++node)
      {
        Doubles sums[3] = {};
        for (std::size_t k = rows.starts[node]; k < rows.starts[node + 1]; ++k)
        {
          const double *x = source + 3 * rows.columns[k];
          for (unsigned int d = 0; d < 3; ++d, entries += 4)
          {
            const Floats column = load<Floats>(entries);
            sums[d] += __builtin_convertvector(column, Doubles) * x[d];
          }
        }
        const Doubles sum = sums[0] + sums[1] + sums[2];
        for (unsigned int d = 0; d < 3; ++d)
          result[3 * node + d] = sum[d];
      }
    }



    // in the plane: a block is one register
    inline __attribute__((always_inline)) void
    multiply_2(const Rows &rows, double *result, const double *source)
    {
      const float *entries = rows.entries;
      for (int node = 0; node < rows.n_nodes; ++node)
      {
        Doubles sum = {};
        for (std::size_t k = rows.starts[node]; k < rows.starts[node + 1]; ++k)
        {
          const double *x     = source + 2 * rows.columns[k];
          const Floats  block = load<Floats>(entries);
          entries += 4;
          sum += __builtin_convertvector(block, Doubles) *
                 Doubles{x[0], x[0], x[1], x[1]};
        }
        result[2 * node]     = sum[0] + sum[2];
        result[2 * node + 1] = sum[1] + sum[3];
      }
    }



    inline __attribute__((always_inline)) void
    multiply(const int     n_components,
             const Rows   &rows,
             double       *result,
             const double *source)
    {
      n_components == 2 ? multiply_2(rows, result, source)
                        : multiply_3(rows, result, source);
    }



    // the same for processors that have it
    MIXED_CRACKS_FOR_AVX2 void
    multiply_avx2(const int     n_components,
                  const Rows   &rows,
                  double       *result,
                  const double *source)
    {
      multiply(n_components, rows, result, source);
    }
  } // namespace



  NodeBlocks::NodeBlocks(const Epetra_CrsMatrix &matrix,
                         const unsigned int      n_components)
    : n_components(n_components)
    , n_nodes(matrix.NumMyRows() / n_components)
  {
    copy_entries(matrix, find_columns(matrix));
  }



  // Of each column of the matrix its place among the entries that this rank
  // has: the owned ones, then all of the nodes of other ranks.
  std::vector<int>
  NodeBlocks::find_columns(const Epetra_CrsMatrix &matrix)
  {
    const Epetra_Map &owned = matrix.DomainMap(), &present = matrix.ColMap();
    std::vector<int>  others;
    for (int column = 0; column < present.NumMyElements(); ++column)
      if (!owned.MyGID(present.GID(column)))
        others.push_back(present.GID(column) / n_components);
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    std::vector<int> all(owned.MyGlobalElements(),
                         owned.MyGlobalElements() + owned.NumMyElements());
    for (const int node : others)
      for (int d = 0; d < n_components; ++d)
        all.push_back(n_components * node + d);
    const Epetra_Map here(-1, all.size(), all.data(), 0, matrix.Comm());
    if (matrix.Comm().NumProc() > 1)
      importer = std::make_unique<Epetra_Import>(here, owned);
    source_here = std::make_unique<Epetra_Vector>(here);
    std::vector<int> places;
    for (int column = 0; column < present.NumMyElements(); ++column)
      places.push_back(here.LID(present.GID(column)));
    return places;
  }



  void
  NodeBlocks::copy_entries(const Epetra_CrsMatrix &matrix,
                           const std::vector<int> &places)
  {
    const int        columns_per_block = n_components;
    const int        rows_per_block    = n_components == 2 ? 2 : 4;
    const int        size              = columns_per_block * rows_per_block;
    std::vector<int> block_of(source_here->MyLength() / n_components, -1);
    starts.assign(1, 0);
    // about: entries of supports are not there
    const int n_blocks = matrix.NumMyNonzeros() / (n_components * n_components);
    columns.reserve(n_blocks);
    entries.reserve(static_cast<std::size_t>(size) * n_blocks);
    for (int node = 0; node < n_nodes; ++node)
    {
      for (int d = 0; d < n_components; ++d)
      {
        int     length, *indices;
        double *values;
        matrix.ExtractMyRowView(
          n_components * node + d, length, values, indices);
        for (int k = 0; k < length; ++k)
        {
          const int place = places[indices[k]];
          int      &block = block_of[place / n_components];
          if (block < static_cast<int>(starts.back()))
          {
            block = columns.size();
            columns.push_back(place / n_components);
            entries.resize(entries.size() + size);
          }
          entries[size * static_cast<std::size_t>(block) +
                  rows_per_block * (place % n_components) + d] = values[k];
        }
      }
      starts.push_back(columns.size());
    }
  }



  void
  NodeBlocks::vmult(double *result, const double *source) const
  {
    if (importer)
    {
      const Epetra_Vector owned(
        View, importer->SourceMap(), const_cast<double *>(source));
      source_here->Import(owned, *importer, Insert);
      source = source_here->Values();
    }
    const Rows rows{n_nodes, starts.data(), columns.data(), entries.data()};
    if (has_avx2())
      multiply_avx2(n_components, rows, result, source);
    else
      multiply(n_components, rows, result, source);
  }
} // namespace MixedCracks
