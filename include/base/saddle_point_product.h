// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_saddle_point_product_h
#define mixed_cracks_base_saddle_point_product_h

#include <base/linear_algebra.h>

namespace MixedCracks
{
  /// The matrix of displacements and pressures,
  ///
  ///     K = ( A  B^T )
  ///         ( B  -C  ),
  ///
  /// as what iterative solvers ask of it: products. Whether it is stored is
  /// its own affair. Vectors without ghosts. Rows and columns of constrained
  /// unknowns have a positive diagonal entry only. Collective.
  class SaddlePointProduct
  {
  public:
    virtual ~SaddlePointProduct() = default;

    /// Make @p vector one of all owned unknowns, zero.
    virtual void reinit(LinearAlgebra::Vector &vector) const = 0;

    /// @p result = K @p source
    virtual void vmult(LinearAlgebra::Vector       &result,
                       const LinearAlgebra::Vector &source) const = 0;

    /// @p forces = B^T @p pressures: owned unknowns of the one kind in order,
    /// those of the other left out.
    virtual void pressure_forces(double       *forces,
                                 const double *pressures) const = 0;

    /// The diagonal of K, or what is near to it in rows next to hanging nodes.
    virtual void diagonal(LinearAlgebra::Vector &result) const = 0;
  };
} // namespace MixedCracks

#endif
