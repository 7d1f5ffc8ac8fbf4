// SPDX-License-Identifier: GPL-2.0-or-later
#include <solvers/exact_block.h>

namespace MixedCracks
{
  ExactBlock::ExactBlock(const SaddlePointProduct          &whole,
                         const LinearAlgebra::SparseMatrix &block,
                         const std::vector<unsigned int>   &rows,
                         const MatrixSymmetry               symmetry,
                         const unsigned int                 n_components)
    : whole(whole)
    , rows(rows)
  {
    LinearSystem system;
    system.matrix       = &block;
    system.symmetry     = symmetry;
    system.n_components = n_components;
    outcome             = solver.initialize(system);
    if (outcome.success)
      outcome = solver.factorize();
    whole.reinit(product);
    residual.reinit(block.locally_owned_range_indices(),
                    block.get_mpi_communicator());
    correction.reinit(residual);
  }



  void
  ExactBlock::smooth(Vector &solution, const Vector &right_hand_side) const
  {
    whole.vmult(product, solution);
    for (std::size_t k = 0; k < rows.size(); ++k)
      residual.begin()[k] =
        right_hand_side.begin()[rows[k]] - product.begin()[rows[k]];
    if (!solver.solve(correction, residual).success)
      return;
    for (std::size_t k = 0; k < rows.size(); ++k)
      solution.begin()[rows[k]] += correction.begin()[k];
  }
} // namespace MixedCracks
