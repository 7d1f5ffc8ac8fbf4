// SPDX-License-Identifier: GPL-2.0-or-later
//          top
//   y ^  +-----------+ a      a: Size, the origin at the lower left
//     |  |           |
//        |      c    | right  c = (a/2, a/2), the reentrant corner:
//   left |     +-----+ a/2      "reentrant horizontal"  y = a/2, x > a/2
//        |     |                "reentrant vertical"    x = a/2, y < a/2
//        |     |
//        +-----+     0  -> x
//         bottom
//
// Grid lines at 0, a/2, a and equal cells between them. The corner is a vertex:
// in an intact body the stress grows there as r^(s - 1) with sin(3 pi s/2) = s,
// s = 0.5445 (Williams, J. Appl. Mech. 19 (1952), free sides, symmetric part),
// which is nearly the -1/2 of a crack, so that a crack starts there.

#include <problem/geometries/boundaries.h>
#include <problem/geometries/checks.h>
#include <problem/geometries/l_shape.h>
#include <problem/geometries/quad_mesh.h>

#include <deal.II/base/patterns.h>

#include <cmath>

namespace MixedCracks
{
  namespace
  {
    constexpr dealii::types::boundary_id reentrant_horizontal = n_box_sides;
    constexpr dealii::types::boundary_id reentrant_vertical   = n_box_sides + 1;

    const std::string l_shape_path = "Geometry/L-shape/";
  } // namespace



  std::string
  LShape::subsection() const
  {
    return l_shape_path;
  }



  void
  LShape::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.add_parameter("Size",
                      size,
                      "Side of the square, whose lower left corner is the "
                      "origin; mm. Its lower right quadrant is removed.",
                      Double(0.));
    add_cell_size(prm, cell_size);
  }



  void
  LShape::check() const
  {
    require_positive(size, l_shape_path + "Size");
    require_cell_size(cell_size, {size, size}, l_shape_path + "Cell size");
  }



  NamedBoundaries
  LShape::more_boundary_ids() const
  {
    return {{"reentrant horizontal", reentrant_horizontal},
            {"reentrant vertical", reentrant_vertical}};
  }



  dealii::BoundingBox<2>
  LShape::extent() const
  {
    return dealii::BoundingBox<2>(
      {dealii::Point<2>(), dealii::Point<2>(size, size)});
  }



  void
  LShape::create(dealii::Triangulation<2> &plane) const
  {
    const double              half  = size / 2.;
    const std::vector<double> lines = grid_lines({0., half, size}, cell_size);
    tensor_mesh(lines, lines, [half](const dealii::Point<2> &center) {
      return center[0] > half && center[1] < half;
    }).create(plane);

    set_boundary_ids_by_center(plane, [&](const dealii::Point<2> &center) {
      if (const auto side = box_side_at(center, size, size))
        return dealii::types::boundary_id(*side);
      return center[0] > half + 1e-9 * size ? reentrant_horizontal
                                            : reentrant_vertical;
    });
  }



  double
  LShape::n_cells() const
  {
    return 0.75 * std::pow(size / cell_size, 2.);
  }



  double
  LShape::n_grid_cells() const
  {
    return size * size / (cell_size * cell_size);
  }



  std::unique_ptr<PlaneFigure>
  LShape::coarser(const double factor) const
  {
    auto result = std::make_unique<LShape>(*this);
    result->cell_size *= factor;
    return result;
  }
} // namespace MixedCracks
