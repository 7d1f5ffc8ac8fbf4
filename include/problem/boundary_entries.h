// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_boundary_entries_h
#define mixed_cracks_problem_boundary_entries_h

#include <problem/boundary_conditions.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// How the lists of subsection "Boundary conditions" are read.

  /// x, y, z, t: what expressions may contain.
  const std::vector<std::string> &entry_variables();

  /// Words that may stand for component dim.
  constexpr const char *entry_of_phase_field = "phase field";
  constexpr const char *entry_of_normal      = "normal";

  /// "boundary : component : expression ; ...", without the boundary where
  /// @p with_boundary is false; @p more: what may stand for component dim, with
  /// the phase field also 'symmetry' and rotations. Throws InputError,
  /// beginning with @p parameter.
  template <int dim>
  std::vector<BoundaryEntry<dim>> read_entries(const std::string &text,
                                               bool               with_boundary,
                                               const std::string &more,
                                               const std::string &parameter);

  /// The same of points, which stand in the place of boundaries; with
  /// @p with_sets also names of point sets. Throws InputError likewise, and for
  /// two entries for a component of one point.
  template <int dim>
  std::vector<PointEntry<dim>>
  point_entries(const std::vector<BoundaryEntry<dim>> &entries,
                const std::string                     &parameter,
                bool                                   with_sets = false);
} // namespace MixedCracks

#endif
