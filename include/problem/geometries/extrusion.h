// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_extrusion_h
#define mixed_cracks_problem_geometries_extrusion_h

#include <base/flat_piece.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  // What a geometry in the plane is in 3-d: the same for every z from 0 to a
  // thickness. For dim = 2 the functions below ignore the thickness. Lengths
  // in mm.

  /// Make a plane mesh thick: a layer of cells between each two of @p z,
  /// ascending from 0. Boundary ids of @p plane stay, doubled nodes stay
  /// doubled; the ends get the ids `back` (z = 0) and `front`. Manifolds are
  /// not taken over.
  void extrude(const dealii::Triangulation<2> &plane,
               const std::vector<double>      &z,
               dealii::Triangulation<3>       &triangulation);

  /// Heights of @p n_layers equal layers from 0 to @p thickness.
  std::vector<double> equal_layers(double thickness, unsigned int n_layers);

  /// The entry "Thickness cells" of a geometry whose subsection is entered.
  void add_thickness_cells(dealii::ParameterHandler &prm,
                           unsigned int             &thickness_cells);

  /// Throws InputError when there would be too many cells. @p subsection: with
  /// a slash at its end.
  void require_thickness_cells(unsigned int       thickness_cells,
                               double             n_cells_in_plane,
                               const std::string &subsection);

  /// What a point becomes: in 3-d a line.
  template <int dim>
  FlatPiece<dim> extruded_point(const dealii::Point<2> &point,
                                double                  thickness);

  /// What a segment becomes: in 3-d a rectangle.
  template <int dim>
  FlatPiece<dim> extruded_segment(const dealii::Point<2> &begin,
                                  const dealii::Point<2> &end,
                                  double                  thickness);

  /// What a box becomes.
  template <int dim>
  dealii::BoundingBox<dim> extruded_box(const dealii::BoundingBox<2> &box,
                                        double thickness);
} // namespace MixedCracks

#endif
