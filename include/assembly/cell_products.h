// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_cell_products_h
#define mixed_cracks_assembly_cell_products_h

#include <assembly/isotropic_cell.h>

#include <base/saddle_point_product.h>

#include <deal.II/base/quadrature.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/mapping.h>

#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <vector>

namespace MixedCracks
{
  /// Products with the elastic matrix cell by cell, several cells at a time in
  /// the lanes of vector registers (deal.II's MatrixFree). Constrained unknowns
  /// are read by their constraints, and their own entry of a result is 0.
  /// Collective.
  template <int dim>
  class CellProducts
  {
  public:
    using Vector    = SaddlePointProduct::Vector;
    using RangeWork = SaddlePointProduct::RangeWork;

    virtual ~CellProducts() = default;

    /// Make @p vector one of all owned unknowns, zero.
    virtual void reinit(Vector &vector) const = 0;

    /// At the quadrature points of owned cell number @p cell, in the order of
    /// the active cells. To be called for all of them.
    virtual void
    set_tangents(unsigned int                             cell,
                 const std::vector<ElasticResponse<dim>> &responses) = 0;

    /// The tangents of one owned cell, if they are isotropic; false if not.
    virtual bool read_tangents(unsigned int   cell,
                               IsotropicCell &result) const = 0;

    /// (u, p) -> K (u, p), see SaddlePointProduct::vmult()
    virtual void multiply(Vector          &result,
                          const Vector    &source,
                          const RangeWork &before,
                          const RangeWork &after) const = 0;

    /// (., p) -> (B^T p, 0)
    virtual void pressure_forces(Vector       &result,
                                 const Vector &source) const = 0;

    /// Of the displacements; that of pressures is 0. What a hanging node adds
    /// to the nodes that it depends on is taken linear in their weights.
    virtual void diagonal(Vector &result) const = 0;

    virtual unsigned int n_lanes() const = 0;

    virtual std::size_t memory_consumption() const = 0;
  };

  /// For Q2 displacements with Q1 pressures; @p lanes cells at a time, where
  /// this processor has so many. 0: as many as deal.II was compiled for.
  template <int dim, int lanes>
  std::unique_ptr<CellProducts<dim>> make_cell_products_with_lanes(
    const dealii::Mapping<dim>              &mapping,
    const dealii::DoFHandler<dim>           &handler,
    const dealii::AffineConstraints<double> &constraints);

  /// With as many lanes as this processor has.
  template <int dim>
  std::unique_ptr<CellProducts<dim>>
  make_cell_products(const dealii::Mapping<dim>              &mapping,
                     const dealii::DoFHandler<dim>           &handler,
                     const dealii::AffineConstraints<double> &constraints);
} // namespace MixedCracks

#endif
