// SPDX-License-Identifier: GPL-2.0-or-later
// The pattern of a matrix: (i, j) where i and j share a cell, or depend on dofs
// that do, and their components couple. Rows and columns of constrained dofs
// have their diagonal entry only, since assembly condenses them: C^T A C.

#include <discretization/sparse_matrix.h>

namespace MixedCracks
{
  using dealii::DoFTools::Coupling;

  template <int dim>
  void
  make_sparse_matrix(const dealii::DoFHandler<dim>           &handler,
                     const DofSets                           &dofs,
                     const dealii::AffineConstraints<double> &constraints,
                     const dealii::Table<2, Coupling>        &couplings,
                     LinearAlgebra::SparseMatrix             &matrix)
  {
    const MPI_Comm                 communicator = handler.get_communicator();
    LinearAlgebra::SparsityPattern pattern(
      dofs.owned, dofs.owned, dofs.relevant, communicator);
    dealii::DoFTools::make_sparsity_pattern(
      handler,
      couplings,
      pattern,
      constraints,
      /*keep_constrained_dofs=*/false,
      dealii::Utilities::MPI::this_mpi_process(communicator));
    pattern.compress();
    matrix.reinit(pattern);
  }



  template <int dim>
  void
  make_sparse_matrix(const dealii::DoFHandler<dim>           &handler,
                     const DofSets                           &dofs,
                     const dealii::AffineConstraints<double> &constraints,
                     LinearAlgebra::SparseMatrix             &matrix)
  {
    const unsigned int         n = handler.get_fe().n_components();
    dealii::Table<2, Coupling> couplings(n, n);
    couplings.fill(Coupling::always);
    make_sparse_matrix(handler, dofs, constraints, couplings, matrix);
  }



#define INSTANTIATE(dim)                                                      \
  template void make_sparse_matrix(const dealii::DoFHandler<dim> &,           \
                                   const DofSets &,                           \
                                   const dealii::AffineConstraints<double> &, \
                                   const dealii::Table<2, Coupling> &,        \
                                   LinearAlgebra::SparseMatrix &);            \
  template void make_sparse_matrix(const dealii::DoFHandler<dim> &,           \
                                   const DofSets &,                           \
                                   const dealii::AffineConstraints<double> &, \
                                   LinearAlgebra::SparseMatrix &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
