// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_amesos_h
#define mixed_cracks_solvers_amesos_h

#include <Amesos_BaseSolver.h>
#include <Epetra_LinearProblem.h>
#include <solvers/direct_solver.h>

namespace MixedCracks
{
  /// A direct solver of Trilinos, through Amesos itself:
  /// TrilinosWrappers::SolverDirect redoes the analysis each time, and
  /// crashes on a second initialize() with MUMPS.
  class AmesosSolver : public DirectSolverPackage
  {
  public:
    /// Names of the packages this Trilinos has, the best first, as "Klu".
    static std::vector<std::string> available_packages();

    /// Analyse the pattern; @p outcome says whether that succeeded.
    AmesosSolver(const std::string                 &package,
                 const LinearAlgebra::SparseMatrix &matrix,
                 LinearOutcome                     &outcome);

    LinearOutcome factorize() override;

    LinearOutcome solve(LinearAlgebra::Vector       &solution,
                        const LinearAlgebra::Vector &right_hand_side) override;

  private:
    std::string                        name;
    Epetra_LinearProblem               problem;
    std::unique_ptr<Amesos_BaseSolver> solver;
  };
} // namespace MixedCracks

#endif
