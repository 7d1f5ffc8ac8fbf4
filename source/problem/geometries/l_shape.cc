// SPDX-License-Identifier: GPL-2.0-or-later
#include <problem/geometries/boundaries.h>
#include <problem/geometries/checks.h>
#include <problem/geometries/extrusion.h>
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

    const std::string subsection = "Geometry/L-shape/";
  } // namespace



  template <int dim>
  void
  LShape<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.add_parameter("Size",
                      size,
                      "Side of the square, whose lower left corner is the "
                      "origin; mm. Its lower right quadrant is removed.",
                      Double(0.));
    prm.add_parameter("Cell size",
                      cell_size,
                      "Wanted size of the cells of the coarse mesh, before "
                      "refinement; mm.",
                      Double(0.));
    add_thickness_cells(prm, thickness_cells);
  }



  template <int dim>
  void
  LShape<dim>::check() const
  {
    require_positive(size, subsection + "Size");
    require_cell_size(cell_size, {size, size}, subsection + "Cell size");
    if (dim == 3)
      require_thickness_cells(
        thickness_cells, size * size / (cell_size * cell_size), subsection);
  }



  template <int dim>
  std::map<std::string, dealii::types::boundary_id>
  LShape<dim>::boundary_ids() const
  {
    auto ids                    = box_side_ids<dim>();
    ids["reentrant horizontal"] = reentrant_horizontal;
    ids["reentrant vertical"]   = reentrant_vertical;
    return ids;
  }



  template <int dim>
  std::optional<dealii::BoundingBox<dim>>
  LShape<dim>::extent() const
  {
    return extruded_box<dim>(size, size, this->thickness());
  }



  template <int dim>
  void
  LShape<dim>::create_plane(dealii::Triangulation<2> &plane) const
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



  template <int dim>
  void
  LShape<dim>::create(dealii::Triangulation<dim> &triangulation) const
  {
    create_extruded(
      [this](dealii::Triangulation<2> &plane) { create_plane(plane); },
      this->thickness(),
      thickness_cells,
      triangulation);
  }



  template <int dim>
  std::optional<double>
  LShape<dim>::n_coarse_cells() const
  {
    return 0.75 * std::pow(size / cell_size, 2.) *
           (dim == 3 ? thickness_cells : 1.);
  }



  template <int dim>
  std::unique_ptr<Geometry<dim>>
  LShape<dim>::coarser(const double factor) const
  {
    auto result = std::make_unique<LShape>(*this);
    result->cell_size *= factor;
    result->thickness_cells = coarser_number(thickness_cells, factor);
    return result;
  }



  template class LShape<2>;
  template class LShape<3>;
} // namespace MixedCracks
