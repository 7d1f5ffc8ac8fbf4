// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_direct_solver_h
#define mixed_cracks_solvers_direct_solver_h

#include <solvers/linear_solver.h>

#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// One package behind DirectSolver; the same contract.
  class DirectSolverPackage
  {
  public:
    virtual ~DirectSolverPackage() = default;

    virtual LinearOutcome factorize() = 0;

    virtual LinearOutcome
    solve(LinearAlgebra::Vector       &solution,
          const LinearAlgebra::Vector &right_hand_side) = 0;

    /// Of the unknowns, by the analysis; empty where it is not known.
    virtual std::string
    ordering() const
    {
      return "";
    }
  };

  /// A sparse direct solver: analysis once per pattern, factorisation when
  /// values changed, solution as often as wanted. MUMPS through its own
  /// interface, or whatever Amesos of Trilinos offers. Collective.
  class DirectSolver : public LinearSolver
  {
  public:
    /// @p package: one of available_packages(), empty for the first of them.
    /// @p ordering: one of Mumps::orderings(); others choose their own.
    explicit DirectSolver(const std::string &package  = "",
                          const std::string &ordering = "automatic");

    /// Take the matrix, whose values may change later but not its pattern,
    /// and analyse the pattern. The matrix must outlive the solver.
    LinearOutcome initialize(const LinearAlgebra::SparseMatrix &matrix,
                             MatrixSymmetry                     symmetry);

    LinearOutcome initialize(const LinearSystem &system) override;

    void
    release() override
    {
      solver.reset();
    }

    LinearOutcome factorize() override;

    /// matrix * @p solution = @p right_hand_side with the last factors.
    LinearOutcome solve(LinearAlgebra::Vector       &solution,
                        const LinearAlgebra::Vector &right_hand_side);

    LinearOutcome solve(LinearAlgebra::Vector       &solution,
                        const LinearAlgebra::Vector &right_hand_side,
                        double relative_tolerance) override;

    bool
    is_direct() const override
    {
      return true;
    }

    unsigned int
    n_setups() const override
    {
      return n_factorizations;
    }

    /// The package and the ordering, with a word where another was asked for.
    std::string description() const override;

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
    std::string                          ordering;
    std::unique_ptr<DirectSolverPackage> solver;
    unsigned int                         n_factorizations = 0;
  };
} // namespace MixedCracks

#endif
