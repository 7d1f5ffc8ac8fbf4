// SPDX-License-Identifier: GPL-2.0-or-later
// Two small tools of linear algebra on rows, dense, for a few dozen columns.
//
// RowSpace: Gram and Schmidt, twice per row, since once leaves rounding errors
// that grow with |row|/|what is left|; a row is dependent when less than
// negligible_row |row| is left. The kernel { x : r . x = 0 for all rows r } are
// the unit rows made orthogonal to the space and to each other in the same way:
// what they add to the space until there are as many rows as columns.

#include <discretization/row_space.h>

#include <cmath>
#include <utility>

namespace MixedCracks
{
  namespace
  {
    double
    norm(const Row &row)
    {
      double square = 0.;
      for (const double value : row)
        square += value * value;
      return std::sqrt(square);
    }
  } // namespace



  RowSpace::RowSpace(const std::size_t n_columns)
    : n_columns(n_columns)
  {}



  void
  RowSpace::add(Row row)
  {
    if (rows.size() == n_columns)
      return;
    const double size = norm(row);
    // twice, for rounding
    for (unsigned int pass = 0; pass < 2; ++pass)
      for (const Row &other : rows)
      {
        double product = 0.;
        for (std::size_t i = 0; i < n_columns; ++i)
          product += row[i] * other[i];
        for (std::size_t i = 0; i < n_columns; ++i)
          row[i] -= product * other[i];
      }
    const double left = norm(row);
    if (!(left > negligible_row * size))
      return;
    for (double &value : row)
      value /= left;
    rows.push_back(row);
  }



  std::vector<Row>
  RowSpace::kernel() const
  {
    // what unit rows add to the space
    RowSpace all(*this);
    for (std::size_t i = 0; i < n_columns; ++i)
    {
      Row unit(n_columns, 0.);
      unit[i] = 1.;
      all.add(unit);
    }
    return {all.rows.begin() + rows.size(), all.rows.end()};
  }



  // Gauss and Jordan with the largest entry of a column as pivot: subtract
  // multiples of the pivot's row from all others, above as well as below.
  std::vector<Row>
  reduced_echelon_form(std::vector<Row> rows, const std::size_t n_columns)
  {
    std::size_t rank = 0;
    for (std::size_t column = 0; column < n_columns && rank < rows.size();
         ++column)
    {
      std::size_t pivot = rank;
      for (std::size_t i = rank; i < rows.size(); ++i)
        if (std::abs(rows[i][column]) > std::abs(rows[pivot][column]))
          pivot = i;
      if (std::abs(rows[pivot][column]) <= negligible_row)
        continue;
      std::swap(rows[rank], rows[pivot]);
      const double value = rows[rank][column];
      for (double &each : rows[rank])
        each /= value;
      for (std::size_t i = 0; i < rows.size(); ++i)
        if (i != rank)
        {
          const double factor = rows[i][column];
          for (std::size_t j = 0; j < n_columns; ++j)
            rows[i][j] -= factor * rows[rank][j];
        }
      ++rank;
    }
    rows.resize(rank);
    return rows;
  }
} // namespace MixedCracks
