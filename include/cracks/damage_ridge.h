// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_damage_ridge_h
#define mixed_cracks_cracks_damage_ridge_h

#include <base/linear_algebra.h>

#include <deal.II/base/point.h>

#include <discretization/fields.h>

#include <array>
#include <vector>

namespace MixedCracks
{
  /// A piece of the mid surface of damage within one cell.
  struct RidgeTriangle
  {
    static constexpr int inside = -1;

    std::array<dealii::Point<3>, 3> corners;     ///< mm
    std::array<double, 3>           phase_field; ///< at the corners
    /// the id of the boundary of the body on which the side from corner i to
    /// corner i + 1 lies, or inside
    std::array<int, 3> boundary = {{inside, inside, inside}};
  };

  /// The mid surface of damage in a body, and the size of the cells there.
  struct DamageRidge
  {
    /// all of them on rank 0, none elsewhere; in an order that does not depend
    /// on the number of ranks
    std::vector<RidgeTriangle> triangles;
    /// mm, the smallest of the damaged cells, on all ranks; 0 without any
    double cell_size = 0.;
  };

  /// Where damage 1 - phi, smoothed over 0.35 l, is largest across the band:
  /// the height ridge of Eberly, Ridges in Image and Data Analysis (Kluwer,
  /// 1996). With the damage w, its gradient g, and the eigenvector n of the
  /// smallest eigenvalue of its second derivatives,
  ///
  ///   g . n = 0,   n . grad(grad w) n < 0.
  ///
  /// n has no sign; in a cell the eight values g . n are given signs that
  /// agree, and cut by marching cubes [Furst and Pizer, Marching Ridges, SIP
  /// 2001]. There is one sheet, and none where damage follows the boundary. It
  /// goes on ahead of a crack, into damage that holds still: trace_sheets()
  /// cuts it. @p phase_field with ghosts; @p length_scale: l, mm. Collective.
  DamageRidge damage_ridge(const Fields<3>             &fields,
                           const LinearAlgebra::Vector &phase_field,
                           double                       length_scale);
} // namespace MixedCracks

#endif
