// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_free_block_preconditioner_h
#define mixed_cracks_solvers_free_block_preconditioner_h

#include <base/linear_algebra.h>

#include <solvers/multigrid.h>

#include <memory>
#include <vector>

namespace MixedCracks
{
  struct BoundedProblem;

  /// Where the diagonal needs more iterations per digit than this, a hierarchy
  /// is worth its set-up (doc/solvers.md, "Phase field").
  constexpr double default_patience = 15.;

  /// Preconditioner of the phase field on the dofs that no bound holds: its
  /// diagonal, where l/h is small and that is enough, else a cycle of
  /// multigrid. A hierarchy belongs to the values and the free dofs it was
  /// made for. It serves others as long as they are alike: held dofs are left
  /// out, those that it does not know get the diagonal.
  class FreeBlockPreconditioner
  {
  public:
    /// @p patience: iterations per digit that the diagonal may take before a
    /// hierarchy is made.
    explicit FreeBlockPreconditioner(double patience);

    /// The dofs are others: forget all but that a hierarchy was worth it.
    void clear();

    /// For the present values of the matrix; to be called when they changed.
    void set_matrix(const BoundedProblem &problem);

    /// For these free dofs. Makes a hierarchy if the last solve says so.
    /// Collective.
    void restrict_to(const BoundedProblem    &problem,
                     const std::vector<bool> &is_free);

    /// Free entries of @p result; the others become 0. Collective.
    void vmult(LinearAlgebra::Vector       &result,
               const LinearAlgebra::Vector &source) const;

    /// What the last solve took; the same on every rank.
    void note_solve(unsigned int iterations, double digits);

    /// Use the diagonal from now on, until clear(). False if it was used
    /// already. For hierarchies that proved not to be positive definite.
    bool give_up_multigrid();

  private:
    void make_hierarchy(const BoundedProblem &problem);

    double                      patience;
    bool                        is_given_up = false;
    bool                        is_wanted   = false;
    bool                        is_new      = false;
    double                      when_new    = 0.; // iterations per digit
    std::unique_ptr<Multigrid>  multigrid;
    std::vector<bool>           is_free;  // now
    std::vector<bool>           is_known; // to the hierarchy
    LinearAlgebra::Vector       inverse_diagonal;
    mutable std::vector<double> part, image;
  };
} // namespace MixedCracks

#endif
