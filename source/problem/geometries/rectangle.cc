// SPDX-License-Identifier: GPL-2.0-or-later
//   upper corner
//   y ^     top     x      a box along the axes, between two given corners;
//     |  +---------+       in 3-d "back" (least z) and "front" (largest z)
//   left |         | right
//        +---------+       cells in direction d: round(extent_d/cell size), at
//        x  bottom         least 1, or the given numbers
//   lower corner
//
// It needs no plane figure and no thickness: deal.II makes boxes in both
// dimensions, and numbers their boundaries 2d (lower) and 2d + 1 (upper) for
// direction d, which is the order of BoxSide.

#include <problem/geometries/boundaries.h>
#include <problem/geometries/checks.h>
#include <problem/geometries/rectangle.h>

#include <deal.II/base/patterns.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace
  {
    template <int dim>
    std::string
    subsection()
    {
      return dim == 2 ? "Geometry/Rectangle/" : "Geometry/Box/";
    }
  } // namespace



  template <int dim>
  dealii::Point<dim>
  Rectangle<dim>::unit_corner()
  {
    dealii::Point<dim> corner;
    for (unsigned int d = 0; d < dim; ++d)
      corner[d] = 1.;
    return corner;
  }



  template <int dim>
  void
  Rectangle<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.add_parameter("Lower corner",
                      lower_corner,
                      "The corner with the smallest coordinates; mm.",
                      List(Double(), dim, dim));
    prm.add_parameter("Upper corner",
                      upper_corner,
                      "The corner with the largest coordinates; mm.",
                      List(Double(), dim, dim));
    add_cell_size(prm, cell_size);
    prm.add_parameter(
      "Cells",
      cells,
      std::string("Numbers of cells of the coarse mesh in ") +
        (dim == 2 ? "x, y, as '4, 2'" : "x, y, z, as '4, 4, 1'") +
        "; empty: as many as Cell size makes.",
      Anything());
  }



  template <int dim>
  void
  Rectangle<dim>::check() const
  {
    std::vector<double> lower, upper, extents;
    for (unsigned int d = 0; d < dim; ++d)
    {
      lower.push_back(lower_corner[d]);
      upper.push_back(upper_corner[d]);
      extents.push_back(upper[d] - lower[d]);
    }
    for (const double extent : extents)
      require(std::isfinite(extent) && extent > 0.,
              subsection<dim>() + "Upper corner is " + point_text(upper) +
                "; every coordinate must be greater than that of the lower "
                "corner, " +
                point_text(lower) + ".");
    if (cells.empty())
      require_cell_size(cell_size, extents, subsection<dim>() + "Cell size");
    else
      n_cells();
  }



  template <int dim>
  std::vector<unsigned int>
  Rectangle<dim>::n_cells() const
  {
    if (!cells.empty())
      return read_cell_numbers(cells, dim, subsection<dim>() + "Cells");
    std::vector<unsigned int> result;
    for (unsigned int d = 0; d < dim; ++d)
      result.push_back(static_cast<unsigned int>(std::max(
        1., std::round((upper_corner[d] - lower_corner[d]) / cell_size))));
    return result;
  }



  template <int dim>
  NamedBoundaries
  Rectangle<dim>::boundary_ids() const
  {
    return box_side_ids<dim>();
  }



  template <int dim>
  std::optional<dealii::BoundingBox<dim>>
  Rectangle<dim>::extent() const
  {
    return dealii::BoundingBox<dim>({lower_corner, upper_corner});
  }



  template <int dim>
  void
  Rectangle<dim>::create(dealii::Triangulation<dim> &triangulation) const
  {
    // colorized: the boundary ids 0, 1 are those at the ends in x, and so on
    dealii::GridGenerator::subdivided_hyper_rectangle(
      triangulation, n_cells(), lower_corner, upper_corner, true);
  }



  template <int dim>
  std::optional<double>
  Rectangle<dim>::n_coarse_cells() const
  {
    double result = 1.;
    for (const unsigned int n : n_cells())
      result *= n;
    return result;
  }



  template <int dim>
  std::unique_ptr<Geometry<dim>>
  Rectangle<dim>::coarser(const double factor) const
  {
    auto result   = std::make_unique<Rectangle>(*this);
    result->cells = coarser_numbers(n_cells(), factor);
    return result;
  }



  template class Rectangle<2>;
  template class Rectangle<3>;
} // namespace MixedCracks
