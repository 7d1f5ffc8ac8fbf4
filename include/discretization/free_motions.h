// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_free_motions_h
#define mixed_cracks_discretization_free_motions_h

#include <discretization/constraints.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// The motions of the undamaged body as a rigid whole that the prescribed
  /// displacements and periodic sides leave free: the kernel of its stiffness.
  /// One sentence each, as "the body can rotate about (0, 2)", "the body can
  /// move in x". Parts of the mesh that share no face are bodies of their own,
  /// hinged where they share a vertex, and named by their middle. Empty: none.
  ///
  /// Needs the faces of the coarse mesh only, since a rigid motion that
  /// vanishes at the corners and the middle of a face vanishes on it, and for
  /// points the cells that have them as vertices. Collective.
  template <int dim>
  std::vector<std::string>
  free_rigid_motions(const dealii::Triangulation<dim>            &triangulation,
                     const std::vector<PrescribedComponent<dim>> &components,
                     const std::vector<PrescribedPoint<dim>>     &points,
                     const PeriodicSides<dim>                    &sides = {});
} // namespace MixedCracks

#endif
