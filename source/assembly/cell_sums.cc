// SPDX-License-Identifier: GPL-2.0-or-later
// With u = C v for the unknowns u of a cell, where constraints make them depend
// on others v,
//
//   A_rs += sum_ij C_ir local_ij C_js    for all r, s,
//   A_ii += |local_ii|                   for constrained i,
//
// as AffineConstraints has it (the mean of |local_jj| where local_ii is 0).
// Most cells have C = 1.

#include <assembly/cell_sums.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    using Indices     = CellSums::Indices;
    using Constraints = CellSums::Constraints;

    // C of a cell, and the v of it; with them the constrained unknowns.
    template <typename Dependence>
    Indices
    find_dependences(const Indices             &cell,
                     const Constraints         &constraints,
                     std::vector<Dependence>   &dependences,
                     std::vector<unsigned int> &constrained)
    {
      Indices    result;
      const auto add = [&](const unsigned int            i,
                           const types::global_dof_index unknown,
                           const double                  weight) {
        const auto found = std::find(result.begin(), result.end(), unknown);
        dependences.push_back(
          {i, static_cast<unsigned int>(found - result.begin()), weight});
        if (found == result.end())
          result.push_back(unknown);
      };
      for (unsigned int i = 0; i < cell.size(); ++i)
        if (!constraints.is_constrained(cell[i]))
          add(i, cell[i], 1.);
        else
        {
          constrained.push_back(i);
          for (const auto &[unknown, weight] :
               *constraints.get_constraint_entries(cell[i]))
            add(i, unknown, weight);
        }
      for (const unsigned int i : constrained)
        result.push_back(cell[i]);
      if (constrained.empty())
        dependences.clear();
      return result;
    }



    // C^T A C, n x n
    template <typename Dependence>
    FullMatrix<double> restrict(const FullMatrix<double>      &A,
                                const std::vector<Dependence> &dependences,
                                const unsigned int             n)
    {
      FullMatrix<double> half(A.m(), n), result(n, n);
      for (unsigned int i = 0; i < A.m(); ++i)
        for (const Dependence &of : dependences)
          half(i, of.r) += A(i, of.i) * of.weight;
      for (const Dependence &of : dependences)
        for (unsigned int s = 0; s < n; ++s)
          result(of.r, s) += of.weight * half(of.i, s);
      return result;
    }



    double
    mean_diagonal(const FullMatrix<double> &local)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < local.m(); ++i)
        sum += std::abs(local(i, i));
      return sum / local.m();
    }
  } // namespace



  void
  CellSums::reinit(LinearAlgebra::SparseMatrix &new_matrix,
                   const std::vector<Indices>  &cells,
                   const Constraints           &constraints)
  {
    matrix       = &new_matrix;
    int *of_rows = nullptr, *of_columns = nullptr;
    AssertThrow(matrix->trilinos_matrix().ExtractCrsDataPointers(
                  of_rows, of_columns, own.entries) == 0,
                ExcMessage("the matrix is not compressed"));
    own.starts  = of_rows;
    own.columns = of_columns;

    n = cells.empty() ? 0 : cells.front().size();
    numbers.clear();
    special_cells.clear();
    std::vector<Indices> unknowns; // of special cells
    for (const Indices &cell : cells)
    {
      for (const types::global_dof_index unknown : cell)
        numbers.push_back(
          matrix->trilinos_matrix().LRID(static_cast<int>(unknown)));
      if (is_plain(cell, constraints))
        continue;
      special_cells.emplace_back();
      numbers[numbers.size() - n] = -static_cast<int>(special_cells.size());
      unknowns.push_back(find_dependences(cell,
                                          constraints,
                                          special_cells.back().dependences,
                                          special_cells.back().constrained));
    }
    find_foreign_rows(unknowns);
    for (std::size_t k = 0; k < special_cells.size(); ++k)
      for (const types::global_dof_index unknown : unknowns[k])
      {
        special_cells[k].rows.push_back(row_of(unknown));
        special_cells[k].columns.push_back(column_of(unknown));
      }
  }



  bool
  CellSums::is_plain(const Indices &cell, const Constraints &constraints) const
  {
    return std::all_of(
      cell.begin(), cell.end(), [&](const types::global_dof_index unknown) {
        const int number = unknown;
        const int row    = matrix->trilinos_matrix().LRID(number);
        return row >= 0 && row == matrix->trilinos_matrix().LCID(number) &&
               !constraints.is_constrained(unknown);
      });
  }



  int
  CellSums::row_of(const types::global_dof_index unknown) const
  {
    const int row = matrix->trilinos_matrix().LRID(static_cast<int>(unknown));
    if (row >= 0)
      return row;
    const auto found =
      std::lower_bound(foreign_rows.begin(), foreign_rows.end(), unknown);
    return -1 - static_cast<int>(found - foreign_rows.begin());
  }



  int
  CellSums::column_of(const types::global_dof_index unknown)
  {
    const int column =
      matrix->trilinos_matrix().LCID(static_cast<int>(unknown));
    if (column >= 0)
      return column;
    return further_columns
      .try_emplace(unknown,
                   matrix->trilinos_matrix().NumMyCols() +
                     static_cast<int>(further_columns.size()))
      .first->second;
  }



  void
  CellSums::find_foreign_rows(const std::vector<Indices> &unknowns)
  {
    // row, column here, column for all
    using Entry =
      std::tuple<types::global_dof_index, int, types::global_dof_index>;
    std::vector<Entry> found;
    further_columns.clear();
    const auto add = [&](const types::global_dof_index row,
                         const types::global_dof_index column) {
      found.emplace_back(row, column_of(column), column);
    };
    const IndexSet owned = matrix->locally_owned_range_indices();
    for (std::size_t k = 0; k < unknowns.size(); ++k)
    {
      const std::size_t n_free =
        unknowns[k].size() - special_cells[k].constrained.size();
      for (std::size_t r = 0; r < unknowns[k].size(); ++r)
        if (owned.is_element(unknowns[k][r]))
          continue;
        else if (r >= n_free)
          add(unknowns[k][r], unknowns[k][r]);
        else
          for (std::size_t s = 0; s < n_free; ++s)
            add(unknowns[k][r], unknowns[k][s]);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());

    foreign_rows.clear();
    starts.clear();
    columns.clear();
    Indices global_columns;
    for (const auto &[row, column, global_column] : found)
    {
      if (foreign_rows.empty() || foreign_rows.back() != row)
      {
        foreign_rows.push_back(row);
        starts.push_back(columns.size());
      }
      columns.push_back(column);
      global_columns.push_back(global_column);
    }
    starts.push_back(columns.size());
    entries.assign(columns.size(), 0.);
    foreign = {starts.data(), columns.data(), entries.data()};
    find_messages(global_columns);
  }



  void
  CellSums::find_messages(const Indices &foreign_columns)
  {
    const MPI_Comm communicator = matrix->get_mpi_communicator();
    const IndexSet owned        = matrix->locally_owned_range_indices();
    IndexSet       wanted(owned.size());
    wanted.add_indices(foreign_rows.begin(), foreign_rows.end());
    const std::vector<unsigned int> owners =
      Utilities::MPI::compute_index_owner(owned, wanted, communicator);
    std::map<unsigned int, Indices>          entries_of; // row, column, row ...
    std::map<unsigned int, std::vector<int>> positions;
    for (std::size_t k = 0; k < foreign_rows.size(); ++k)
      for (int at = starts[k]; at < starts[k + 1]; ++at)
      {
        entries_of[owners[k]].push_back(foreign_rows[k]);
        entries_of[owners[k]].push_back(foreign_columns[at]);
        positions[owners[k]].push_back(at);
      }
    outgoing.clear();
    for (const auto &[rank, of_rank] : positions)
      outgoing.push_back({rank, of_rank, std::vector<double>(of_rank.size())});

    incoming.clear();
    for (const auto &[rank, list] :
         Utilities::MPI::some_to_some(communicator, entries_of))
    {
      incoming.push_back({rank, {}, std::vector<double>(list.size() / 2)});
      for (std::size_t k = 0; k < list.size(); k += 2)
      {
        const int  row   = row_of(list[k]);
        const int *first = own.columns + own.starts[row];
        const int *last  = own.columns + own.starts[row + 1];
        incoming.back().positions.push_back(
          std::lower_bound(first, last, column_of(list[k + 1])) - own.columns);
      }
    }
  }



  void
  CellSums::set_zero()
  {
    const int n_rows = matrix->trilinos_matrix().NumMyRows();
    std::fill(own.entries, own.entries + own.starts[n_rows], 0.);
    std::fill(entries.begin(), entries.end(), 0.);
  }



  void
  CellSums::add(const unsigned int cell, const FullMatrix<double> &local)
  {
    const int *rows = &numbers[n * cell];
    if (rows[0] >= 0)
    {
      add_rows(rows, rows, local);
      return;
    }
    const SpecialCell &special = special_cells[-1 - rows[0]];
    if (special.constrained.empty())
    {
      add_rows(special.rows.data(), special.columns.data(), local);
      return;
    }
    const unsigned int n_free =
      special.rows.size() - special.constrained.size();
    add_rows(special.rows.data(),
             special.columns.data(),
             restrict(local, special.dependences, n_free));
    FullMatrix<double> diagonal(1, 1);
    for (std::size_t k = 0; k < special.constrained.size(); ++k)
    {
      const unsigned int i = special.constrained[k];
      diagonal(0, 0) =
        local(i, i) != 0. ? std::abs(local(i, i)) : mean_diagonal(local);
      add_rows(
        &special.rows[n_free + k], &special.columns[n_free + k], diagonal);
    }
  }



  void
  CellSums::add_rows(const int                *rows,
                     const int                *row_columns,
                     const FullMatrix<double> &local)
  {
    // a column is mostly as far from the start as in the row before, or follows
    // the column before: unknowns of a node do
    offsets.assign(local.n(), 0);
    for (unsigned int i = 0; i < local.m(); ++i)
    {
      const Rows &part   = rows[i] >= 0 ? own : foreign;
      const int   row    = rows[i] >= 0 ? rows[i] : -1 - rows[i];
      const int  *first  = part.columns + part.starts[row];
      const int   length = part.starts[row + 1] - part.starts[row];
      double     *to     = part.entries + part.starts[row];
      int         next   = 0;
      for (unsigned int j = 0; j < local.n(); ++j)
      {
        const int column = row_columns[j];
        int      &offset = offsets[j];
        if (offset >= length || first[offset] != column)
          offset = next < length && first[next] == column
                     ? next
                     : std::lower_bound(first, first + length, column) - first;
        Assert(offset < length && first[offset] == column, ExcInternalError());
        to[offset] += local(i, j);
        next = offset + 1;
      }
    }
  }



  void
  CellSums::finish()
  {
    constexpr int            tag          = 4711; // any
    const MPI_Comm           communicator = matrix->get_mpi_communicator();
    std::vector<MPI_Request> requests;
    const auto start = [&](Message &message, const auto function) {
      requests.emplace_back();
      const int error = function(message.values.data(),
                                 message.values.size(),
                                 MPI_DOUBLE,
                                 message.rank,
                                 tag,
                                 communicator,
                                 &requests.back());
      AssertThrowMPI(error);
    };
    for (Message &message : incoming)
      start(message, MPI_Irecv);
    for (Message &message : outgoing)
    {
      for (std::size_t k = 0; k < message.values.size(); ++k)
        message.values[k] = entries[message.positions[k]];
      start(message, MPI_Isend);
    }
    const int error =
      MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
    AssertThrowMPI(error);
    for (const Message &message : incoming)
      for (std::size_t k = 0; k < message.values.size(); ++k)
        own.entries[message.positions[k]] += message.values[k];
  }
} // namespace MixedCracks
