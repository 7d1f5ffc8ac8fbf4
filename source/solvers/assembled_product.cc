// SPDX-License-Identifier: GPL-2.0-or-later
// The products that the preconditioner of block_amg.cc is made of, with blocks
// copied out of the matrix: B^T without the zeros that its rows have beside it.

#include <Epetra_Vector.h>
#include <solvers/assembled_product.h>
#include <solvers/multigrid.h>

namespace MixedCracks
{
  AssembledProduct::AssembledProduct(const LinearAlgebra::SparseMatrix &matrix,
                                     const std::vector<bool> &is_pressure)
    : matrix(matrix)
  {
    if (is_pressure.empty())
      return;
    std::vector<bool> is_displacement = is_pressure;
    is_displacement.flip();
    coupling =
      extract_block(matrix.trilinos_matrix(), is_displacement, is_pressure);
  }



  void
  AssembledProduct::pressure_forces(double       *forces,
                                    const double *pressures) const
  {
    multiply(*coupling, forces, pressures);
  }



  void
  AssembledProduct::diagonal(LinearAlgebra::Vector &result) const
  {
    Epetra_Vector entries(matrix.trilinos_matrix().RowMap());
    matrix.trilinos_matrix().ExtractDiagonalCopy(entries);
    std::copy(
      entries.Values(), entries.Values() + entries.MyLength(), result.begin());
  }
} // namespace MixedCracks
