// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_checks_h
#define mixed_cracks_problem_geometries_checks_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// A number as it stands in an error message: six digits, no padding.
  std::string number_text(double value);

  /// "(12, 18)".
  std::string point_text(const std::vector<double> &coordinates);

  /// Throws InputError with @p message unless @p condition holds.
  void require(bool condition, const std::string &message);

  /// Throws InputError naming @p parameter unless @p value is finite and
  /// positive.
  void require_positive(double value, const std::string &parameter);

  /// "Cell size" of the present subsection.
  void add_cell_size(dealii::ParameterHandler &prm, double &cell_size);

  /// Throws InputError naming @p parameter unless cells of @p cell_size (mm)
  /// fit into a box with these @p extents (mm), and fewer than a million of
  /// them fill it.
  void require_cell_size(double                     cell_size,
                         const std::vector<double> &extents,
                         const std::string         &parameter);

  /// The numbers of coarse cells in @p dim directions, as "4, 2". Throws
  /// InputError naming @p parameter when they are not integers from 1, or
  /// more than a million in all.
  std::vector<unsigned int> read_cell_numbers(const std::string &text,
                                              unsigned int       dim,
                                              const std::string &parameter);

  /// The number of a boundary or material, which is what @p kind says: an
  /// integer from 0 to 1e9. Throws InputError naming @p parameter otherwise.
  unsigned int read_id(const std::string &text,
                       const std::string &kind,
                       const std::string &parameter);

  /// @p n cells on an edge when each is @p factor times as long: at least one.
  unsigned int coarser_number(unsigned int n, double factor);

  /// The same for several edges, as an entry that read_cell_numbers() reads.
  std::string coarser_numbers(const std::vector<unsigned int> &n,
                              double                           factor);
} // namespace MixedCracks

#endif
