// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_symmetry_plane_h
#define mixed_cracks_discretization_symmetry_plane_h

#include <deal.II/grid/tria.h>

#include <discretization/boundary_ids.h>

#include <string>

namespace MixedCracks
{
  /// The component normal to the boundary @p ids, which has to be flat and
  /// parallel to the axes. Throws InputError with its @p name and normal, on
  /// all ranks, when it is not. Looks at the coarse mesh only.
  template <int dim>
  unsigned int
  component_normal_to(const dealii::Triangulation<dim> &triangulation,
                      const BoundaryIds                &ids,
                      const std::string                &name);
} // namespace MixedCracks

#endif
