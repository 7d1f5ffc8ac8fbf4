// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_refinement_h
#define mixed_cracks_discretization_refinement_h

#include <base/flat_piece.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace MixedCracks
{
  /// Refine cells here so many levels beyond the global refinement.
  template <int dim>
  struct RefinementBox
  {
    dealii::BoundingBox<dim> box; ///< mm
    unsigned int             levels;
  };

  /// Refine cells within a distance of flat pieces, of a boundary for example.
  template <int dim>
  struct RefinementSurroundings
  {
    std::vector<FlatPiece<dim>> pieces;   ///< mm
    double                      distance; ///< mm
    unsigned int                levels;
  };

  template <int dim>
  struct RefinementRegions
  {
    std::vector<RefinementBox<dim>>          boxes;
    std::vector<RefinementSurroundings<dim>> surroundings;
  };

  /// What decides whether a cell is refined.
  template <int dim>
  struct CellExtent
  {
    dealii::BoundingBox<dim> box;      ///< mm
    dealii::Point<dim>       center;   ///< mm
    double                   diameter; ///< mm
  };

  /// How many levels beyond the global refinement the regions want for such a
  /// cell.
  template <int dim>
  unsigned int wanted_levels(const CellExtent<dim>        &cell,
                             const RefinementRegions<dim> &regions);

  /// Halve every cell of a coarse mesh @p n_global times, then every cell in a
  /// region until it is the region's levels finer (the highest where regions
  /// overlap). A cell is in a box when they overlap, touching is not enough,
  /// and in surroundings when its centre is nearer than the distance plus half
  /// the size of the cell. Works on serial and on parallel::distributed
  /// triangulations; every rank calls it.
  template <int dim>
  void refine_globally_and_in_regions(dealii::Triangulation<dim> &triangulation,
                                      unsigned int                n_global,
                                      const RefinementRegions<dim> &regions);

  /// Whether refine_globally_and_in_regions() refines such a cell.
  template <int dim>
  bool is_refined(const dealii::TriaIterator<dealii::CellAccessor<dim>> &cell,
                  unsigned int                  n_global,
                  const RefinementRegions<dim> &regions);
} // namespace MixedCracks

#endif
