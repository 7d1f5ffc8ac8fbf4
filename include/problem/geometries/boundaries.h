// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_boundaries_h
#define mixed_cracks_problem_geometries_boundaries_h

#include <deal.II/grid/tria.h>

namespace MixedCracks
{
  /// Give every boundary face of a coarse mesh the id that @p id_at says for
  /// the mean of its vertices. Every rank does this for the whole mesh.
  template <int dim, typename Function>
  void
  set_boundary_ids_by_center(dealii::Triangulation<dim> &triangulation,
                             const Function             &id_at)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(id_at(cell->face(f)->center()));
  }
} // namespace MixedCracks

#endif
