// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_adaptation_h
#define mixed_cracks_discretization_adaptation_h

#include <core/linear_algebra.h>

#include <deal.II/distributed/tria.h>

#include <discretization/constraints.h>
#include <discretization/fields.h>

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
  };

  /// The damaged nodes of all ranks, and points ahead of the tips of cracks;
  /// none when all damaged cells are as fine as they may be. @p phase_field
  /// has ghosts. mm; the same on every rank. Collective.
  template <int dim>
  std::vector<dealii::Point<dim>>
  places_to_refine(const Fields<dim>           &fields,
                   const LinearAlgebra::Vector &phase_field,
                   const AdaptationRule        &rule);

  /// Set the refinement flags of cells within the margin around @p places;
  /// false when no cell has one on any rank. Refining adds one level: to be
  /// repeated until it is false. Collective.
  template <int dim>
  bool flag_cells_near(const std::vector<dealii::Point<dim>> &places,
                       const AdaptationRule                  &rule,
                       dealii::Triangulation<dim>            &triangulation);

  /// Refine the flagged cells, number the fields anew, and carry the vectors
  /// over, which have ghosts before and after. Exact for functions of the
  /// elements but for cells at curved boundaries; interpolation on finer
  /// cells keeps the phase field within its bounds. @p constraints are those
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
