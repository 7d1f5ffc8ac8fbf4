// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_point_displacements_h
#define mixed_cracks_output_point_displacements_h

#include <base/linear_algebra.h>

#include <discretization/fields.h>

#include <output/point_displacement_parameters.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// The displacement at points anywhere in the body. Where a point belongs to
  /// several cells, it is their mean: this changes something only at slits,
  /// and the result does not depend on the number of ranks.
  template <int dim>
  class PointDisplacements
  {
  public:
    PointDisplacements(const Fields<dim>                  &fields,
                       const std::vector<NamedPoint<dim>> &points);

    /// Find the cells; to be called when the mesh changed. Throws InputError
    /// on all ranks for a point outside of the mesh. Collective.
    void reinit();

    /// dim components of one point after the other, mm; the same on all ranks.
    /// @p elastic has ghosts. Collective.
    std::vector<double> evaluate(const LinearAlgebra::Vector &elastic) const;

    /// Of statistics.csv, in the order of evaluate().
    std::vector<std::string> column_names() const;

  private:
    using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;

    /// A point in one of the cells it belongs to.
    struct Sample
    {
      Cell               cell;
      std::size_t        point;     ///< its number
      dealii::Point<dim> unit_cell; ///< its position there
    };

    void find_in(const Cell &cell);

    const Fields<dim>                 &fields;
    const std::vector<NamedPoint<dim>> points;
    std::vector<Sample>                samples; // in owned cells
    std::vector<double>                n_cells; // around each point
  };
} // namespace MixedCracks

#endif
