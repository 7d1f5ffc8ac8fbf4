// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_mumps_h
#define mixed_cracks_solvers_mumps_h

#include <solvers/direct_solver.h>

namespace MixedCracks
{
  /// MUMPS through its own C interface. Amesos_Mumps knows no LDL^T, and on
  /// several ranks it copies the matrix, with its graph, for each
  /// factorisation; doc/performance.md has the figures.
  class Mumps : public DirectSolverPackage
  {
  public:
    /// False where the program was built without MUMPS.
    static bool is_available();

    /// Names of the orderings MUMPS may have been built with; "automatic",
    /// which leaves the choice to MUMPS, before the others. "METIS" is there
    /// also where only this program has it.
    static std::vector<std::string> orderings();

    /// Analyse the pattern; @p outcome says whether that succeeded.
    /// @p ordering: one of orderings(). MUMPS takes another one where it has
    /// not got it.
    Mumps(const LinearAlgebra::SparseMatrix &matrix,
          MatrixSymmetry                     symmetry,
          LinearOutcome                     &outcome,
          const std::string                 &ordering = "automatic");

    ~Mumps() override;

    LinearOutcome factorize() override;

    LinearOutcome solve(LinearAlgebra::Vector       &solution,
                        const LinearAlgebra::Vector &right_hand_side) override;

    /// The one the analysis has used.
    std::string ordering() const override;

    /// Entries of the factors, as the analysis estimates them; for
    /// measurements.
    double n_entries_of_factors() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace MixedCracks

#endif
