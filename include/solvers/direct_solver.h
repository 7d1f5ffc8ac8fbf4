// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_direct_solver_h
#define mixed_cracks_solvers_direct_solver_h

#include <core/linear_algebra.h>

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

  /// What is known about a matrix before its values are.
  enum class MatrixSymmetry
  {
    symmetric, ///< half the work where the package can use it
    none
  };

  /// One package behind DirectSolver; the same contract.
  class DirectSolverPackage
  {
  public:
    virtual ~DirectSolverPackage() = default;

    virtual LinearOutcome factorize() = 0;

    virtual LinearOutcome
    solve(LinearAlgebra::Vector       &solution,
          const LinearAlgebra::Vector &right_hand_side) = 0;
  };

  /// A sparse direct solver: analysis once per pattern, factorisation when
  /// values changed, solution as often as wanted. MUMPS through its own
  /// interface, or whatever Amesos of Trilinos offers. Collective.
  class DirectSolver
  {
  public:
    /// @p package: one of available_packages(), empty for the first of them.
    explicit DirectSolver(const std::string &package = "");

    /// Take the matrix, whose values may change later but not its pattern,
    /// and analyse the pattern. The matrix must outlive the solver.
    LinearOutcome initialize(const LinearAlgebra::SparseMatrix &matrix,
                             MatrixSymmetry                     symmetry);

    /// Factorise the present values.
    LinearOutcome factorize();

    /// matrix * @p solution = @p right_hand_side with the last factors.
    LinearOutcome solve(LinearAlgebra::Vector       &solution,
                        const LinearAlgebra::Vector &right_hand_side);

    /// The package in use, as "MUMPS" or "Amesos Klu".
    const std::string &
    package() const
    {
      return name;
    }

    /// Packages this program can use, the best first.
    static std::vector<std::string> available_packages();

  private:
    std::string                          name;
    std::unique_ptr<DirectSolverPackage> solver;
  };
} // namespace MixedCracks

#endif
