// SPDX-License-Identifier: GPL-2.0-or-later
// The products that the preconditioner of block_amg.cc is made of, with blocks
// copied out of the matrix: B^T without the zeros that its rows have beside it.

#include <Epetra_Vector.h>
#include <solvers/assembled_product.h>
#include <solvers/matrix_block.h>

namespace MixedCracks
{
  AssembledProduct::AssembledProduct(const LinearAlgebra::SparseMatrix &matrix,
                                     const std::vector<bool> &is_pressure)
    : matrix(matrix)
    , is_pressure(is_pressure)
  {
    if (is_pressure.empty())
      return;
    std::vector<bool> is_displacement = is_pressure;
    is_displacement.flip();
    coupling =
      extract_block(matrix.trilinos_matrix(), is_displacement, is_pressure);
  }



  void
  AssembledProduct::vmult(Vector &result, const Vector &source) const
  {
    multiply(matrix.trilinos_matrix(), result.begin(), source.begin());
  }



  void
  AssembledProduct::vmult(Vector          &result,
                          const Vector    &source,
                          const RangeWork &before,
                          const RangeWork &after) const
  {
    before(0, result.locally_owned_size());
    vmult(result, source);
    after(0, result.locally_owned_size());
  }



  void
  AssembledProduct::pressure_forces(Vector       &forces,
                                    const Vector &pressures) const
  {
    compressed_pressures.clear();
    for (std::size_t i = 0; i < is_pressure.size(); ++i)
      if (is_pressure[i])
        compressed_pressures.push_back(pressures.local_element(i));
    compressed_forces.resize(is_pressure.size() - compressed_pressures.size());
    multiply(*coupling, compressed_forces.data(), compressed_pressures.data());
    for (std::size_t i = 0, next = 0; i < is_pressure.size(); ++i)
      if (!is_pressure[i])
        forces.local_element(i) = compressed_forces[next++];
  }



  void
  AssembledProduct::diagonal(Vector &result) const
  {
    Epetra_Vector entries(matrix.trilinos_matrix().RowMap());
    matrix.trilinos_matrix().ExtractDiagonalCopy(entries);
    std::copy(
      entries.Values(), entries.Values() + entries.MyLength(), result.begin());
  }
} // namespace MixedCracks
