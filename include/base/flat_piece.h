// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_flat_piece_h
#define mixed_cracks_base_flat_piece_h

#include <deal.II/base/point.h>

#include <array>

namespace MixedCracks
{
  /// A flat piece of a boundary, a slit or the like, in mm: a segment in 2-d, a
  /// plane quadrilateral in 3-d. Corners may coincide, so that a quadrilateral
  /// is a segment, or either of them a point.
  template <int dim>
  struct FlatPiece
  {
    /// In the order of the vertices of a face in deal.II.
    std::array<dealii::Point<dim>, (dim == 2 ? 2 : 4)> corners;

    /// The segment from @p begin to @p end, in 2-d and in 3-d.
    static FlatPiece segment(const dealii::Point<dim> &begin,
                             const dealii::Point<dim> &end);

    static FlatPiece
    point(const dealii::Point<dim> &position)
    {
      return segment(position, position);
    }
  };

  /// Distance of a point from the nearest point of @p piece, mm. Of a
  /// quadrilateral that is not plane, the two triangles beside the diagonal
  /// from its second to its third corner.
  template <int dim>
  double distance(const dealii::Point<dim> &point, const FlatPiece<dim> &piece);
} // namespace MixedCracks

#endif
