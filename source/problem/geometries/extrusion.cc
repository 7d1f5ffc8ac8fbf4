// SPDX-License-Identifier: GPL-2.0-or-later
// From the plane to space: (x, y) -> (x, y) x [0, t]. A point becomes a line, a
// segment a rectangle, a face of the boundary a wall with the same id; the two
// ends are "back" (z = 0) and "front" (z = t). Vertices that are doubled in the
// plane are doubled in every layer, slits stay slits.
//
// The ends are found by the z of the middle of a face, to 1e-9 of t.

#include <problem/geometries/boundaries.h>
#include <problem/geometries/checks.h>
#include <problem/geometries/extrusion.h>

#include <deal.II/base/patterns.h>
#include <deal.II/grid/grid_generator.h>

namespace MixedCracks
{
  using dealii::Point;

  void
  extrude(const dealii::Triangulation<2> &plane,
          const std::vector<double>      &z,
          dealii::Triangulation<3>       &triangulation)
  {
    dealii::GridGenerator::extrude_triangulation(plane, z, triangulation);
    const double tolerance = 1e-9 * z.back();
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
        {
          const double height = cell->face(f)->center()[2];
          if (height < tolerance)
            cell->face(f)->set_boundary_id(back);
          else if (height > z.back() - tolerance)
            cell->face(f)->set_boundary_id(front);
        }
  }



  std::vector<double>
  equal_layers(const double thickness, const unsigned int n_layers)
  {
    std::vector<double> z;
    for (unsigned int layer = 0; layer <= n_layers; ++layer)
      z.push_back(thickness * layer / n_layers);
    return z;
  }



  void
  add_thickness_cells(dealii::ParameterHandler &prm,
                      unsigned int             &thickness_cells)
  {
    prm.add_parameter("Thickness cells",
                      thickness_cells,
                      "Number of cells of the coarse mesh across the thickness "
                      "(Material/Thickness), from z = 0. Ignored in 2-d.",
                      dealii::Patterns::Integer(1));
  }



  void
  require_thickness_cells(const unsigned int thickness_cells,
                          const double       n_cells_in_plane,
                          const std::string &subsection)
  {
    constexpr double max_cells = 1e6;
    const double     n_cells   = thickness_cells * n_cells_in_plane;
    require(n_cells <= max_cells,
            subsection + "Thickness cells is " +
              std::to_string(thickness_cells) + ", which makes " +
              number_text(n_cells) + " coarse cells; at most " +
              number_text(max_cells) +
              " are allowed (refine with the subsection Mesh instead).");
  }



  template <>
  FlatPiece<2>
  extruded_point(const Point<2> &point, const double)
  {
    return FlatPiece<2>::point(point);
  }



  template <>
  FlatPiece<3>
  extruded_point(const Point<2> &point, const double thickness)
  {
    return FlatPiece<3>::segment({point[0], point[1], 0.},
                                 {point[0], point[1], thickness});
  }



  template <>
  FlatPiece<2>
  extruded_segment(const Point<2> &begin, const Point<2> &end, const double)
  {
    return FlatPiece<2>::segment(begin, end);
  }



  template <>
  FlatPiece<3>
  extruded_segment(const Point<2> &begin,
                   const Point<2> &end,
                   const double    thickness)
  {
    return {{{Point<3>(begin[0], begin[1], 0.),
              Point<3>(end[0], end[1], 0.),
              Point<3>(begin[0], begin[1], thickness),
              Point<3>(end[0], end[1], thickness)}}};
  }



  template <>
  dealii::BoundingBox<2>
  extruded_box(const dealii::BoundingBox<2> &box, const double)
  {
    return box;
  }



  template <>
  dealii::BoundingBox<3>
  extruded_box(const dealii::BoundingBox<2> &box, const double thickness)
  {
    const auto &[lower, upper] = box.get_boundary_points();
    return dealii::BoundingBox<3>({Point<3>(lower[0], lower[1], 0.),
                                   Point<3>(upper[0], upper[1], thickness)});
  }
} // namespace MixedCracks
