// SPDX-License-Identifier: GPL-2.0-or-later
// The matrix of the first coarse level of smoothed aggregation,
//
//   A_bc = sum over nodes I of  P_Ib^T T_Ic,    T_Ic = sum_J A_IJ P_Jc,
//
// b, c aggregates; A_IJ in R^(d x d) of two nodes, P_Ib in R^(d x m) of a node
// and an aggregate, m coarse functions per aggregate. ML looks for each entry
// of both products by itself and keeps A P, which is as large as A; here it is
// found for d m or m^2 entries at once, and T is of one node at a time. Of a
// hierarchy by ML that is the larger part.
//
// Ranks exchange rows as in ML: those of P that belong to nodes of others
// before, rows of A_bc for aggregates of others after it.

#include <base/lanes.h>

#include <Epetra_CrsMatrix.h>
#include <ml_include.h>
#include <ml_rap.h>
#include <solvers/galerkin_product.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace MixedCracks
{
  namespace
  {
    // Rows of P in groups, with all m entries of each block: of scalar rows
    // (group 1) or of nodes (group d). Blocks are d x m, row by row.
    struct BlockRows
    {
      std::vector<std::size_t> starts = {0};
      std::vector<int>         columns; // blocks
      std::vector<double>      entries;
    };



    BlockRows
    read_rows(ML_Operator &matrix,
              const int    n_rows,
              const int    group,
              const int    n_modes)
    {
      BlockRows result;
      const int size      = group * n_modes;
      int       allocated = 100, length;
      // ML enlarges them
      int *columns = static_cast<int *>(ML_allocate(allocated * sizeof(int)));
      double *values =
        static_cast<double *>(ML_allocate(allocated * sizeof(double)));
      for (int row = 0; row < n_rows; ++row)
      {
        ML_get_matrix_row(
          &matrix, 1, &row, &allocated, &columns, &values, &length, 0);
        const auto  first = result.columns.begin() + result.starts.back();
        std::size_t place = first - result.columns.begin();
        for (int k = 0; k < length; ++k)
        {
          const int block = columns[k] / n_modes;
          // most often that of the entry before
          if (place >= result.columns.size() || result.columns[place] != block)
            place = std::find(result.columns.begin() + result.starts.back(),
                              result.columns.end(),
                              block) -
                    result.columns.begin();
          if (place == result.columns.size())
          {
            result.columns.push_back(block);
            result.entries.resize(result.entries.size() + size);
          }
          result.entries[size * place + n_modes * (row % group) +
                         columns[k] % n_modes] = values[k];
        }
        if ((row + 1) % group == 0)
          result.starts.push_back(result.columns.size());
      }
      ML_free(columns);
      ML_free(values);
      return result;
    }



    // Numbers that no two unknowns of the coarse level have, on all ranks: of
    // the rows of the restriction here; divided by m of the blocks that P^T and
    // P have here, in order.
    struct Numbers
    {
      std::vector<int> of_rows, left, right;
    };



    int
    place_of(const int number, const std::vector<int> &numbers)
    {
      return std::lower_bound(numbers.begin(), numbers.end(), number) -
             numbers.begin();
    }



    // Replaces columns by their places among the different ones, in order.
    std::vector<int>
    number_without_gaps(std::vector<int> &columns)
    {
      std::vector<int> different = columns;
      std::sort(different.begin(), different.end());
      different.erase(std::unique(different.begin(), different.end()),
                      different.end());
      for (int &column : columns)
        column = place_of(column, different);
      return different;
    }



    // Sums of m x m blocks by row and column.
    template <int m>
    class BlockSums
    {
    public:
      explicit BlockSums(const int n_rows)
        : rows(n_rows)
      {}

      double *
      entry(const int row, const int column)
      {
        auto      &list = rows[row];
        const auto found =
          std::lower_bound(list.begin(), list.end(), std::make_pair(column, 0));
        if (found != list.end() && found->first == column)
          return &entries[m * m * static_cast<std::size_t>(found->second)];
        list.insert(found,
                    {column, static_cast<int>(entries.size() / (m * m))});
        entries.resize(entries.size() + m * m);
        return &entries[entries.size() - m * m];
      }

      // of each row the columns, and which block is there
      std::vector<std::vector<std::pair<int, int>>> rows;
      std::vector<double>                           entries;
    };



    // T of one node
    template <int d, int m>
    struct NodeRow
    {
      std::vector<int>    columns, places; // of columns, -1: not there
      std::vector<double> entries;
    };



    template <int d, int m>
    inline __attribute__((always_inline)) void
    add_products(const Epetra_CrsMatrix &matrix,
                 const BlockRows        &right,
                 const int               node,
                 NodeRow<d, m>          &sum)
    {
      for (const int column : sum.columns)
        sum.places[column] = -1;
      sum.columns.clear();
      sum.entries.clear();
      for (int i = 0; i < d; ++i)
      {
        int     length, *indices;
        double *values;
        matrix.ExtractMyRowView(d * node + i, length, values, indices);
        for (int k = 0; k < length; ++k)
          for (std::size_t block = right.starts[indices[k]];
               block < right.starts[indices[k] + 1];
               ++block)
          {
            int &place = sum.places[right.columns[block]];
            if (place < 0)
            {
              place = sum.columns.size();
              sum.columns.push_back(right.columns[block]);
              sum.entries.resize(sum.entries.size() + d * m);
            }
            double       *to   = &sum.entries[(d * place + i) * m];
            const double *from = &right.entries[m * block];
            for (int j = 0; j < m; ++j)
              to[j] += values[k] * from[j];
          }
      }
    }



    template <int d, int m>
    inline __attribute__((always_inline)) void
    multiply_blocks(const Epetra_CrsMatrix &matrix,
                    const BlockRows        &left,
                    const BlockRows        &right,
                    NodeRow<d, m>          &row,
                    BlockSums<m>           &result)
    {
      for (int node = 0; node < matrix.NumMyRows() / d; ++node)
      {
        add_products(matrix, right, node, row);
        for (std::size_t b = left.starts[node]; b < left.starts[node + 1]; ++b)
        {
          const double *p = &left.entries[d * m * b];
          for (std::size_t c = 0; c < row.columns.size(); ++c)
          {
            double       *to = result.entry(left.columns[b], row.columns[c]);
            const double *t  = &row.entries[d * m * c];
            for (int i = 0; i < m; ++i)
              for (int j = 0; j < m; ++j)
              {
                double sum = 0.;
                for (int k = 0; k < d; ++k)
                  sum += p[k * m + i] * t[k * m + j];
                to[i * m + j] += sum;
              }
          }
        }
      }
    }



    template <int d, int m>
    MIXED_CRACKS_FOR_AVX2 void
    multiply_blocks_avx2(const Epetra_CrsMatrix &matrix,
                         const BlockRows        &left,
                         const BlockRows        &right,
                         NodeRow<d, m>          &row,
                         BlockSums<m>           &result)
    {
      multiply_blocks(matrix, left, right, row, result);
    }



    // as a matrix of ML, with the rows of the restriction
    template <int m>
    ML_Operator *
    copy_sums(const BlockSums<m> &sums,
              const Numbers      &numbers,
              const ML_Operator  &restriction)
    {
      const std::size_t n_entries = sums.entries.size();
      const int         n_rows    = numbers.of_rows.size();
      auto             *data =
        static_cast<ML_CSR_MSRdata *>(ML_allocate(sizeof(ML_CSR_MSRdata)));
      data->rowptr =
        static_cast<int *>(ML_allocate((n_rows + 1) * sizeof(int)));
      data->columns = static_cast<int *>(ML_allocate(n_entries * sizeof(int)));
      data->values =
        static_cast<double *>(ML_allocate(n_entries * sizeof(double)));
      int next = 0, longest = 0;
      data->rowptr[0] = 0;
      for (int row = 0; row < n_rows; ++row)
      {
        const int         number = numbers.of_rows[row];
        const std::size_t place  = place_of(number / m, numbers.left);
        if (place == numbers.left.size() || numbers.left[place] != number / m)
        {
          data->rowptr[row + 1] = next; // nothing interpolates from it
          continue;
        }
        for (const auto &[column, block] : sums.rows[place])
          for (int j = 0; j < m; ++j, ++next)
          {
            const std::size_t first = m * static_cast<std::size_t>(block);
            data->columns[next]     = m * numbers.right[column] + j;
            data->values[next] = sums.entries[m * (first + number % m) + j];
          }
        data->rowptr[row + 1] = next;
        longest               = std::max(longest, next - data->rowptr[row]);
      }
      ML_Operator *result = ML_Operator_Create(restriction.comm);
      ML_Operator_Set_ApplyFuncData(
        result, restriction.outvec_leng, n_rows, data, n_rows, nullptr, 0);
      ML_Operator_Set_Getrow(result, n_rows, CSR_getrow);
      result->max_nz_per_row = longest;
      result->N_nonzeros     = next;
      return result;
    }



    // of the entries on this rank
    template <int d, int m>
    ML_Operator *
    local_product(const Epetra_CrsMatrix &matrix,
                  const ML_Operator      &restriction,
                  const BlockRows        &left,
                  const BlockRows        &right,
                  const Numbers          &numbers)
    {
      NodeRow<d, m> row;
      row.places.assign(numbers.right.size(), -1);
      BlockSums<m> sums(numbers.left.size());
      if (has_avx2())
        multiply_blocks_avx2(matrix, left, right, row, sums);
      else
        multiply_blocks(matrix, left, right, row, sums);
      return copy_sums(sums, numbers, restriction);
    }



    // rows of P for all columns of A, those of other ranks, too
    BlockRows
    read_all_rows(ML_Operator &prolongator,
                  ML_Operator &matrix,
                  const int    n,
                  const int    n_modes)
    {
      ML_Operator *all = &prolongator;
      if (matrix.getrow->pre_comm != nullptr)
        ML_exchange_rows(&prolongator, &all, matrix.getrow->pre_comm);
      BlockRows result = read_rows(*all, n, 1, n_modes);
      if (all == &prolongator)
        return result;
      // what was appended to it goes, itself it stays
      for (ML_Operator *part = all; part != nullptr; part = part->sub_matrix)
        if (part->sub_matrix == &prolongator)
          part->sub_matrix = nullptr;
      ML_RECUR_CSR_MSRdata_Destroy(all);
      ML_Operator_Destroy(&all);
      return result;
    }
  } // namespace



  void
  set_galerkin_product(ML_Struct              &hierarchy,
                       const Epetra_CrsMatrix &matrix,
                       const unsigned int      n_components,
                       const unsigned int      n_modes)
  {
    ML_Operator &fine = hierarchy.Amat[0], &coarse = hierarchy.Amat[1];
    ML_Operator &prolongator = hierarchy.Pmat[1];
    ML_Operator &restriction = hierarchy.Rmat[0];

    // columns by numbers that no other rank has
    int            most_columns = 0;
    ML_GetrowFunc &access       = *prolongator.getrow;
    ML_create_unique_col_id(prolongator.invec_leng,
                            &access.loc_glob_map,
                            access.pre_comm,
                            &most_columns,
                            prolongator.comm);
    access.use_loc_glob_map = ML_YES;
    BlockRows left =
      read_rows(prolongator, matrix.NumMyRows(), n_components, n_modes);
    BlockRows right =
      read_all_rows(prolongator, fine, matrix.NumMyCols(), n_modes);
    Numbers numbers;
    numbers.of_rows.assign(access.loc_glob_map,
                           access.loc_glob_map + restriction.getrow->Nrows);
    numbers.left  = number_without_gaps(left.columns);
    numbers.right = number_without_gaps(right.columns);
    ML_free(access.loc_glob_map);
    access.use_loc_glob_map = ML_NO;

    ML_Operator *product =
      n_components == 2
        ? local_product<2, 3>(matrix, restriction, left, right, numbers)
        : local_product<3, 6>(matrix, restriction, left, right, numbers);
    if (restriction.getrow->post_comm != nullptr)
      ML_exchange_rows(product, &product, restriction.getrow->post_comm);
    product->num_PDEs  = fine.num_PDEs;
    product->num_rigid = fine.num_rigid;
    ML_back_to_local(product, &coarse, most_columns);
    ML_RECUR_CSR_MSRdata_Destroy(product);
    ML_Operator_Destroy(&product);
  }
} // namespace MixedCracks
