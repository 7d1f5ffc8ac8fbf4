// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_nearest_vertex_h
#define mixed_cracks_discretization_nearest_vertex_h

#include <deal.II/grid/tria.h>

#include <string>

namespace MixedCracks
{
  /// The vertex of active cells of all ranks that is nearest to @p point; the
  /// same on every rank. Collective.
  template <int dim>
  dealii::Point<dim>
  nearest_vertex(const dealii::Triangulation<dim> &triangulation,
                 const dealii::Point<dim>         &point);

  /// "(0, 2)"
  template <int dim>
  std::string in_words(const dealii::Point<dim> &point);
} // namespace MixedCracks

#endif
