// SPDX-License-Identifier: GPL-2.0-or-later
// Refinement from the start, by regions: a cell of level L is cut as long as L
// < n_global + levels of a region that it meets. A box is met if the
// intersection with the bounding box of the cell has a measure (but for 1e-6 of
// the cell); the surroundings of boundary pieces if centre and piece are nearer
// than distance + diameter/(2 sqrt(dim)), half an edge of a cube.

#include <discretization/refinement.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace
  {
    template <int dim>
    bool
    overlap(const dealii::BoundingBox<dim> &a,
            const dealii::BoundingBox<dim> &b)
    {
      for (unsigned int d = 0; d < dim; ++d)
      {
        // boxes along grid lines would else catch one more row of cells
        const double tolerance = 1e-6 * (a.upper_bound(d) - a.lower_bound(d));
        if (a.upper_bound(d) <= b.lower_bound(d) + tolerance ||
            a.lower_bound(d) >= b.upper_bound(d) - tolerance)
          return false;
      }
      return true;
    }



    template <int dim>
    bool
    is_near(const CellExtent<dim>             &cell,
            const RefinementSurroundings<dim> &region)
    {
      const double reach =
        region.distance + 0.5 * cell.diameter / std::sqrt(1. * dim);
      return std::any_of(
        region.pieces.begin(), region.pieces.end(), [&](const auto &piece) {
          return distance(cell.center, piece) < reach;
        });
    }
  } // namespace



  template <int dim>
  unsigned int
  wanted_levels(const CellExtent<dim>        &cell,
                const RefinementRegions<dim> &regions)
  {
    unsigned int levels = 0;
    for (const RefinementBox<dim> &box : regions.boxes)
      if (overlap(cell.box, box.box))
        levels = std::max(levels, box.levels);
    for (const RefinementSurroundings<dim> &region : regions.surroundings)
      if (region.levels > levels && is_near<dim>(cell, region))
        levels = region.levels;
    return levels;
  }



  template <int dim>
  bool
  is_refined(const dealii::TriaIterator<dealii::CellAccessor<dim>> &cell,
             const unsigned int                                     n_global,
             const RefinementRegions<dim>                          &regions)
  {
    return static_cast<unsigned int>(cell->level()) <
           n_global +
             wanted_levels<dim>(
               {cell->bounding_box(), cell->center(), cell->diameter()},
               regions);
  }



  template <int dim>
  void
  refine_globally_and_in_regions(dealii::Triangulation<dim>   &triangulation,
                                 const unsigned int            n_global,
                                 const RefinementRegions<dim> &regions)
  {
    triangulation.refine_global(n_global);
    unsigned int n_rounds = 0;
    for (const RefinementBox<dim> &box : regions.boxes)
      n_rounds = std::max(n_rounds, box.levels);
    for (const RefinementSurroundings<dim> &region : regions.surroundings)
      n_rounds = std::max(n_rounds, region.levels);

    // as many rounds on every rank, whether it has cells to refine or not
    for (unsigned int round = 0; round < n_rounds; ++round)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() &&
            is_refined<dim>(cell, n_global, regions))
          cell->set_refine_flag();
      triangulation.execute_coarsening_and_refinement();
    }
  }



  template unsigned int wanted_levels(const CellExtent<2> &,
                                      const RefinementRegions<2> &);
  template unsigned int wanted_levels(const CellExtent<3> &,
                                      const RefinementRegions<3> &);
  template void refine_globally_and_in_regions(dealii::Triangulation<2> &,
                                               unsigned int,
                                               const RefinementRegions<2> &);
  template void refine_globally_and_in_regions(dealii::Triangulation<3> &,
                                               unsigned int,
                                               const RefinementRegions<3> &);
  template bool
  is_refined(const dealii::TriaIterator<dealii::CellAccessor<2>> &,
             unsigned int,
             const RefinementRegions<2> &);
  template bool
  is_refined(const dealii::TriaIterator<dealii::CellAccessor<3>> &,
             unsigned int,
             const RefinementRegions<3> &);
} // namespace MixedCracks
