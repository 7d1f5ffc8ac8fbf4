// SPDX-License-Identifier: GPL-2.0-or-later
// The pattern of a matrix: (i, j) where i and j share a cell, or depend on dofs
// that do. Rows and columns of constrained dofs have their diagonal entry only,
// since assembly condenses them: C^T A C.

#include <deal.II/dofs/dof_tools.h>

#include <discretization/sparse_matrix.h>

namespace MixedCracks
{
  template <int dim>
  void
  make_sparse_matrix(const dealii::DoFHandler<dim>           &handler,
                     const DofSets                           &dofs,
                     const dealii::AffineConstraints<double> &constraints,
                     LinearAlgebra::SparseMatrix             &matrix)
  {
    const MPI_Comm                 communicator = handler.get_communicator();
    LinearAlgebra::SparsityPattern pattern(
      dofs.owned, dofs.owned, dofs.relevant, communicator);
    dealii::DoFTools::make_sparsity_pattern(
      handler,
      pattern,
      constraints,
      /*keep_constrained_dofs=*/false,
      dealii::Utilities::MPI::this_mpi_process(communicator));
    pattern.compress();
    matrix.reinit(pattern);
  }



  template void make_sparse_matrix(const dealii::DoFHandler<2> &,
                                   const DofSets &,
                                   const dealii::AffineConstraints<double> &,
                                   LinearAlgebra::SparseMatrix &);
  template void make_sparse_matrix(const dealii::DoFHandler<3> &,
                                   const DofSets &,
                                   const dealii::AffineConstraints<double> &,
                                   LinearAlgebra::SparseMatrix &);
} // namespace MixedCracks
