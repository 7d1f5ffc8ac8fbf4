// SPDX-License-Identifier: GPL-2.0-or-later
//   c3      top      c2      image of the unit square under the bilinear map
//     +-------------+
// left \             \ right   x(s, t) = (1-t) ((1-s) c0 + s c1)
//       +-------------+                 + t ((1-s) c3 + s c2),
//      c0   bottom    c1
//                             of an even grid of n_s x n_t cells
//
// det dx/d(s, t) is a polynomial of degree 1 in s and t: it is positive
// everywhere if it is at the four corners, where it is the cross product of the
// two sides. This is what check() asks for: at every corner the sides turn
// left.
//
// Lines of constant s or t stay straight, so that the middle of a boundary face
// lies on its side. Its name is found by the smallest distance from the lines
// through the corners.

#include <base/coordinates.h>
#include <base/plane.h>
#include <base/text.h>

#include <deal.II/base/patterns.h>

#include <problem/geometries/boundaries.h>
#include <problem/geometries/checks.h>
#include <problem/geometries/extrusion.h>
#include <problem/geometries/quad_mesh.h>
#include <problem/geometries/quadrilateral.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    const std::string quadrilateral_path = "Geometry/Quadrilateral/";
    const std::string corners_parameter(quadrilateral_path + "Corners");

    // in the order of the corners they begin at
    constexpr std::array<BoxSide, 4> sides = {{bottom, right, top, left}};

    // of a point from the line through two others; mm
    double
    distance_from_line(const Point<2> &p, const Point<2> &a, const Point<2> &b)
    {
      return std::abs(cross(b - a, p - a)) / (b - a).norm();
    }
  } // namespace



  std::string
  Quadrilateral::subsection() const
  {
    return quadrilateral_path;
  }



  void
  Quadrilateral::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.add_parameter("Corners",
                      corners_text,
                      "'x, y ; x, y ; x, y ; x, y', counterclockwise from the "
                      "lower left one; every angle less than 180 degrees. The "
                      "sides between them are bottom, right, top, left; mm.",
                      Anything());
    prm.add_parameter("Cells",
                      cells,
                      "Numbers of cells of the coarse mesh along bottom and "
                      "top, and along left and right, as '4, 2'.",
                      Anything());
  }



  Quadrilateral::Corners
  Quadrilateral::corners() const
  {
    const std::vector<std::string> points = split_list(corners_text, ';');
    require(points.size() == 4,
            corners_parameter + ": found " + in_quotes(corners_text) +
              ", allowed are 4 points, as '0,0 ; 1,0 ; 1,1 ; 0,1'.");
    Corners result;
    for (unsigned int i = 0; i < 4; ++i)
      result[i] = read_point<2>(points[i], corners_parameter);
    return result;
  }



  std::vector<unsigned int>
  Quadrilateral::cell_numbers() const
  {
    return read_cell_numbers(cells, 2, quadrilateral_path + "Cells");
  }



  void
  Quadrilateral::check() const
  {
    const Corners corner = corners();
    for (unsigned int i = 0; i < 4; ++i)
    {
      const Tensor<1, 2> before = corner[i] - corner[(i + 3) % 4];
      const Tensor<1, 2> after  = corner[(i + 1) % 4] - corner[i];
      require(cross(before, after) > 1e-9 * before.norm() * after.norm(),
              corners_parameter + ": at (" + number_text(corner[i][0]) + ", " +
                number_text(corner[i][1]) +
                ") the sides do not turn left; allowed are the corners of a "
                "convex quadrilateral, counterclockwise.");
    }
    cell_numbers();
  }



  dealii::BoundingBox<2>
  Quadrilateral::extent() const
  {
    const Corners corner = corners();
    Point<2>      lower, upper;
    for (unsigned int d = 0; d < 2; ++d)
    {
      const auto [low, high] =
        std::minmax({corner[0][d], corner[1][d], corner[2][d], corner[3][d]});
      lower[d] = low;
      upper[d] = high;
    }
    return dealii::BoundingBox<2>({lower, upper});
  }



  void
  Quadrilateral::create(dealii::Triangulation<2> &plane) const
  {
    const Corners                   corner = corners();
    const std::vector<unsigned int> n      = cell_numbers();
    const std::vector<double>       x      = equal_layers(1., n[0]);
    const std::vector<double>       y      = equal_layers(1., n[1]);
    QuadMesh                        mesh   = tensor_mesh(x, y);
    for (Point<2> &p : mesh.vertices)
    {
      const double s = p[0], t = p[1];
      for (unsigned int d = 0; d < 2; ++d)
        p[d] = (1. - t) * ((1. - s) * corner[0][d] + s * corner[1][d]) +
               t * ((1. - s) * corner[3][d] + s * corner[2][d]);
    }
    mesh.create(plane);

    set_boundary_ids_by_center(plane, [&](const Point<2> &center) {
      std::array<double, 4> distances{};
      for (unsigned int i = 0; i < 4; ++i)
        distances[i] =
          distance_from_line(center, corner[i], corner[(i + 1) % 4]);
      const auto nearest = std::min_element(distances.begin(), distances.end());
      return dealii::types::boundary_id(
        sides[std::distance(distances.begin(), nearest)]);
    });
  }



  double
  Quadrilateral::n_cells() const
  {
    const std::vector<unsigned int> n = cell_numbers();
    return 1. * n[0] * n[1];
  }



  std::unique_ptr<PlaneFigure>
  Quadrilateral::coarser(const double factor) const
  {
    auto result   = std::make_unique<Quadrilateral>(*this);
    result->cells = coarser_numbers(cell_numbers(), factor);
    return result;
  }
} // namespace MixedCracks
