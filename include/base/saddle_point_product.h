// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_saddle_point_product_h
#define mixed_cracks_base_saddle_point_product_h

#include <base/linear_algebra.h>

#include <functional>

namespace MixedCracks
{
  /// The matrix of displacements and pressures,
  ///
  ///     K = ( A  B^T )
  ///         ( B  -C  ),
  ///
  /// as what iterative solvers ask of it: products. Whether it is stored is
  /// its own affair. Rows and columns of constrained unknowns have a positive
  /// diagonal entry only. Collective.
  class SaddlePointProduct
  {
  public:
    using Vector = LinearAlgebra::DistributedVector;
    /// Is handed a range of owned rows, [first, second).
    using RangeWork = std::function<void(unsigned int, unsigned int)>;

    virtual ~SaddlePointProduct() = default;

    /// Make @p vector one of all owned unknowns, zero.
    virtual void reinit(Vector &vector) const = 0;

    /// @p result = K @p source. @p before and @p after are called once for
    /// each owned row: before it is written first, which has to make it 0, and
    /// as soon as it is known, but for constrained rows: their @p result is
    /// undefined then, and after the product.
    virtual void vmult(Vector          &result,
                       const Vector    &source,
                       const RangeWork &before,
                       const RangeWork &after) const = 0;

    /// @p result = K @p source
    virtual void vmult(Vector &result, const Vector &source) const = 0;

    /// @p forces = B^T @p pressures, both of all owned unknowns: displacements
    /// in @p pressures are not read, pressures in @p forces are undefined.
    virtual void pressure_forces(Vector       &forces,
                                 const Vector &pressures) const = 0;

    /// The diagonal of K, or what is near to it in rows next to hanging nodes.
    virtual void diagonal(Vector &result) const = 0;
  };
} // namespace MixedCracks

#endif
