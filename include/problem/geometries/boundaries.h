// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_boundaries_h
#define mixed_cracks_problem_geometries_boundaries_h

#include <deal.II/grid/tria.h>

#include <discretization/boundary_ids.h>

#include <optional>

namespace MixedCracks
{
  /// Ids of the sides of a box, back (least z) and front in 3-d only; what else
  /// a geometry has counts on from n_box_sides.
  enum BoxSide : dealii::types::boundary_id
  {
    left,
    right,
    bottom,
    top,
    back,
    front,
    n_box_sides
  };

  template <int dim>
  NamedBoundaries
  box_side_ids()
  {
    NamedBoundaries ids = {{"left", BoundaryIds(left)},
                           {"right", BoundaryIds(right)},
                           {"bottom", BoundaryIds(bottom)},
                           {"top", BoundaryIds(top)}};
    if (dim == 3)
    {
      ids["back"]  = back;
      ids["front"] = front;
    }
    return ids;
  }

  /// The side of the box in the plane from the origin to (@p width,
  /// @p height) that @p p lies on, if it does; mm.
  inline std::optional<BoxSide>
  box_side_at(const dealii::Point<2> &p,
              const double            width,
              const double            height)
  {
    const double tolerance = 1e-9 * (width + height);
    if (p[0] < tolerance)
      return left;
    if (p[0] > width - tolerance)
      return right;
    if (p[1] < tolerance)
      return bottom;
    if (p[1] > height - tolerance)
      return top;
    return {};
  }

  /// Give every boundary face of a coarse mesh the id that @p id_at says for
  /// the mean of its vertices. Every rank does this for the whole mesh.
  template <int dim, typename Function>
  void
  set_boundary_ids_by_center(dealii::Triangulation<dim> &triangulation,
                             const Function             &id_at)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(id_at(cell->face(f)->center()));
  }

  /// Give those faces of a plane mesh that have the id @p slit the id @p upper
  /// where the body is above them. Slits are horizontal.
  inline void
  split_slit(dealii::Triangulation<2>        &plane,
             const dealii::types::boundary_id slit,
             const dealii::types::boundary_id upper)
  {
    for (const auto &cell : plane.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            cell->face(f)->boundary_id() == slit &&
            cell->center()[1] > cell->face(f)->center()[1])
          cell->face(f)->set_boundary_id(upper);
  }
} // namespace MixedCracks

#endif
