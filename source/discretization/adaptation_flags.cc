// SPDX-License-Identifier: GPL-2.0-or-later
// From places to flags. A cell of centre c and reach R (to its farthest vertex)
// is asked to be fine if a growing place is within margin + R of c, or a
// damaged one within kept_margin + R: if its ball meets the neighbourhood. A
// cell may become coarser if its parent is not asked for, it is intact at all
// vertices, and it was not refined at the start. kept_margin > margin keeps a
// band from being refined and coarsened in turn.

#include <deal.II/base/mpi.h>

#include <discretization/adaptation.h>
#include <discretization/point_grid.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // Interpolation leaves this in intact material.
    constexpr double rounding = 1e-12;

    // from the center, to all vertices and a little more
    template <typename Cell>
    double
    reach(const Cell &cell)
    {
      double result = 0.51 * cell->diameter();
      for (const unsigned int v : cell->vertex_indices())
        result =
          std::max(result, 1.001 * cell->center().distance(cell->vertex(v)));
      return result;
    }



    // Answers which cells the places ask to be fine.
    template <int dim>
    class Neighborhood
    {
    public:
      // @p largest_reach: of the cells that are asked for
      Neighborhood(const AdaptationPlaces<dim> &places,
                   const AdaptationRule        &rule,
                   const double                 largest_reach)
        : margin(rule.margin)
        , kept_margin(std::max(0., rule.kept_margin))
        , growing(places.growing, margin + largest_reach)
        , damaged(places.damaged, kept_margin + largest_reach)
      {}

      template <typename Cell>
      bool
      contains(const Cell &cell) const
      {
        const Point<dim> center = cell->center();
        const double     size   = reach(cell);
        return growing.has_point_within(center, margin + size) ||
               damaged.has_point_within(center, kept_margin + size);
      }

    private:
      const double         margin, kept_margin;
      const PointGrid<dim> growing, damaged;
    };
  } // namespace



  template <int dim>
  bool
  flag_cells_near(const AdaptationPlaces<dim> &places,
                  const AdaptationRule        &rule,
                  Triangulation<dim>          &triangulation)
  {
    const auto may_be_refined = [&](const auto &cell) {
      return cell->is_locally_owned() &&
             static_cast<unsigned int>(cell->level()) < rule.finest_level;
    };
    double largest_reach = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (may_be_refined(cell))
        largest_reach = std::max(largest_reach, reach(cell));
    bool any = false;
    if (largest_reach > 0.)
    {
      const Neighborhood<dim> neighborhood(places, rule, largest_reach);
      for (const auto &cell : triangulation.active_cell_iterators())
        if (may_be_refined(cell) && neighborhood.contains(cell))
        {
          cell->set_refine_flag();
          any = true;
        }
    }
    return Utilities::MPI::max(any ? 1 : 0, triangulation.get_communicator()) >
           0;
  }



  template <int dim>
  void
  flag_cells_to_coarsen(const AdaptationPlaces<dim> &places,
                        const AdaptationRule        &rule,
                        const RefinedAtStart<dim>   &was_refined,
                        const Fields<dim>           &fields,
                        const Vector                &phase_field)
  {
    const auto is_intact = [&](const auto &cell) {
      for (const unsigned int v : cell->vertex_indices())
        if (phase_field(cell->vertex_dof_index(v, 0)) < 1. - rounding)
          return false;
      return true;
    };
    const auto may_be_coarser = [&](const auto &cell) {
      return cell->is_locally_owned() && cell->level() > 0 &&
             !cell->refine_flag_set() && is_intact(cell);
    };
    double largest_reach = 0.;
    for (const auto &cell : fields.phase_field.active_cell_iterators())
      if (may_be_coarser(cell))
        largest_reach = std::max(largest_reach, reach(cell->parent()));
    if (largest_reach == 0.)
      return;
    const Neighborhood<dim> neighborhood(places, rule, largest_reach);
    for (const auto &cell : fields.phase_field.active_cell_iterators())
      if (may_be_coarser(cell) && !was_refined(cell->parent()) &&
          !neighborhood.contains(cell->parent()))
        cell->set_coarsen_flag();
  }



#define INSTANTIATE(dim)                                             \
  template bool flag_cells_near(const AdaptationPlaces<dim> &,       \
                                const AdaptationRule &,              \
                                Triangulation<dim> &);               \
  template void flag_cells_to_coarsen(const AdaptationPlaces<dim> &, \
                                      const AdaptationRule &,        \
                                      const RefinedAtStart<dim> &,   \
                                      const Fields<dim> &,           \
                                      const Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
