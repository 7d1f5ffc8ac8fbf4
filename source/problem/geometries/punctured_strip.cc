// SPDX-License-Identifier: GPL-2.0-or-later
//                top
//     +------------------------+ H    W, H: Width, Height
//     |            _____       |      (x, y), r: Hole center, Hole radius
//     |           /     \      |      a, b: Notch length, Notch height
//     |          |   *   |     | y
//     |           \_____/ hole |      notch: y = b, 0 <= x < a, its vertices
// left|                        |right doubled as in slit_square.cc
//     |==* notch tip           | b
//     |                        |      the specimen of [Mang21, Section 4] by
//     +------------------------+ 0    default: H = 28, W = 20, r = 4, a = 1 mm
//                bottom
//
// Checked are the lengths that a mesh needs: the hole leaves a ligament of at
// least smallest_ligament * r to each edge, the notch the same to the bounding
// square of the hole on one side of it. strip_mesh.cc makes the mesh.

#include <problem/geometries/boundaries.h>
#include <problem/geometries/checks.h>
#include <problem/geometries/punctured_strip.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace
  {
    constexpr dealii::types::boundary_id hole        = n_box_sides;
    constexpr dealii::types::boundary_id notch_lower = n_box_sides + 1;
    constexpr dealii::types::boundary_id notch_upper = n_box_sides + 2;

    const std::string strip_path = "Geometry/Punctured strip/";
  } // namespace



  std::string
  PuncturedStrip::subsection() const
  {
    return strip_path;
  }



  void
  PuncturedStrip::add_parameters(dealii::ParameterHandler &prm)
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
    add_cell_size(prm, measures.cell_size);
    measures.mirrored.add_parameters(prm);
  }



  void
  PuncturedStrip::check() const
  {
    require_positive(measures.width, strip_path + "Width");
    require_positive(measures.height, strip_path + "Height");
    require_cell_size(measures.cell_size,
                      {measures.width, measures.height},
                      strip_path + "Cell size");
    if (measures.has_hole())
      check_hole();
    if (measures.has_notch())
      check_notch();
    measures.mirrored.check(
      strip_path, fixed_lines(measures), measures.cell_size);
  }



  void
  PuncturedStrip::check_hole() const
  {
    const double radius = measures.hole_radius;
    const double x      = measures.hole_center[0];
    const double y      = measures.hole_center[1];
    const double room =
      std::min({x, measures.width - x, y, measures.height - y}) - radius;

    require(std::isfinite(radius) && radius >= 1e-3 * measures.cell_size,
            strip_path + "Hole radius is " + number_text(radius) +
              " mm; a hole needs at least a thousandth of the cell size of " +
              number_text(measures.cell_size) + " mm (0: no hole).");
    require(
      room >= smallest_ligament * radius,
      strip_path + "Hole center is " + point_text({x, y}) + " with radius " +
        number_text(radius) + ": the hole must lie inside the strip of " +
        number_text(measures.width) + " x " + number_text(measures.height) +
        " mm and leave at least " + number_text(smallest_ligament * radius) +
        " mm to each edge; it leaves " + number_text(room) + " mm.");
  }



  void
  PuncturedStrip::check_notch() const
  {
    const double length = measures.notch_length;
    const double height = measures.notch_height;
    require(std::isfinite(length) && length < measures.width,
            strip_path + "Notch length is " + number_text(length) +
              " mm; it must be less than the width of " +
              number_text(measures.width) + " mm.");
    require(length >= 1e-3 * measures.cell_size,
            strip_path + "Notch length is " + number_text(length) +
              " mm; a notch needs at least a thousandth of the cell size of " +
              number_text(measures.cell_size) + " mm (0: no notch).");
    require(height > 0. && height < measures.height,
            strip_path + "Notch height is " + number_text(height) +
              " mm; it must lie between 0 and the height of " +
              number_text(measures.height) + " mm, both excluded.");
    if (!measures.has_hole())
      return;

    const dealii::Point<2> &center = measures.hole_center;
    const double            radius = measures.hole_radius;
    const double            room   = smallest_ligament * radius;
    const std::string       found  = strip_path + "Notch height is " +
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



  NamedBoundaries
  PuncturedStrip::more_boundary_ids() const
  {
    NamedBoundaries ids;
    if (measures.has_hole())
      ids["hole"] = hole;
    if (measures.has_notch())
    {
      ids["notch"]       = {notch_lower, notch_upper};
      ids["notch lower"] = notch_lower;
      ids["notch upper"] = notch_upper;
    }
    return ids;
  }



  dealii::BoundingBox<2>
  PuncturedStrip::extent() const
  {
    return dealii::BoundingBox<2>(
      {dealii::Point<2>(), dealii::Point<2>(measures.width, measures.height)});
  }



  std::map<std::string, dealii::Point<2>>
  PuncturedStrip::named_points() const
  {
    if (!measures.has_notch())
      return {};
    return {{"notch tip", measures.notch_tip()}};
  }



  std::vector<Segment<2>>
  PuncturedStrip::slits() const
  {
    if (!measures.has_notch())
      return {};
    return {{{0., measures.notch_height}, measures.notch_tip()}};
  }



  std::optional<PlaneFigure::RoundHole>
  PuncturedStrip::round_hole() const
  {
    if (!measures.has_hole())
      return {};
    return RoundHole{hole, measures.hole_center};
  }



  void
  PuncturedStrip::create(dealii::Triangulation<2> &plane) const
  {
    strip_mesh(measures).create(plane);
    set_boundary_ids(plane);
  }



  void
  PuncturedStrip::set_boundary_ids(dealii::Triangulation<2> &plane) const
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
      return on_notch ? notch_lower : hole;
    });
    split_slit(plane, notch_lower, notch_upper);
  }



  double
  PuncturedStrip::n_cells() const
  {
    return measures.width * measures.height /
           (measures.cell_size * measures.cell_size);
  }



  std::unique_ptr<PlaneFigure>
  PuncturedStrip::coarser(const double factor) const
  {
    auto result = std::make_unique<PuncturedStrip>(*this);
    result->measures.cell_size *= factor;
    return result;
  }
} // namespace MixedCracks
