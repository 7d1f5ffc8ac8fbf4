// SPDX-License-Identifier: GPL-2.0-or-later
#include <problem/geometries/boundaries.h>
#include <problem/geometries/checks.h>
#include <problem/geometries/extrusion.h>
#include <problem/geometries/punctured_strip.h>

#include <deal.II/base/patterns.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace
  {
    constexpr dealii::types::boundary_id hole  = n_box_sides;
    constexpr dealii::types::boundary_id notch = n_box_sides + 1;

    constexpr dealii::types::manifold_id circle_manifold = 1;
    constexpr dealii::types::manifold_id ring_manifold   = 2;

    const std::string subsection = "Geometry/Punctured strip/";
  } // namespace



  template <int dim>
  void
  PuncturedStrip<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.add_parameter(
      "Width", measures.width, "Extent in x, from x = 0; mm.", Double(0.));
    prm.add_parameter(
      "Height", measures.height, "Extent in y, from y = 0; mm.", Double(0.));
    prm.add_parameter("Hole center",
                      measures.hole_center,
                      "Centre of the circular hole, x, y; mm.",
                      List(Double(), 2, 2));
    prm.add_parameter("Hole radius",
                      measures.hole_radius,
                      "Radius of the hole; mm. 0: no hole.",
                      Double(0.));
    prm.add_parameter("Notch height",
                      measures.notch_height,
                      "y of the notch, a sharp horizontal slit from the left "
                      "edge; mm.",
                      Double());
    prm.add_parameter("Notch length",
                      measures.notch_length,
                      "Length of the notch; mm. 0: no notch. The nodes on "
                      "the slit are doubled (but for its tip), and the phase "
                      "field is 0 on it.",
                      Double(0.));
    prm.add_parameter("Cell size",
                      measures.cell_size,
                      "Wanted size of the cells of the coarse mesh, before "
                      "refinement; mm.",
                      Double(0.));
    add_thickness_cells(prm, thickness_cells);
  }



  template <int dim>
  void
  PuncturedStrip<dim>::check() const
  {
    require_positive(measures.width, subsection + "Width");
    require_positive(measures.height, subsection + "Height");
    require_cell_size(measures.cell_size,
                      {measures.width, measures.height},
                      subsection + "Cell size");
    if (dim == 3)
      require_thickness_cells(thickness_cells,
                              measures.width * measures.height /
                                (measures.cell_size * measures.cell_size),
                              subsection);
    if (measures.has_hole())
      check_hole();
    if (measures.has_notch())
      check_notch();
  }



  template <int dim>
  void
  PuncturedStrip<dim>::check_hole() const
  {
    const double radius = measures.hole_radius;
    const double x      = measures.hole_center[0];
    const double y      = measures.hole_center[1];
    const double room =
      std::min({x, measures.width - x, y, measures.height - y}) - radius;

    require(std::isfinite(radius) && radius >= 1e-3 * measures.cell_size,
            subsection + "Hole radius is " + number_text(radius) +
              " mm; a hole needs at least a thousandth of the cell size of " +
              number_text(measures.cell_size) + " mm (0: no hole).");
    require(
      room >= smallest_ligament * radius,
      subsection + "Hole center is " + point_text({x, y}) + " with radius " +
        number_text(radius) + ": the hole must lie inside the strip of " +
        number_text(measures.width) + " x " + number_text(measures.height) +
        " mm and leave at least " + number_text(smallest_ligament * radius) +
        " mm to each edge; it leaves " + number_text(room) + " mm.");
  }



  template <int dim>
  void
  PuncturedStrip<dim>::check_notch() const
  {
    const double length = measures.notch_length;
    const double height = measures.notch_height;
    require(std::isfinite(length) && length < measures.width,
            subsection + "Notch length is " + number_text(length) +
              " mm; it must be less than the width of " +
              number_text(measures.width) + " mm.");
    require(length >= 1e-3 * measures.cell_size,
            subsection + "Notch length is " + number_text(length) +
              " mm; a notch needs at least a thousandth of the cell size of " +
              number_text(measures.cell_size) + " mm (0: no notch).");
    require(height > 0. && height < measures.height,
            subsection + "Notch height is " + number_text(height) +
              " mm; it must lie between 0 and the height of " +
              number_text(measures.height) + " mm, both excluded.");
    if (!measures.has_hole())
      return;

    const dealii::Point<2> &center = measures.hole_center;
    const double            radius = measures.hole_radius;
    const double            room   = smallest_ligament * radius;
    const std::string       found  = subsection + "Notch height is " +
                              number_text(height) + " and Notch length " +
                              number_text(length) + " mm: ";
    const std::string about_hole = "the hole of radius " + number_text(radius) +
                                   " at " + point_text({center[0], center[1]});
    const dealii::Point<2> nearest(std::min(length, center[0]), height);
    require(nearest.distance(center) > radius,
            found + "the notch runs into " + about_hole + ".");
    require(notch_clearance(measures) >= room,
            found + "the notch is too close to " + about_hole +
              " for a mesh around it; it must end at x <= " +
              number_text(center[0] - radius - room) +
              " or run at y <= " + number_text(center[1] - radius - room) +
              " or y >= " + number_text(center[1] + radius + room) +
              " mm (or give a mesh file).");
  }



  template <int dim>
  std::map<std::string, dealii::types::boundary_id>
  PuncturedStrip<dim>::boundary_ids() const
  {
    auto ids = box_side_ids<dim>();
    if (measures.has_hole())
      ids["hole"] = hole;
    if (measures.has_notch())
      ids["notch"] = notch;
    return ids;
  }



  template <int dim>
  std::optional<dealii::BoundingBox<dim>>
  PuncturedStrip<dim>::extent() const
  {
    return extruded_box<dim>(
      measures.width, measures.height, this->thickness());
  }



  template <int dim>
  void
  PuncturedStrip<dim>::create(dealii::Triangulation<dim> &triangulation) const
  {
    create_extruded(
      [this](dealii::Triangulation<2> &plane) { create_plane(plane); },
      this->thickness(),
      thickness_cells,
      triangulation);
    if (measures.has_hole())
      set_manifolds(triangulation);
  }



  template <int dim>
  std::map<std::string, FlatPiece<dim>>
  PuncturedStrip<dim>::named_places() const
  {
    if (!measures.has_notch())
      return {};
    return {{"notch tip",
             extruded_point<dim>(measures.notch_tip(), this->thickness())}};
  }



  template <int dim>
  std::vector<FlatPiece<dim>>
  PuncturedStrip<dim>::slits() const
  {
    if (!measures.has_notch())
      return {};
    return {extruded_segment<dim>(
      {0., measures.notch_height}, measures.notch_tip(), this->thickness())};
  }



  template <int dim>
  void
  PuncturedStrip<dim>::create_plane(dealii::Triangulation<2> &plane) const
  {
    strip_mesh(measures).create(plane);
    set_boundary_ids(plane);
  }



  template <int dim>
  void
  PuncturedStrip<dim>::set_boundary_ids(dealii::Triangulation<2> &plane) const
  {
    const double tolerance = 1e-9 * (measures.width + measures.height);
    set_boundary_ids_by_center(plane, [&](const dealii::Point<2> &center) {
      if (const auto side =
            box_side_at(center, measures.width, measures.height))
        return dealii::types::boundary_id(*side);
      const bool on_notch =
        measures.has_notch() &&
        std::abs(center[1] - measures.notch_height) < tolerance &&
        center[0] < measures.notch_length;
      return on_notch ? notch : hole;
    });
  }



  namespace
  {
    // circle in 2-d, cylinder along z in 3-d
    template <int dim>
    std::unique_ptr<dealii::Manifold<dim>>
    round_hole(const dealii::Point<2> &center)
    {
      if constexpr (dim == 2)
        return std::make_unique<dealii::SphericalManifold<2>>(center);
      else
        return std::make_unique<dealii::CylindricalManifold<3>>(
          dealii::Tensor<1, 3>({0., 0., 1.}),
          dealii::Point<3>(center[0], center[1], 0.));
    }



    // of a cell beside the hole; in 3-d its ends in z as well, whose plane
    // holds a piece of the circle
    template <typename Cell>
    void
    set_ring_manifold(const Cell &cell)
    {
      cell->set_manifold_id(ring_manifold);
      if (Cell::AccessorType::dimension == 3)
        for (const unsigned int face : {4, 5})
          cell->face(face)->set_manifold_id(ring_manifold);
    }
  } // namespace



  // The hole is exactly round; in the cells beside it new points are
  // interpolated between the hole and the straight other sides.
  template <int dim>
  void
  PuncturedStrip<dim>::set_manifolds(
    dealii::Triangulation<dim> &triangulation) const
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            cell->face(f)->boundary_id() == hole)
        {
          set_ring_manifold(cell);
          // in 3-d with its edges
          cell->face(f)->set_all_manifold_ids(circle_manifold);
        }
    triangulation.set_manifold(circle_manifold,
                               *round_hole<dim>(measures.hole_center));
    dealii::TransfiniteInterpolationManifold<dim> ring;
    ring.initialize(triangulation);
    triangulation.set_manifold(ring_manifold, ring);
  }



  template <int dim>
  std::optional<double>
  PuncturedStrip<dim>::n_coarse_cells() const
  {
    return measures.width * measures.height /
           (measures.cell_size * measures.cell_size) *
           (dim == 3 ? thickness_cells : 1.);
  }



  template <int dim>
  std::unique_ptr<Geometry<dim>>
  PuncturedStrip<dim>::coarser(const double factor) const
  {
    auto result = std::make_unique<PuncturedStrip>(*this);
    result->measures.cell_size *= factor;
    result->thickness_cells = coarser_number(thickness_cells, factor);
    return result;
  }



  template class PuncturedStrip<2>;
  template class PuncturedStrip<3>;
} // namespace MixedCracks
