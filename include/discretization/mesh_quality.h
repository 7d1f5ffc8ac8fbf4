// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_mesh_quality_h
#define mixed_cracks_discretization_mesh_quality_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

namespace MixedCracks
{
  /// How far the cells of a mesh are from rectangles or bricks.
  template <int dim>
  struct MeshQuality
  {
    /// Cells below this are called distorted.
    static constexpr double distorted = 0.2;

    unsigned int       n_cells     = 0;
    unsigned int       n_distorted = 0;
    double             smallest    = 1.; ///< scaled Jacobian of a cell
    dealii::Point<dim> place;            ///< centre of the cell that has it; mm
  };

  /// Of the coarse cells, which every rank has.
  template <int dim>
  MeshQuality<dim>
  quality_of_coarse_mesh(const dealii::Triangulation<dim> &triangulation);
} // namespace MixedCracks

#endif
