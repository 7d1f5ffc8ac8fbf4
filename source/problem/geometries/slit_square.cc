// SPDX-License-Identifier: GPL-2.0-or-later
#include <problem/geometries/boundaries.h>
#include <problem/geometries/checks.h>
#include <problem/geometries/extrusion.h>
#include <problem/geometries/quad_mesh.h>
#include <problem/geometries/slit_square.h>

#include <deal.II/base/patterns.h>

#include <cmath>

namespace MixedCracks
{
  namespace
  {
    constexpr dealii::types::boundary_id slit = n_box_sides;

    template <int dim>
    std::string
    subsection()
    {
      return dim == 2 ? "Geometry/Slit square/" : "Geometry/Slit cube/";
    }
  } // namespace



  template <int dim>
  void
  SlitSquare<dim>::add_parameters(dealii::ParameterHandler &prm)
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
    require_positive(size, subsection<dim>() + "Size");
    require_cell_size(cell_size,
                      std::vector<double>(dim, size),
                      subsection<dim>() + "Cell size");
    const auto check_inside = [this](const double       value,
                                     const std::string &entry) {
      require(value >= 1e-3 * cell_size && value <= size - 1e-3 * cell_size,
              subsection<dim>() + entry + " is " + number_text(value) +
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
    auto ids    = box_side_ids<dim>();
    ids["slit"] = slit;
    return ids;
  }



  template <int dim>
  std::optional<dealii::BoundingBox<dim>>
  SlitSquare<dim>::extent() const
  {
    return extruded_box<dim>(size, size, size);
  }



  template <int dim>
  void
  SlitSquare<dim>::create_square(dealii::Triangulation<2> &square) const
  {
    QuadMesh mesh = tensor_mesh(grid_lines({0., slit_length, size}, cell_size),
                                grid_lines({0., slit_height, size}, cell_size));
    mesh.open_slit({slit_length, slit_height});
    mesh.create(square);

    set_boundary_ids_by_center(square, [this](const dealii::Point<2> &center) {
      const auto side = box_side_at(center, size, size);
      return side ? dealii::types::boundary_id(*side) : slit;
    });
  }



  template <int dim>
  void
  SlitSquare<dim>::create(dealii::Triangulation<dim> &triangulation) const
  {
    if constexpr (dim == 2)
      create_square(triangulation);
    else
    {
      dealii::Triangulation<2> square;
      create_square(square);
      extrude(square, grid_lines({0., size}, cell_size), triangulation);
    }
  }



  template <int dim>
  std::vector<FlatPiece<dim>>
  SlitSquare<dim>::slits() const
  {
    return {extruded_segment<dim>(
      {0., slit_height}, {slit_length, slit_height}, size)};
  }



  template <int dim>
  std::map<std::string, FlatPiece<dim>>
  SlitSquare<dim>::named_places() const
  {
    return {
      {"slit tip", extruded_point<dim>({slit_length, slit_height}, size)}};
  }



  template <int dim>
  std::optional<double>
  SlitSquare<dim>::n_coarse_cells() const
  {
    return std::pow(size / cell_size, 1. * dim);
  }



  template <int dim>
  std::unique_ptr<Geometry<dim>>
  SlitSquare<dim>::coarser(const double factor) const
  {
    auto result = std::make_unique<SlitSquare>(*this);
    result->cell_size *= factor;
    return result;
  }



  template class SlitSquare<2>;
  template class SlitSquare<3>;
} // namespace MixedCracks
