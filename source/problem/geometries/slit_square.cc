// SPDX-License-Identifier: GPL-2.0-or-later
//              top
//     +---------------------+ a    a: Size, b: Slit height, c: Slit length
//     |                     |
//     |         slit tip    |      slit: y = b, 0 <= x < c. Vertices on it are
//     |=========* (c, b)    | b    doubled, but for the tip: two faces at one
// left|                     |      place, "slit lower" and "slit upper",
//     |                     |      together "slit". phi = 0 on them, unless
//     +---------------------+ 0    Initial cracks/Broken slits is false
//              bottom
//
// The single-edge-notched specimen of [Miehe10b] by default, a = 1 mm, b = c =
// a/2. In 3-d a cube: its depth is a, not Material/Thickness, with cells of the
// same size in z. Slit and sides are grid lines, so that no cell is cut.

#include <problem/geometries/boundaries.h>
#include <problem/geometries/checks.h>
#include <problem/geometries/quad_mesh.h>
#include <problem/geometries/slit_square.h>

#include <deal.II/base/patterns.h>

#include <cmath>

namespace MixedCracks
{
  namespace
  {
    constexpr dealii::types::boundary_id slit_lower = n_box_sides;
    constexpr dealii::types::boundary_id slit_upper = n_box_sides + 1;
  } // namespace



  std::string
  SlitSquare::subsection() const
  {
    return dim == 2 ? "Geometry/Slit square/" : "Geometry/Slit cube/";
  }



  void
  SlitSquare::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.add_parameter("Size",
                      size,
                      dim == 2
                        ? "Side of the square, whose lower left corner is the "
                          "origin; mm."
                        : "Edge of the cube, whose least corner is the origin; "
                          "mm.",
                      Double(0.));
    prm.add_parameter(
      "Slit height",
      slit_height,
      std::string("y of the slit, which enters from the left ") +
        (dim == 2 ? "edge; mm." : "face; mm."),
      Double(0.));
    prm.add_parameter("Slit length",
                      slit_length,
                      "Length of the slit in x; mm. Its nodes are doubled (but "
                      "for the tip), and the phase field is 0 on it.",
                      Double(0.));
    add_cell_size(prm, cell_size);
    mirrored.add_parameters(prm);
  }



  void
  SlitSquare::check() const
  {
    require_positive(size, subsection() + "Size");
    require_cell_size(
      cell_size, std::vector<double>(dim, size), subsection() + "Cell size");
    const auto check_inside = [this](const double       value,
                                     const std::string &entry) {
      require(value >= 1e-3 * cell_size && value <= size - 1e-3 * cell_size,
              subsection() + entry + " is " + number_text(value) +
                " mm; it must lie between 0 and the size of " +
                number_text(size) +
                " mm, at least a thousandth of the cell size away from both.");
    };
    check_inside(slit_height, "Slit height");
    check_inside(slit_length, "Slit length");
    mirrored.check(subsection(), fixed_lines(), cell_size);
  }



  std::array<std::vector<double>, 2>
  SlitSquare::fixed_lines() const
  {
    return {{{0., slit_length, size}, {0., slit_height, size}}};
  }



  NamedBoundaries
  SlitSquare::more_boundary_ids() const
  {
    return {{"slit", {slit_lower, slit_upper}},
            {"slit lower", slit_lower},
            {"slit upper", slit_upper}};
  }



  dealii::BoundingBox<2>
  SlitSquare::extent() const
  {
    return dealii::BoundingBox<2>(
      {dealii::Point<2>(), dealii::Point<2>(size, size)});
  }



  void
  SlitSquare::create(dealii::Triangulation<2> &plane) const
  {
    const std::array<std::vector<double>, 2> fixed = fixed_lines();
    QuadMesh mesh = tensor_mesh(mirrored.lines(0, fixed[0], cell_size),
                                mirrored.lines(1, fixed[1], cell_size));
    mesh.open_slit({slit_length, slit_height});
    mesh.create(plane);

    set_boundary_ids_by_center(plane, [this](const dealii::Point<2> &center) {
      const auto side = box_side_at(center, size, size);
      return side ? dealii::types::boundary_id(*side) : slit_lower;
    });
    split_slit(plane, slit_lower, slit_upper);
  }



  std::vector<Segment<2>>
  SlitSquare::slits() const
  {
    return {{{0., slit_height}, {slit_length, slit_height}}};
  }



  std::map<std::string, dealii::Point<2>>
  SlitSquare::named_points() const
  {
    return {{"slit tip", {slit_length, slit_height}}};
  }



  std::optional<double>
  SlitSquare::own_thickness() const
  {
    return size;
  }



  std::vector<double>
  SlitSquare::own_layers() const
  {
    return grid_lines({0., size}, cell_size);
  }



  double
  SlitSquare::n_cells() const
  {
    return std::pow(size / cell_size, 1. * dim);
  }



  std::unique_ptr<PlaneFigure>
  SlitSquare::coarser(const double factor) const
  {
    auto result = std::make_unique<SlitSquare>(*this);
    result->cell_size *= factor;
    return result;
  }
} // namespace MixedCracks
