// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_exact_block_h
#define mixed_cracks_solvers_exact_block_h

#include <solvers/direct_solver.h>

namespace MixedCracks
{
  /// Solves exactly for some unknowns of a matrix, the others given: with c the
  /// chosen ones and K_cc their block,
  ///
  ///     x_c <- x_c + K_cc^-1 ( f - K x )_c.
  ///
  /// Collective.
  class ExactBlock
  {
  public:
    using Vector = SaddlePointProduct::Vector;

    /// @p block: K_cc, in numbers of its own. @p rows: positions of its owned
    /// rows among those of @p whole. All must outlive this.
    ExactBlock(const SaddlePointProduct          &whole,
               const LinearAlgebra::SparseMatrix &block,
               const std::vector<unsigned int>   &rows,
               MatrixSymmetry                     symmetry,
               unsigned int                       n_components);

    /// Whether the factors are there; the same on every rank.
    bool
    is_usable() const
    {
      return outcome.success;
    }

    /// Improve the chosen unknowns of @p solution.
    void smooth(Vector &solution, const Vector &right_hand_side) const;

  private:
    const SaddlePointProduct        &whole;
    const std::vector<unsigned int> &rows;
    mutable DirectSolver             solver;
    LinearOutcome                    outcome;
    mutable Vector                   product;
    mutable LinearAlgebra::Vector    residual, correction;
  };
} // namespace MixedCracks

#endif
