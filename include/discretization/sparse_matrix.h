// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_sparse_matrix_h
#define mixed_cracks_discretization_sparse_matrix_h

#include <base/linear_algebra.h>

#include <deal.II/base/table.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/affine_constraints.h>

#include <discretization/fields.h>

namespace MixedCracks
{
  /// Make @p matrix square and zero, with the rows @p dofs of @p handler and
  /// an entry wherever two dofs share a cell. Constrained dofs keep their
  /// diagonal only. Collective.
  template <int dim>
  void make_sparse_matrix(const dealii::DoFHandler<dim>           &handler,
                          const DofSets                           &dofs,
                          const dealii::AffineConstraints<double> &constraints,
                          LinearAlgebra::SparseMatrix             &matrix);

  /// The same with entries for those pairs of components only that couple.
  template <int dim>
  void make_sparse_matrix(
    const dealii::DoFHandler<dim>                      &handler,
    const DofSets                                      &dofs,
    const dealii::AffineConstraints<double>            &constraints,
    const dealii::Table<2, dealii::DoFTools::Coupling> &couplings,
    LinearAlgebra::SparseMatrix                        &matrix);
} // namespace MixedCracks

#endif
