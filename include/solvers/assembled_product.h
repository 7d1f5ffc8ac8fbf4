// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_assembled_product_h
#define mixed_cracks_solvers_assembled_product_h

#include <base/saddle_point_product.h>

#include <Epetra_CrsMatrix.h>

#include <memory>
#include <vector>

namespace MixedCracks
{
  /// Products with a stored matrix, which must outlive this.
  class AssembledProduct : public SaddlePointProduct
  {
  public:
    /// @p is_pressure: one entry per owned row; empty where no rank has any.
    AssembledProduct(const LinearAlgebra::SparseMatrix &matrix,
                     const std::vector<bool>           &is_pressure);

    void
    reinit(Vector &vector) const override
    {
      vector.reinit(matrix.locally_owned_range_indices(),
                    matrix.get_mpi_communicator());
    }

    void vmult(Vector          &result,
               const Vector    &source,
               const RangeWork &before,
               const RangeWork &after) const override;

    void vmult(Vector &result, const Vector &source) const override;

    /// With the B^T of the construction.
    void pressure_forces(Vector       &forces,
                         const Vector &pressures) const override;

    void diagonal(Vector &result) const override;

  private:
    const LinearAlgebra::SparseMatrix &matrix;
    const std::vector<bool>            is_pressure;
    std::unique_ptr<Epetra_CrsMatrix>  coupling;
    mutable std::vector<double>        compressed_forces, compressed_pressures;
  };
} // namespace MixedCracks

#endif
