// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_point_displacement_parameters_h
#define mixed_cracks_output_point_displacement_parameters_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// A point of the undeformed body that is watched.
  template <int dim>
  struct NamedPoint
  {
    std::string        name;     ///< letters, digits, blanks, '_' and '-'
    dealii::Point<dim> position; ///< mm

    /// Of the column of statistics.csv with a component of its displacement:
    /// "right_corner_x_mm".
    std::string column_name(unsigned int component) const;
  };

  /// Where the displacement is a column of statistics.csv, an entry of
  /// subsection "Output".
  template <int dim>
  struct PointDisplacementParameters
  {
    static constexpr const char *name = "Output/Displacement at points";

    std::string text;

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError for points that cannot be read, and for two whose
    /// columns would have the same name.
    void check() const;

    std::vector<NamedPoint<dim>> points() const;
  };
} // namespace MixedCracks

#endif
