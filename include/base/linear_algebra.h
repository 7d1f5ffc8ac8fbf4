// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_linear_algebra_h
#define mixed_cracks_base_linear_algebra_h

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>
#include <deal.II/lac/trilinos_vector.h>

namespace MixedCracks
{
  /// The one place that says whose vectors and matrices are used. Newer
  /// Trilinos versions drop Epetra: then only this header and the solvers
  /// room change.
  namespace LinearAlgebra
  {
    using Vector          = dealii::TrilinosWrappers::MPI::Vector;
    using SparseMatrix    = dealii::TrilinosWrappers::SparseMatrix;
    using SparsityPattern = dealii::TrilinosWrappers::SparsityPattern;
    /// Of products without a matrix, and of iterative solvers
    using DistributedVector =
      dealii::LinearAlgebra::distributed::Vector<double>;
  } // namespace LinearAlgebra
} // namespace MixedCracks

#endif
