// SPDX-License-Identifier: GPL-2.0-or-later
// What the geometries that are figures in the plane have in common: the body
//
//   2-d: the figure        3-d: figure x [0, t],   t = Material/Thickness,
//
// unless the figure says itself how thick it is (the slit cube). In 3-d points
// become lines along z and segments rectangles, circles cylinders; boundaries
// keep their names, the ends are "back" (z = 0) and "front" (z = t).

#include <problem/geometries/boundaries.h>
#include <problem/geometries/checks.h>
#include <problem/geometries/extrusion.h>
#include <problem/geometries/plane_geometry.h>
#include <problem/geometries/round_hole.h>

namespace MixedCracks
{
  template <int dim>
  PlaneGeometry<dim>::PlaneGeometry(const PlaneGeometry &other,
                                    const double         factor)
    : Geometry<dim>(other)
    , figure(other.figure->coarser(factor))
    , thickness_cells(coarser_number(other.thickness_cells, factor))
  {}



  template <int dim>
  void
  PlaneGeometry<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    figure->add_parameters(prm);
    if (!figure->own_thickness())
      add_thickness_cells(prm, thickness_cells);
  }



  template <int dim>
  void
  PlaneGeometry<dim>::check() const
  {
    figure->check();
    if (dim == 3 && !figure->own_thickness())
      require_thickness_cells(
        thickness_cells, figure->n_grid_cells(), figure->subsection());
  }



  template <int dim>
  NamedBoundaries
  PlaneGeometry<dim>::boundary_ids() const
  {
    auto       ids  = box_side_ids<dim>();
    const auto more = figure->more_boundary_ids();
    ids.insert(more.begin(), more.end());
    return ids;
  }



  template <int dim>
  std::optional<dealii::BoundingBox<dim>>
  PlaneGeometry<dim>::extent() const
  {
    return extruded_box<dim>(figure->extent(), depth());
  }



  template <int dim>
  void
  PlaneGeometry<dim>::create(dealii::Triangulation<dim> &triangulation) const
  {
    if constexpr (dim == 2)
      figure->create(triangulation);
    else
    {
      dealii::Triangulation<2> plane;
      figure->create(plane);
      extrude(plane,
              figure->own_thickness() ? figure->own_layers()
                                      : equal_layers(depth(), thickness_cells),
              triangulation);
    }
    if (const auto hole = figure->round_hole())
      make_round(hole->boundary, hole->center, triangulation);
  }



  template <int dim>
  std::map<std::string, FlatPiece<dim>>
  PlaneGeometry<dim>::named_places() const
  {
    std::map<std::string, FlatPiece<dim>> places;
    for (const auto &[name, point] : figure->named_points())
      places.emplace(name, extruded_point<dim>(point, depth()));
    return places;
  }



  template <int dim>
  std::vector<FlatPiece<dim>>
  PlaneGeometry<dim>::slits() const
  {
    std::vector<FlatPiece<dim>> pieces;
    for (const Segment<2> &slit : figure->slits())
      pieces.push_back(extruded_segment<dim>(slit.begin, slit.end, depth()));
    return pieces;
  }



  template class PlaneGeometry<2>;
  template class PlaneGeometry<3>;
} // namespace MixedCracks
