// SPDX-License-Identifier: GPL-2.0-or-later
#include <discretization/refinement.h>

#include <algorithm>

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
    unsigned int
    wanted_levels(const dealii::BoundingBox<dim>        &extent,
                  const std::vector<RefinementBox<dim>> &boxes)
    {
      unsigned int levels = 0;
      for (const RefinementBox<dim> &box : boxes)
        if (overlap(extent, box.box))
          levels = std::max(levels, box.levels);
      return levels;
    }
  } // namespace



  template <int dim>
  void
  refine_globally_and_in_boxes(dealii::Triangulation<dim> &triangulation,
                               const unsigned int          n_global,
                               const std::vector<RefinementBox<dim>> &boxes)
  {
    triangulation.refine_global(n_global);
    unsigned int n_rounds = 0;
    for (const RefinementBox<dim> &box : boxes)
      n_rounds = std::max(n_rounds, box.levels);

    // as many rounds on every rank, whether it has cells to refine or not
    for (unsigned int round = 0; round < n_rounds; ++round)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() &&
            static_cast<unsigned int>(cell->level()) <
              n_global + wanted_levels(cell->bounding_box(), boxes))
          cell->set_refine_flag();
      triangulation.execute_coarsening_and_refinement();
    }
  }



  template void
  refine_globally_and_in_boxes(dealii::Triangulation<2> &,
                               unsigned int,
                               const std::vector<RefinementBox<2>> &);
} // namespace MixedCracks
