// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_elastic_tangent_h
#define mixed_cracks_assembly_elastic_tangent_h

#include <assembly/elastic_kernel.h>

#include <vector>

namespace MixedCracks
{
  /// How far a state is from the one that the elastic matrix was built for.
  struct TangentDistance
  {
    double degradation = 0.; ///< largest relative change of g
    /// number of quadrature points whose split changed its regime
    double regime_changes = 0.;
    /// at finite strain the largest change of F, relative to F
    double deformation = 0.;
  };

  /// The present state at the quadrature points of the owned cells, and the one
  /// that the elastic matrix was built for: how far apart they are, in which
  /// cells the matrix would be another one, and whether it is worth correcting
  /// there. Serial.
  template <int dim>
  class ElasticTangent
  {
  public:
    /// There is no matrix yet.
    void reinit(unsigned int n_cells, unsigned int n_points_per_cell);

    /// The state of one cell now.
    void set_present(unsigned int                          cell,
                     const std::vector<ElasticPoint<dim>> &points);

    /// The first point of a cell, now.
    const ElasticPoint<dim> *
    present(const unsigned int cell) const
    {
      return &states[std::size_t(cell) * n_points];
    }

    /// The first point of a cell, as the matrix has it; as it is now, if no
    /// points were kept.
    const ElasticPoint<dim> *
    of_matrix(const unsigned int cell) const
    {
      return matrix_states.empty()
               ? present(cell)
               : &matrix_states[std::size_t(cell) * n_points];
    }

    /// Add one cell to @p distance. At finite strain no regime changes.
    void compare(unsigned int cell, TangentDistance &distance) const;

    /// Cells whose part of the matrix is another one now.
    std::vector<unsigned int> changed_cells() const;

    /// Whether the matrix is to be corrected in its changed cells, rather than
    /// built anew. @p n_changed of @p n_cells, of all ranks, have changed.
    bool is_to_be_corrected(double n_changed, double n_cells) const;

    /// The matrix is now that of the present state. @p keeps_points: what a
    /// correction or a comparison of F would need, a third of the memory of
    /// products without a matrix.
    void note_matrix(bool was_corrected, bool keeps_points = true);

  private:
    /// of a point, what says whether its tangent is the same
    struct Mark
    {
      double degradation;
      int    regime;
    };

    unsigned int                   n_points = 0;
    std::vector<ElasticPoint<dim>> states;
    std::vector<ElasticPoint<dim>> matrix_states; // or empty
    std::vector<Mark>              matrix_marks;
    unsigned int                   n_corrections = 0; // in a row
  };
} // namespace MixedCracks

#endif
