// SPDX-License-Identifier: GPL-2.0-or-later
// Systems of a few unknowns, distributed over the ranks like large ones.
#ifndef mixed_cracks_tests_unit_small_systems_h
#define mixed_cracks_tests_unit_small_systems_h

#include <base/linear_algebra.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace MixedCracks
{
  namespace Testing
  {
    using Rows = std::vector<std::vector<double>>;

    /// The part of @p n unknowns this rank owns.
    inline dealii::IndexSet
    owned_part(const unsigned int n)
    {
      return dealii::Utilities::MPI::create_evenly_distributed_partitioning(
        MPI_COMM_WORLD, n);
    }

    inline LinearAlgebra::Vector
    distributed(const std::vector<double> &values)
    {
      LinearAlgebra::Vector result(owned_part(values.size()), MPI_COMM_WORLD);
      for (const auto i : result.locally_owned_elements())
        result(i) = values[i];
      result.compress(dealii::VectorOperation::insert);
      return result;
    }

    /// All values on every rank.
    inline std::vector<double>
    gathered(const LinearAlgebra::Vector &vector)
    {
      std::vector<double> values(vector.size(), 0.);
      for (const auto i : vector.locally_owned_elements())
        values[i] = vector(i);
      dealii::Utilities::MPI::sum(values, MPI_COMM_WORLD, values);
      return values;
    }

    inline void
    set_rows(const Rows &rows, LinearAlgebra::SparseMatrix &matrix)
    {
      matrix = 0.;
      for (const auto i : owned_part(rows.size()))
        for (unsigned int j = 0; j < rows.size(); ++j)
          if (rows[i][j] != 0. || i == j)
            matrix.set(i, j, rows[i][j]);
      matrix.compress(dealii::VectorOperation::insert);
    }

    /// Give @p matrix the pattern of @p rows, diagonal included, and values.
    inline void
    make_matrix(const Rows &rows, LinearAlgebra::SparseMatrix &matrix)
    {
      const dealii::IndexSet         owned = owned_part(rows.size());
      LinearAlgebra::SparsityPattern pattern(owned, MPI_COMM_WORLD);
      for (const auto i : owned)
        for (unsigned int j = 0; j < rows.size(); ++j)
          if (rows[i][j] != 0. || i == j)
            pattern.add(i, j);
      pattern.compress();
      matrix.reinit(pattern);
      set_rows(rows, matrix);
    }

    /// diagonal on the diagonal, -1 beside it: a stretched string.
    inline Rows
    string_rows(const unsigned int n, const double diagonal = 2.)
    {
      Rows rows(n, std::vector<double>(n, 0.));
      for (unsigned int i = 0; i < n; ++i)
      {
        rows[i][i] = diagonal;
        if (i > 0)
          rows[i][i - 1] = rows[i - 1][i] = -1.;
      }
      return rows;
    }

    inline std::vector<double>
    times(const Rows &rows, const std::vector<double> &x)
    {
      std::vector<double> result(rows.size(), 0.);
      for (unsigned int i = 0; i < rows.size(); ++i)
        for (unsigned int j = 0; j < rows.size(); ++j)
          result[i] += rows[i][j] * x[j];
      return result;
    }
  } // namespace Testing
} // namespace MixedCracks

#endif
