// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_block_product_h
#define mixed_cracks_solvers_block_product_h

// P^T A P on one rank in blocks: d rows per node, m columns per aggregate
// (galerkin_product.cc).

#include <base/lanes.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// Rows of blocks with m columns take so many entries: whole registers, the
  /// last ones zero.
  constexpr int
  padded(const int m)
  {
    constexpr int n = n_lanes;
    return (m + n - 1) / n * n;
  }



  /// Rows of P, for each block all m entries, those that ML leaves out, too.
  struct ProlongatorRows
  {
    std::vector<std::size_t> starts = {0};
    std::vector<int>         columns; // of blocks
    std::vector<double>      entries;
  };



  /// Sums of m x m blocks by row and column.
  template <int m>
  class BlockSums
  {
  public:
    explicit BlockSums(const int n_rows)
      : rows(n_rows)
    {}

    /// Its first entry; zero if it is new.
    double *
    entry(const int row, const int column)
    {
      auto      &list = rows[row];
      const auto found =
        std::lower_bound(list.begin(), list.end(), std::make_pair(column, 0));
      if (found != list.end() && found->first == column)
        return &entries[size * static_cast<std::size_t>(found->second)];
      list.insert(found, {column, static_cast<int>(entries.size() / size)});
      entries.resize(entries.size() + size);
      return &entries[entries.size() - size];
    }

    static constexpr int size = m * padded(m); // of a block
    /// of each row the columns, in order, and which block is there
    std::vector<std::vector<std::pair<int, int>>> rows;
    std::vector<double>                           entries;
  };



  /// The d rows of a node in P or A P, by blocks d x m.
  template <int d, int m>
  class NodeRow
  {
  public:
    explicit NodeRow(const int n_blocks)
      : places(n_blocks, -1)
    {}

    void
    clear()
    {
      for (const int column : columns)
        places[column] = -1;
      columns.clear();
      entries.clear();
    }

    /// Row i += factor * row of P.
    inline __attribute__((always_inline)) void
    add(const int              i,
        const double           factor,
        const ProlongatorRows &rows,
        const int              row)
    {
      for (std::size_t k = rows.starts[row]; k < rows.starts[row + 1]; ++k)
      {
        int &place = places[rows.columns[k]];
        if (place < 0)
        {
          place = columns.size();
          columns.push_back(rows.columns[k]);
          entries.resize(entries.size() + d * padded(m));
        }
        double       *to   = &entries[(d * place + i) * padded(m)];
        const double *from = &rows.entries[padded(m) * k];
        for (int j = 0; j < padded(m); j += n_lanes)
          store(load<Doubles>(to + j) + factor * load<Doubles>(from + j),
                to + j);
      }
    }

    std::vector<int>    columns;
    std::vector<double> entries;

  private:
    std::vector<int> places; // of columns, -1: not there
  };



  /// @p result += P^T A P for the owned rows of A; @p prolongator has a row for
  /// each of its columns. The other two are for use within.
  template <int d, int m>
  inline __attribute__((always_inline)) void
  multiply_blocks(const Epetra_CrsMatrix &matrix,
                  const ProlongatorRows  &prolongator,
                  NodeRow<d, m>          &of_node, // P
                  NodeRow<d, m>          &product, // A P
                  BlockSums<m>           &result)
  {
    for (int node = 0; node < matrix.NumMyRows() / d; ++node)
    {
      of_node.clear();
      product.clear();
      for (int i = 0; i < d; ++i)
      {
        int     length, *indices;
        double *values;
        matrix.ExtractMyRowView(d * node + i, length, values, indices);
        for (int k = 0; k < length; ++k)
          product.add(i, values[k], prolongator, indices[k]);
        of_node.add(i, 1., prolongator, d * node + i);
      }
      for (std::size_t b = 0; b < of_node.columns.size(); ++b)
        for (std::size_t c = 0; c < product.columns.size(); ++c)
        {
          const double *p = &of_node.entries[d * padded(m) * b];
          const double *t = &product.entries[d * padded(m) * c];
          double *to = result.entry(of_node.columns[b], product.columns[c]);
          for (int i = 0; i < m; ++i, to += padded(m))
            for (int j = 0; j < padded(m); j += n_lanes)
            {
              Doubles sum = load<Doubles>(to + j);
              for (int k = 0; k < d; ++k)
                sum +=
                  p[k * padded(m) + i] * load<Doubles>(t + k * padded(m) + j);
              store(sum, to + j);
            }
        }
    }
  }
} // namespace MixedCracks

#endif
