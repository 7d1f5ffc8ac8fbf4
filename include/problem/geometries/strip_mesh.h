// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_strip_mesh_h
#define mixed_cracks_problem_geometries_strip_mesh_h

#include <problem/geometries/mirrored_mesh.h>
#include <problem/geometries/quad_mesh.h>

namespace MixedCracks
{
  /// The measures of a punctured strip [0, width] x [0, height]; mm.
  struct StripMeasures
  {
    double           width        = 20.;
    double           height       = 28.;
    dealii::Point<2> hole_center  = dealii::Point<2>(12., 18.);
    double           hole_radius  = 4.; ///< 0: no hole
    double           notch_height = 12.;
    double           notch_length = 1.; ///< 0: no notch
    double           cell_size    = 1.2;
    MirroredMesh     mirrored;

    bool
    has_hole() const
    {
      return hole_radius > 0.;
    }

    bool
    has_notch() const
    {
      return notch_length > 0.;
    }

    dealii::Point<2>
    notch_tip() const
    {
      return {notch_length, notch_height};
    }
  };

  /// The box around the hole that a ring of cells fills; outside of it cells
  /// are rectangles. Its sides avoid thin cells beside the strip's edges and
  /// the notch, and the notch ends outside of it or on it.
  struct HoleBox
  {
    double left, right, bottom, top;
  };

  /// How much room each side of the box needs at least, in hole radii; a
  /// hole closer to an edge or to the notch cannot be meshed.
  constexpr double smallest_ligament = 0.02;

  /// How much room the notch leaves beside the hole's bounding square, on
  /// the side where it leaves most; mm. At least smallest_ligament * radius
  /// is needed.
  double notch_clearance(const StripMeasures &measures);

  /// Needs measures that PuncturedStrip::check() accepts, with a hole.
  HoleBox hole_box(const StripMeasures &measures);

  /// The lines of x and of y that the mesh must have: edges, the notch, the box
  /// around the hole with its middle where it would have one cell.
  std::array<std::vector<double>, 2> fixed_lines(const StripMeasures &measures);

  /// The coarse mesh, slit opened.
  QuadMesh strip_mesh(const StripMeasures &measures);
} // namespace MixedCracks

#endif
