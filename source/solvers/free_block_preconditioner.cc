// SPDX-License-Identifier: GPL-2.0-or-later
// Preconditioner of K_II, the matrix of the phase field on the free dofs I,
//
//   K = G_c/l (a'' M + 2 b l^2 L) + (g''/2) M_D,
//
// M the mass matrix, L the Laplacian, M_D the mass weighted with D = 2 psi+.
// Scaled by its diagonal it has eigenvalues from about a''/(a'' + c 2 b
// l^2/h^2), c some number, where D = 0, to about 1: for AT2 (a'' = 1) the
// iterations grow with l/h, and the diagonal is enough where that is small. For
// AT1 and Wu a'' is 0 or less, and large domains of free dofs without D have
// eigenvalues near 0 or below. Then multigrid, for K + concavity * diag(scale),
// which is positive definite.
//
// A hierarchy takes the time of many iterations: it is made only where the
// diagonal has needed more than 'patience' iterations per digit, and kept for
// other values and other free dofs until it needs three times as many as at
// first.

#include <Epetra_Vector.h>
#include <solvers/active_set.h>
#include <solvers/free_block_preconditioner.h>
#include <solvers/matrix_block.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // a hierarchy that needs more than this times the iterations it needed
    // when it was new is made anew
    constexpr double tolerated_growth = 3.;
    // a few iterations say nothing
    constexpr unsigned int always_tolerated_iterations = 10;



    void
    invert_diagonal(const LinearAlgebra::SparseMatrix &matrix, Vector &inverse)
    {
      std::size_t i      = 0;
      double     *values = inverse.begin();
      for (const auto row : inverse.locally_owned_elements())
      {
        const double diagonal = std::abs(matrix.diag_element(row));
        values[i++]           = diagonal > 0. ? 1. / diagonal : 1.;
      }
    }



    // K_II + diag(concavity * scale): a + concavity phi^2/2 is convex
    void
    add_to_diagonal(Epetra_CrsMatrix          &block,
                    const std::vector<double> &additions)
    {
      Epetra_Vector diagonal(block.RowMap());
      block.ExtractDiagonalCopy(diagonal);
      for (int i = 0; i < diagonal.MyLength(); ++i)
        diagonal[i] += additions[i];
      block.ReplaceDiagonalValues(diagonal);
    }
  } // namespace



  FreeBlockPreconditioner::FreeBlockPreconditioner(const double patience)
    : patience(patience)
  {}



  void
  FreeBlockPreconditioner::clear()
  {
    is_wanted   = is_wanted || multigrid;
    is_given_up = false;
    multigrid.reset();
  }



  void
  FreeBlockPreconditioner::set_matrix(const BoundedProblem &problem)
  {
    inverse_diagonal = problem.scale;
    invert_diagonal(problem.matrix, inverse_diagonal);
  }



  void
  FreeBlockPreconditioner::restrict_to(const BoundedProblem    &problem,
                                       const std::vector<bool> &free_dofs)
  {
    is_free = free_dofs;
    if (is_wanted && !is_given_up)
      make_hierarchy(problem);
  }



  void
  FreeBlockPreconditioner::make_hierarchy(const BoundedProblem &problem)
  {
    // the old one goes first: memory
    multigrid.reset();
    is_known = is_free;
    auto block =
      extract_block(problem.matrix.trilinos_matrix(), is_known, is_known);
    std::vector<double> additions;
    for (std::size_t i = 0; i < is_known.size(); ++i)
      if (is_known[i])
        additions.push_back(problem.concavity * problem.scale.begin()[i]);
    if (problem.concavity > 0.)
      add_to_diagonal(*block, additions);
    const std::vector<std::vector<double>> constants(
      1, std::vector<double>(additions.size(), 1.));
    multigrid = std::make_unique<Multigrid>(
      std::move(block), MultigridOptions(), constants);
    is_wanted = false;
    is_new    = true;
  }



  // On the free dofs that the hierarchy knows: its cycle applied to the source
  // with the others set to 0 - a principal part of a symmetric positive
  // operator, hence one itself; elsewhere the diagonal.
  void
  FreeBlockPreconditioner::vmult(Vector &result, const Vector &source) const
  {
    result = source;
    result.scale(inverse_diagonal);
    double *values = result.begin();
    for (std::size_t i = 0; i < is_free.size(); ++i)
      if (!is_free[i])
        values[i] = 0.;
    if (!multigrid)
      return;
    part.clear();
    for (std::size_t i = 0; i < is_known.size(); ++i)
      if (is_known[i])
        part.push_back(is_free[i] ? source.begin()[i] : 0.);
    image.resize(part.size());
    multigrid->vmult(image.data(), part.data());
    std::size_t next = 0;
    for (std::size_t i = 0; i < is_known.size(); ++i)
      if (is_known[i])
      {
        if (is_free[i])
          values[i] = image[next];
        ++next;
      }
  }



  void
  FreeBlockPreconditioner::note_solve(const unsigned int iterations,
                                      const double       digits)
  {
    const double per_digit = iterations / std::max(digits, 1.);
    if (multigrid && is_new)
      when_new = per_digit;
    else
      is_wanted =
        iterations > always_tolerated_iterations &&
        per_digit > (multigrid ? tolerated_growth * when_new : patience);
    is_new = false;
  }



  bool
  FreeBlockPreconditioner::give_up_multigrid()
  {
    const bool was_used = multigrid != nullptr;
    multigrid.reset();
    is_given_up = true;
    return was_used;
  }
} // namespace MixedCracks
