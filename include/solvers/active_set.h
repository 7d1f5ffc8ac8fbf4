// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_active_set_h
#define mixed_cracks_solvers_active_set_h

#include <base/linear_algebra.h>
#include <base/stop_request.h>

#include <solvers/free_block_preconditioner.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// A quadratic problem with bounds: minimise 1/2 x.Kx + ... with
  /// lower <= x <= upper, given by its residual at the start. Vectors without
  /// ghosts.
  struct BoundedProblem
  {
    const LinearAlgebra::SparseMatrix &matrix;
    const LinearAlgebra::Vector       &lower;
    const LinearAlgebra::Vector       &upper;
    /// lumped mass: residual / scale is an energy density (MPa); where G_c
    /// varies, mass times G_c: it is an energy density over G_c (1/mm)
    const LinearAlgebra::Vector &scale;
    /// owned dofs that a constraint determines: never held, never moved
    const std::vector<bool> &constrained;
    /// of the unit of residual / scale: matrix + concavity * scale is
    /// positive definite whatever is free
    double concavity = 0.;
    /// asked in every iteration, and in some of each linear solve
    StopCheck stop = {};
  };

  struct ActiveSetOptions
  {
    /// largest residual / scale of a free dof at the end
    double       tolerance      = 1e-9;
    unsigned int max_iterations = 500;
    /// iterations per digit with the diagonal; beyond, there is multigrid
    double patience = default_patience;
  };

  struct ActiveSetOutcome
  {
    bool         converged         = false;
    unsigned int iterations        = 0;
    unsigned int linear_iterations = 0;
    /// dofs held at a bound at the end, and how many changed sides in all
    dealii::types::global_dof_index n_active  = 0;
    dealii::types::global_dof_index n_changes = 0;
    /// largest residual of a free dof over its scale at the end, MPa
    double      residual = 0.;
    std::string reason; ///< why it stopped short, in words
  };

  /// Primal-dual active set method with two bounds whose iterates stay between
  /// them. There the criterion of [HWW15], multiplier + c (x - bound), is the
  /// sign of the multiplier at the bound, whatever the constant c. Each
  /// iteration solves on the free dofs, by preconditioned conjugate gradients,
  /// and follows the solution along its projection on the bounds as far as the
  /// energy falls (More and Toraldo, SIAM J. Optim. 1 (1991)). Without that,
  /// the sets cycle in most iterations of a growing crack: the consistent mass
  /// of a strained crack has positive entries beside the diagonal. Where the
  /// operator of Wu's functional is indefinite, a direction of negative
  /// curvature leads to a bound. The matrix is assembled once.
  class ActiveSetSolver
  {
  public:
    explicit ActiveSetSolver(const ActiveSetOptions &options);

    /// Forget what was kept: the dofs are others.
    void reinit();

    /// @p solution and @p residual (the gradient at it) on entry at the start,
    /// on exit at the solution. Collective.
    ActiveSetOutcome solve(const BoundedProblem  &problem,
                           LinearAlgebra::Vector &solution,
                           LinearAlgebra::Vector &residual);

  private:
    ActiveSetOptions        options;
    FreeBlockPreconditioner preconditioner;
  };
} // namespace MixedCracks

#endif
