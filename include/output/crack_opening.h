// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_crack_opening_h
#define mixed_cracks_output_crack_opening_h

#include <base/linear_algebra.h>

#include <discretization/fields.h>

#include <output/crack_opening_parameters.h>

#include <utility>
#include <vector>

namespace MixedCracks
{
  /// Volume between the faces of all cracks, the integral of u . grad(phi);
  /// mm^dim (2-d: per mm thickness). Across a crack it sums up the jump of the
  /// normal displacement: positive where it is open [Wheeler, Wick, Wollner
  /// 2014]. Vectors have ghosts. Collective.
  template <int dim>
  double crack_volume(const Fields<dim>           &fields,
                      const LinearAlgebra::Vector &elastic,
                      const LinearAlgebra::Vector &phase_field);

  /// The opening of cracks at positions along them: the integral of u .
  /// grad(phi) along the normal, by the midpoint rule with eight points per
  /// length of the smallest cells. Where a point belongs to several cells the
  /// integrand is their mean, so that the result does not depend on the number
  /// of ranks; where it lies outside the body, it is 0.
  template <int dim>
  class CrackOpening
  {
  public:
    CrackOpening(const Fields<dim>                   &fields,
                 const std::vector<OpeningLine<dim>> &lines);

    /// Find the cells; to be called when the mesh changed. @p reach: half the
    /// length of integration, mm. Collective.
    void reinit(double reach);

    /// The openings at the positions of one line after the other, mm; the
    /// same on all ranks. Vectors have ghosts. Collective.
    std::vector<double>
    evaluate(const LinearAlgebra::Vector &elastic,
             const LinearAlgebra::Vector &phase_field) const;

    const std::vector<OpeningLine<dim>> &
    lines() const
    {
      return measured;
    }

  private:
    using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;

    /// A position, and the normal through it.
    struct Probe
    {
      dealii::Point<dim>     position;
      dealii::Tensor<1, dim> normal;
    };

    /// Points of the integration of one probe in one cell.
    struct Sample
    {
      Cell                            cell;
      unsigned int                    probe;
      std::vector<unsigned int>       numbers; ///< of the points
      std::vector<dealii::Point<dim>> points;  ///< on the unit cell
    };

    /// The points number first to last - 1 that can lie in the cell.
    std::pair<unsigned int, unsigned int> candidates(const Cell  &cell,
                                                     const Probe &probe) const;

    void sample(const Cell &cell, unsigned int probe);

    void count_cells_of_points();

    double
    offset(const unsigned int point) const
    {
      return (point + 0.5) * spacing - 0.5 * n_points * spacing;
    }

    const Fields<dim>                  &fields;
    const std::vector<OpeningLine<dim>> measured;
    std::vector<Probe>                  probes;
    unsigned int                        n_points = 0;  // per probe
    double                              spacing  = 0.; // of the points, mm
    std::vector<Sample>                 samples;       // in owned cells
    std::vector<double>                 n_cells;       // around each point
  };
} // namespace MixedCracks

#endif
