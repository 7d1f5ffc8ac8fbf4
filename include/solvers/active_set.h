// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_active_set_h
#define mixed_cracks_solvers_active_set_h

#include <core/linear_algebra.h>

#include <solvers/linear_solver.h>

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
    /// owned dofs that a constraint determines: never active, never moved
    const std::vector<bool> &constrained;
  };

  struct ActiveSetOptions
  {
    /// c of the criterion, of the unit of residual / scale: 10 G_c / l
    double       weight                = 1.;
    double       relative_tolerance    = 1e-10; ///< of the linear solves
    unsigned int max_iterations        = 12;  ///< then the safeguard takes over
    unsigned int max_descents          = 500; ///< iterations of the safeguard
    unsigned int max_linear_iterations = 300;
  };

  struct ActiveSetOutcome
  {
    bool         converged         = false;
    unsigned int iterations        = 0;
    unsigned int linear_iterations = 0;
    /// how many of the iterations were those of the safeguard
    unsigned int descents = 0;
    /// dofs held at a bound at the end, and how many changed sides in all
    dealii::types::global_dof_index n_active  = 0;
    dealii::types::global_dof_index n_changes = 0;
    /// largest residual of a free dof over its scale at the end, MPa
    double      residual = 0.;
    std::string reason; ///< why it stopped short, in words
  };

  /// Primal-dual active set method [HWW15] with two bounds. The sets are
  /// algebraic: the matrix is assembled once, each iteration solves on the
  /// free dofs only, by conjugate gradients (few and well-conditioned
  /// unknowns). Where the sets do not settle, or the operator of Wu's
  /// functional is indefinite, descend_within_bounds() takes over.
  class ActiveSetSolver
  {
  public:
    explicit ActiveSetSolver(const ActiveSetOptions &options)
      : options(options)
    {}

    /// @p solution and @p residual (the gradient at it) on entry at the start,
    /// on exit at the solution. Collective.
    ActiveSetOutcome solve(const BoundedProblem  &problem,
                           LinearAlgebra::Vector &solution,
                           LinearAlgebra::Vector &residual) const;

  private:
    enum class Side : char
    {
      free,
      lower,
      upper
    };

    std::vector<Side> decide_sides(const BoundedProblem        &problem,
                                   const LinearAlgebra::Vector &solution,
                                   const LinearAlgebra::Vector &residual) const;

    LinearOutcome compute_correction(const BoundedProblem        &problem,
                                     const std::vector<Side>     &sides,
                                     const LinearAlgebra::Vector &solution,
                                     const LinearAlgebra::Vector &residual,
                                     double                       tolerance,
                                     LinearAlgebra::Vector &correction) const;

    /// Number of dofs that changed sides; sets size and residual of the
    /// outcome. Collective.
    static dealii::types::global_dof_index
    compare_sides(const BoundedProblem        &problem,
                  const std::vector<Side>     &sides,
                  const std::vector<Side>     &new_sides,
                  const LinearAlgebra::Vector &residual,
                  ActiveSetOutcome            &outcome);

    /// Leaves with converged == false when the sets do not settle: as soon
    /// as they were the same before, since then they cycle. Solves loosely
    /// until they stay the same.
    ActiveSetOutcome settle(const BoundedProblem  &problem,
                            LinearAlgebra::Vector &solution,
                            LinearAlgebra::Vector &residual) const;

    ActiveSetOptions options;
  };

  /// 1 / |diagonal| of the owned rows: the preconditioner of the free dofs.
  void invert_diagonal(const LinearAlgebra::SparseMatrix &matrix,
                       LinearAlgebra::Vector             &inverse);
} // namespace MixedCracks

#endif
