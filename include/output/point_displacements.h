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
  /// The displacement at points anywhere in the body. On a slit it is the mean
  /// of the faces, whatever the cells there. The result does not depend on the
  /// number of ranks.
  template <int dim>
  class PointDisplacements
  {
  public:
    PointDisplacements(const Fields<dim>                  &fields,
                       const std::vector<NamedPoint<dim>> &points)
      : fields(fields)
      , points(points)
    {}

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
      double             n_cells;   ///< around the point, with this one, that
                                    ///< no slit parts from it
    };

    void        find_in(const Cell &cell);
    static bool touches(const Sample &sample, const Sample &other);
    void        count_cells_of_fans();

    const Fields<dim>                 &fields;
    const std::vector<NamedPoint<dim>> points;
    std::vector<Sample>                samples; // in owned cells
    std::vector<double>                n_fans;  // around each point
  };
} // namespace MixedCracks

#endif
