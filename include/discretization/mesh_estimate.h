// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_mesh_estimate_h
#define mixed_cracks_discretization_mesh_estimate_h

#include <discretization/fields.h>
#include <discretization/refinement.h>

namespace MixedCracks
{
  /// What is known of a refined mesh that has not been built.
  struct MeshEstimate
  {
    double       n_cells       = 0.;
    double       n_elastic     = 0.; ///< dofs of u and p
    double       n_phase_field = 0.; ///< dofs of phi
    unsigned int finest_level  = 0;
    double       finest_size   = 0.; ///< mean measure^(1/dim) there, mm
    /// whether cells and dofs are counted exactly: where nothing is refined
    /// beyond the rest
    bool is_exact = true;
  };

  /// What refine_globally_and_in_regions() would make of @p coarse, without
  /// doing it. Cells are taken as straight; those that are refined only because
  /// a neighbour is much finer are counted as in a grid of equal cells.
  /// Collective; every rank has the coarse mesh, which is not refined yet.
  template <int dim>
  MeshEstimate estimate_mesh(const dealii::Triangulation<dim> &coarse,
                             const FieldLayout                &layout,
                             unsigned int                      n_global,
                             const RefinementRegions<dim>     &regions);

  /// Refine a coarse mesh as refine_globally_and_in_regions() would, but only
  /// where @p points lie, with at most @p max_cells cells from the global
  /// refinement: vertices near to the points are then those of the whole mesh.
  /// Collective.
  template <int dim>
  void refine_at_points(dealii::Triangulation<dim>            &triangulation,
                        unsigned int                           n_global,
                        const RefinementRegions<dim>          &regions,
                        const std::vector<dealii::Point<dim>> &points,
                        double                                 max_cells);
} // namespace MixedCracks

#endif
