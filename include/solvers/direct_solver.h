// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_direct_solver_h
#define mixed_cracks_solvers_direct_solver_h

#include <core/linear_algebra.h>

#include <Amesos_BaseSolver.h>
#include <Epetra_LinearProblem.h>

#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// What became of a linear solve; the same on every rank.
  struct LinearOutcome
  {
    bool         success    = true;
    unsigned int iterations = 0;
    std::string  reason; ///< why it failed, in words
  };

  /// A sparse direct solver of Trilinos, through Amesos itself: analysis once
  /// per pattern, factorisation when values changed, solution as often as
  /// wanted. (TrilinosWrappers::SolverDirect redoes the analysis each time,
  /// and crashes on a second initialize() with MUMPS.)
  class DirectSolver
  {
  public:
    DirectSolver();

    /// Take the matrix, whose values may change later but not its pattern,
    /// and analyse the pattern. The matrix must outlive the solver.
    LinearOutcome initialize(const LinearAlgebra::SparseMatrix &matrix);

    /// Factorise the present values.
    LinearOutcome factorize();

    /// matrix * @p solution = @p right_hand_side with the last factors.
    LinearOutcome solve(LinearAlgebra::Vector       &solution,
                        const LinearAlgebra::Vector &right_hand_side) const;

    /// The package in use, as "MUMPS".
    const std::string &
    package() const
    {
      return name;
    }

    /// Packages this program can use, the best first.
    static std::vector<std::string> available_packages();

  private:
    std::string                           name;
    std::unique_ptr<Epetra_LinearProblem> problem;
    std::unique_ptr<Amesos_BaseSolver>    solver;
  };
} // namespace MixedCracks

#endif
