// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_refinement_h
#define mixed_cracks_discretization_refinement_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace MixedCracks
{
  /// Refine cells here so many levels beyond the global refinement.
  template <int dim>
  struct RefinementBox
  {
    dealii::BoundingBox<dim> box; ///< mm
    unsigned int             levels;
  };

  /// Halve every cell of a coarse mesh @p n_global times, then every cell
  /// that overlaps a box until it is the box's levels finer (the highest
  /// where boxes overlap; touching a box is not enough). Works on serial and
  /// on parallel::distributed triangulations; every rank calls it.
  template <int dim>
  void
  refine_globally_and_in_boxes(dealii::Triangulation<dim> &triangulation,
                               unsigned int                n_global,
                               const std::vector<RefinementBox<dim>> &boxes);
} // namespace MixedCracks

#endif
