// SPDX-License-Identifier: GPL-2.0-or-later
// The matrix of the first coarse level of smoothed aggregation,
//
//   A_bc = sum over nodes I of  P_Ib^T T_Ic,    T_Ic = sum_J A_IJ P_Jc,
//
// b, c aggregates; A_IJ in R^(d x d) of two nodes, P_Ib in R^(d x m) of a node
// and an aggregate, m coarse functions per aggregate. ML looks for each entry
// of both products by itself and keeps A P, which is as large as A; here it is
// found for d m or m^2 entries at once, and T is of one node at a time
// (block_product.h). Of a hierarchy by ML the two products are the larger part.
//
// Ranks exchange rows as in ML: those of P that belong to nodes of others
// before, rows of A_bc for aggregates of others after it.

#include <ml_include.h>
#include <ml_rap.h>
#include <solvers/block_product.h>
#include <solvers/galerkin_product.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace MixedCracks
{
  namespace
  {
    // Rows of a matrix of ML, one at a time.
    class RowReader
    {
    public:
      explicit RowReader(ML_Operator &matrix)
        : matrix(matrix)
        , columns(static_cast<int *>(ML_allocate(n_allocated * sizeof(int))))
        , values(
            static_cast<double *>(ML_allocate(n_allocated * sizeof(double))))
      {}

      RowReader(const RowReader &)            = delete;
      RowReader &operator=(const RowReader &) = delete;

      ~RowReader()
      {
        ML_free(columns);
        ML_free(values);
      }

      void
      read(int row)
      {
        // enlarges the two if need be
        ML_get_matrix_row(
          &matrix, 1, &row, &n_allocated, &columns, &values, &length, 0);
      }

    private:
      ML_Operator &matrix;
      int          n_allocated = 100;

    public:
      int    *columns;
      double *values;
      int     length = 0;
    };



    // Columns before entries, which are allocated once: they are the most of
    // the memory here.
    ProlongatorRows
    read_rows(ML_Operator &matrix, const int n_rows, const int n_modes)
    {
      ProlongatorRows   result;
      std::vector<int> &blocks = result.columns;
      RowReader         row(matrix);
      // the place of a block in the last row begun, most often that of the
      // entry before
      const auto find = [&](const int         block,
                            const std::size_t guess,
                            const std::size_t first,
                            const std::size_t end) {
        if (guess < end && blocks[guess] == block)
          return guess;
        return static_cast<std::size_t>(
          std::find(blocks.begin() + first, blocks.begin() + end, block) -
          blocks.begin());
      };
      for (int i = 0; i < n_rows; ++i)
      {
        row.read(i);
        std::size_t place = blocks.size();
        for (int k = 0; k < row.length; ++k)
        {
          const int block = row.columns[k] / n_modes;
          place = find(block, place, result.starts.back(), blocks.size());
          if (place == blocks.size())
            blocks.push_back(block);
        }
        result.starts.push_back(blocks.size());
      }
      const std::size_t size = padded(n_modes);
      result.entries.resize(size * blocks.size());
      for (int i = 0; i < n_rows; ++i)
      {
        row.read(i);
        std::size_t place = result.starts[i];
        for (int k = 0; k < row.length; ++k)
        {
          place = find(row.columns[k] / n_modes,
                       place,
                       result.starts[i],
                       result.starts[i + 1]);
          result.entries[size * place + row.columns[k] % n_modes] =
            row.values[k];
        }
      }
      return result;
    }



    // Numbers that no two unknowns of the coarse level have, on all ranks: of
    // the rows of the restriction here; divided by m of the blocks here, in
    // order.
    struct Numbers
    {
      std::vector<int> of_rows, of_blocks;
    };



    int
    place_of(const int number, const std::vector<int> &numbers)
    {
      return std::lower_bound(numbers.begin(), numbers.end(), number) -
             numbers.begin();
    }



    // Numbers of the blocks and rows here; replaces columns by the places of
    // blocks.
    Numbers
    number_without_gaps(std::vector<int> &columns,
                        const int        *of_rows,
                        const int         n_rows,
                        const int         n_modes)
    {
      Numbers result;
      result.of_rows.assign(of_rows, of_rows + n_rows);
      std::vector<int> &blocks = result.of_blocks;
      blocks                   = columns;
      for (const int number : result.of_rows)
        blocks.push_back(number / n_modes);
      std::sort(blocks.begin(), blocks.end());
      blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
      for (int &column : columns)
        column = place_of(column, blocks);
      return result;
    }



    template <int d, int m>
    MIXED_CRACKS_FOR_AVX2 void
    multiply_blocks_avx2(const Epetra_CrsMatrix &matrix,
                         const ProlongatorRows  &prolongator,
                         NodeRow<d, m>          &of_node,
                         NodeRow<d, m>          &product,
                         BlockSums<m>           &result)
    {
      multiply_blocks(matrix, prolongator, of_node, product, result);
    }



    // as a matrix of ML, with the rows of the restriction
    template <int m>
    ML_Operator *
    copy_sums(const BlockSums<m> &sums,
              const Numbers      &numbers,
              const ML_Operator  &restriction)
    {
      const std::size_t n_entries = sums.entries.size() / padded(m) * m;
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
        const int number = numbers.of_rows[row];
        for (const auto &[column, block] :
             sums.rows[place_of(number / m, numbers.of_blocks)])
          for (int j = 0; j < m; ++j, ++next)
          {
            const std::size_t first = m * static_cast<std::size_t>(block);
            data->columns[next]     = m * numbers.of_blocks[column] + j;
            data->values[next] =
              sums.entries[padded(m) * (first + number % m) + j];
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
                  const ProlongatorRows  &prolongator,
                  const Numbers          &numbers)
    {
      const int     n_blocks = numbers.of_blocks.size();
      NodeRow<d, m> of_node(n_blocks), product(n_blocks);
      BlockSums<m>  sums(n_blocks);
      if (has_avx2())
        multiply_blocks_avx2(matrix, prolongator, of_node, product, sums);
      else
        multiply_blocks(matrix, prolongator, of_node, product, sums);
      return copy_sums(sums, numbers, restriction);
    }



    // rows of P for all columns of A, those of other ranks, too
    ProlongatorRows
    read_all_rows(ML_Operator &prolongator,
                  ML_Operator &matrix,
                  const int    n,
                  const int    n_modes)
    {
      ML_Operator *all = &prolongator;
      if (matrix.getrow->pre_comm != nullptr)
        ML_exchange_rows(&prolongator, &all, matrix.getrow->pre_comm);
      ProlongatorRows result = read_rows(*all, n, n_modes);
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
    ProlongatorRows rows =
      read_all_rows(prolongator, fine, matrix.NumMyCols(), n_modes);
    const Numbers numbers = number_without_gaps(
      rows.columns, access.loc_glob_map, restriction.getrow->Nrows, n_modes);
    ML_free(access.loc_glob_map);
    access.use_loc_glob_map = ML_NO;

    ML_Operator *product =
      n_components == 2
        ? local_product<2, 3>(matrix, restriction, rows, numbers)
        : local_product<3, 6>(matrix, restriction, rows, numbers);
    if (restriction.getrow->post_comm != nullptr)
      ML_exchange_rows(product, &product, restriction.getrow->post_comm);
    product->num_PDEs  = fine.num_PDEs;
    product->num_rigid = fine.num_rigid;
    ML_back_to_local(product, &coarse, most_columns);
    ML_RECUR_CSR_MSRdata_Destroy(product);
    ML_Operator_Destroy(&product);
  }
} // namespace MixedCracks
