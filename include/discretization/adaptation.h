// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_adaptation_h
#define mixed_cracks_discretization_adaptation_h

#include <base/linear_algebra.h>

#include <deal.II/distributed/tria.h>

#include <discretization/constraints.h>
#include <discretization/fields.h>

#include <functional>
#include <vector>

namespace MixedCracks
{
  /// Where a predicted phase field asks for finer cells [HWW15, ch. 4].
  struct AdaptationRule
  {
    /// cells with a smaller phase field are damaged; rho
    double threshold = 0.7;
    /// no cell is made finer than this level
    unsigned int finest_level = 0;
    /// cells within this distance of damaged nodes are refined with them, so
    /// that a running crack does not need another mesh at once; mm
    double margin = 0.;
    /// where a crack meets coarse cells, those as far ahead of its tip are
    /// refined too; mm
    double lookahead = 0.;
    /// cells that were coarse once, are intact and farther than this from
    /// damaged nodes become coarse again; negative: never; mm
    double kept_margin = -1.;

    bool
    coarsens() const
    {
      return kept_margin >= 0.;
    }
  };

  /// Where cells are to be fine; mm, the same on every rank.
  template <int dim>
  struct AdaptationPlaces
  {
    /// cells within the margin of these: damaged nodes, and points ahead of
    /// the tips of cracks
    std::vector<dealii::Point<dim>> growing;
    /// cells within the kept margin of these: the damaged nodes
    std::vector<dealii::Point<dim>> damaged;

    bool
    empty() const
    {
      return growing.empty();
    }
  };

  /// Whether a cell, active or not, was refined at the start already.
  template <int dim>
  using RefinedAtStart = std::function<bool(
    const dealii::TriaIterator<dealii::CellAccessor<dim>> &cell)>;

  /// The damaged nodes of all ranks, and points ahead of the tips of cracks;
  /// none when all damaged cells are as fine as they may be. With coarsening,
  /// only damage at cells that are too coarse is taken for growing.
  /// @p phase_field has ghosts. Collective.
  template <int dim>
  AdaptationPlaces<dim>
  places_to_refine(const Fields<dim>           &fields,
                   const LinearAlgebra::Vector &phase_field,
                   const AdaptationRule        &rule);

  /// Set the refinement flags of cells within the margins around @p places;
  /// false when no cell has one on any rank. Refining adds one level: to be
  /// repeated until it is false. Collective.
  template <int dim>
  bool flag_cells_near(const AdaptationPlaces<dim> &places,
                       const AdaptationRule        &rule,
                       dealii::Triangulation<dim>  &triangulation);

  /// Set the coarsening flags of intact cells (phi = 1 at all vertices) that
  /// the places do not ask for and that are finer than at the start. To be
  /// called after flag_cells_near(). @p phase_field has ghosts.
  template <int dim>
  void flag_cells_to_coarsen(const AdaptationPlaces<dim> &places,
                             const AdaptationRule        &rule,
                             const RefinedAtStart<dim>   &was_refined,
                             const Fields<dim>           &fields,
                             const LinearAlgebra::Vector &phase_field);

  /// Refine and coarsen the flagged cells, number the fields anew, and carry
  /// the vectors over, which have ghosts before and after. Exact for functions
  /// of the elements but for cells at curved boundaries and, where cells become
  /// coarser, for functions the coarse ones cannot hold; interpolation keeps
  /// the phase field within its bounds. @p constraints are those
  /// of the new mesh afterwards. Collective.
  template <int dim>
  void refine_and_transfer(
    dealii::parallel::distributed::Triangulation<dim> &triangulation,
    Fields<dim>                                       &fields,
    Constraints<dim>                                  &constraints,
    const std::vector<LinearAlgebra::Vector *>        &elastic,
    const std::vector<LinearAlgebra::Vector *>        &phase_field);
} // namespace MixedCracks

#endif
