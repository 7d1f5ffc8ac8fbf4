// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_row_space_h
#define mixed_cracks_discretization_row_space_h

#include <vector>

namespace MixedCracks
{
  using Row = std::vector<double>;

  /// Relative to a row: what is shorter is rounding.
  constexpr double negligible_row = 1e-6;

  /// The space that rows of numbers span, by orthonormal rows.
  class RowSpace
  {
  public:
    explicit RowSpace(std::size_t n_columns);

    /// A row that depends on the earlier ones, but for negligible_row, changes
    /// nothing.
    void add(Row row);

    /// Orthonormal: all x with row * x = 0 for every row.
    std::vector<Row> kernel() const;

  private:
    const std::size_t n_columns;
    std::vector<Row>  rows;
  };

  /// The space of @p rows by rows in reduced echelon form: the first number of
  /// each that is not 0 is 1, farther right from row to row, and the only one
  /// in its column. They follow the axes where they can.
  std::vector<Row> reduced_echelon_form(std::vector<Row> rows,
                                        std::size_t      n_columns);
} // namespace MixedCracks

#endif
