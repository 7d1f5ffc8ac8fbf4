// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_refined_regions_h
#define mixed_cracks_problem_refined_regions_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <optional>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A box in which cells are refined beyond the rest; mm.
  template <int dim>
  struct RefinedBox
  {
    dealii::Point<dim> lower;
    dealii::Point<dim> upper;
    unsigned int       levels;
  };

  /// The same in a disc (3-d: ball); mm.
  template <int dim>
  struct RefinedDisc
  {
    dealii::Point<dim> center;
    double             radius;
    unsigned int       levels;
  };

  /// The same around a boundary, or a point that the geometry has a name for.
  struct RefinedSurroundings
  {
    std::string  name;
    double       distance; ///< mm
    unsigned int levels;
  };

  /// Where the mesh is finer from the start, the entries "Refined ..." of
  /// subsection "Mesh".
  template <int dim>
  struct RefinedRegions
  {
    std::string boxes;
    std::string discs;
    std::string surroundings;

    /// The caller has entered the subsection.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError, also when a level goes beyond the finest allowed
    /// with @p global_refinements, a box or disc misses the domain, of
    /// @p extent (mm; none: not known yet), or a name is not in @p names.
    void check(unsigned int global_refinements,
               const std::optional<dealii::BoundingBox<dim>> &extent,
               const std::vector<std::string>                &names) const;

    std::vector<RefinedBox<dim>> refined_boxes() const;

    std::vector<RefinedDisc<dim>> refined_discs() const;

    std::vector<RefinedSurroundings> refined_surroundings() const;
  };

  /// No cell is halved more often than this.
  constexpr unsigned int max_refinements = 12;
} // namespace MixedCracks

#endif
