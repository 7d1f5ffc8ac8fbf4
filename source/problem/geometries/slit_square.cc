// SPDX-License-Identifier: GPL-2.0-or-later
#include <problem/geometries/boundaries.h>
#include <problem/geometries/checks.h>
#include <problem/geometries/quad_mesh.h>
#include <problem/geometries/slit_square.h>

#include <deal.II/base/patterns.h>

namespace MixedCracks
{
  namespace
  {
    constexpr dealii::types::boundary_id slit = n_box_sides;

    const std::string subsection = "Geometry/Slit square/";
  } // namespace



  template <int dim>
  void
  SlitSquare<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.add_parameter("Size",
                      size,
                      "Side of the square, whose lower left corner is the "
                      "origin; mm.",
                      Double(0.));
    prm.add_parameter("Slit height",
                      slit_height,
                      "y of the slit, which enters from the left edge; mm.",
                      Double(0.));
    prm.add_parameter("Slit length",
                      slit_length,
                      "Length of the slit; mm. Its nodes are doubled (but "
                      "for the tip), and the phase field is 0 on it.",
                      Double(0.));
    prm.add_parameter("Cell size",
                      cell_size,
                      "Wanted size of the cells of the coarse mesh, before "
                      "refinement; mm.",
                      Double(0.));
  }



  template <int dim>
  void
  SlitSquare<dim>::check() const
  {
    require_positive(size, subsection + "Size");
    require_cell_size(cell_size, {size, size}, subsection + "Cell size");
    const auto check_inside = [this](const double       value,
                                     const std::string &entry) {
      require(value >= 1e-3 * cell_size && value <= size - 1e-3 * cell_size,
              subsection + entry + " is " + number_text(value) +
                " mm; it must lie between 0 and the size of " +
                number_text(size) +
                " mm, at least a thousandth of the cell size away from both.");
    };
    check_inside(slit_height, "Slit height");
    check_inside(slit_length, "Slit length");
  }



  template <int dim>
  std::map<std::string, dealii::types::boundary_id>
  SlitSquare<dim>::boundary_ids() const
  {
    auto ids    = box_side_ids();
    ids["slit"] = slit;
    return ids;
  }



  template <int dim>
  std::optional<dealii::BoundingBox<dim>>
  SlitSquare<dim>::extent() const
  {
    return dealii::BoundingBox<dim>({{0., 0.}, {size, size}});
  }



  template <int dim>
  void
  SlitSquare<dim>::create(dealii::Triangulation<dim> &triangulation) const
  {
    QuadMesh mesh = tensor_mesh(grid_lines({0., slit_length, size}, cell_size),
                                grid_lines({0., slit_height, size}, cell_size));
    mesh.open_slit({slit_length, slit_height});
    mesh.create(triangulation);

    set_boundary_ids_by_center(
      triangulation, [this](const dealii::Point<dim> &center) {
        const auto side = box_side_at(center, size, size);
        return side ? dealii::types::boundary_id(*side) : slit;
      });
  }



  template <int dim>
  std::vector<Segment<dim>>
  SlitSquare<dim>::slits() const
  {
    return {{dealii::Point<dim>(0., slit_height),
             dealii::Point<dim>(slit_length, slit_height)}};
  }



  template <int dim>
  std::map<std::string, dealii::Point<dim>>
  SlitSquare<dim>::named_points() const
  {
    return {{"slit tip", slits().front().end}};
  }



  template class SlitSquare<2>;
} // namespace MixedCracks
