// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_matrix_free_elastic_h
#define mixed_cracks_assembly_matrix_free_elastic_h

#include <assembly/assembler.h>
#include <assembly/cell_products.h>

#include <base/saddle_point_product.h>

#include <discretization/constraints.h>

namespace MixedCracks
{
  /// The elastic matrix that Assembler::elastic_matrix() would make, as a
  /// product: cells are integrated anew each time, with the tangents at the
  /// quadrature points, which are all that is stored. Mixed formulation only.
  /// Collective.
  template <int dim>
  class MatrixFreeElastic : public SaddlePointProduct
  {
  public:
    MatrixFreeElastic(const Fields<dim>      &fields,
                      const Constraints<dim> &constraints);

    /// To be called when the mesh changed.
    void reinit();

    /// Take the state of the last Assembler::elastic_residual().
    void update(Assembler<dim> &assembler);

    void
    reinit(Vector &vector) const override
    {
      cells->reinit(vector);
    }

    void
    vmult(Vector          &result,
          const Vector    &source,
          const RangeWork &before,
          const RangeWork &after) const override
    {
      cells->multiply(result, source, before, after);
    }

    void vmult(Vector &result, const Vector &source) const override;

    /// The tangents of one owned cell, if they are isotropic.
    bool
    read_tangents(const unsigned int cell, IsotropicCell &result) const
    {
      return cells->read_tangents(cell, result);
    }

    void
    pressure_forces(Vector &forces, const Vector &pressures) const override
    {
      cells->pressure_forces(forces, pressures);
    }

    void diagonal(Vector &result) const override;

    /// Cells that are integrated at a time.
    unsigned int
    n_lanes() const
    {
      return cells->n_lanes();
    }

    /// Bytes of this rank.
    std::size_t
    memory_consumption() const
    {
      return cells->memory_consumption();
    }

  private:
    const Fields<dim>                 &fields;
    const Constraints<dim>            &constraints;
    std::unique_ptr<CellProducts<dim>> cells;
    std::vector<unsigned int>          constrained; ///< positions of owned ones
    /// what stands on the diagonal where nothing else does, N/mm^dim
    double constrained_diagonal = 1.;
    Vector diagonal_entries;
  };
} // namespace MixedCracks

#endif
