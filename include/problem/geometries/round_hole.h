// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_round_hole_h
#define mixed_cracks_problem_geometries_round_hole_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

namespace MixedCracks
{
  /// Make the faces of @p boundary, whose nodes lie on the circle around
  /// @p center, in 3-d on the cylinder along z, exactly round on refined
  /// meshes too; mm. No other boundary of @p triangulation may be round.
  template <int dim>
  void make_round(dealii::types::boundary_id  boundary,
                  const dealii::Point<2>     &center,
                  dealii::Triangulation<dim> &triangulation);
} // namespace MixedCracks

#endif
