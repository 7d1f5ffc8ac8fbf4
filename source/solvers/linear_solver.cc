// SPDX-License-Identifier: GPL-2.0-or-later
// The choice of the solver for the elastic system. A factorisation of a sparse
// matrix with N unknowns, ordered by nested dissection or near to it, takes
//
//   2-d   N^(3/2) operations, N log N entries
//   3-d   N^2     operations, N^(4/3) entries,
//
// the iterative one a number of iterations that hardly grows, each of order N.
// In the plane factors also serve several Newton iterations, which is why
// direct solution is good for a million unknowns there, and for some ten
// thousand in space. Without its matrix the iterative one takes as many
// iterations, each of less work.

#include <solvers/block_amg.h>
#include <solvers/direct_solver.h>
#include <solvers/linear_solver.h>

namespace MixedCracks
{
  namespace
  {
    // Unknowns of the matrix from which on an iterative solution is chosen. In
    // 3-d between two measurements, in 2-d extrapolated from them:
    // doc/solvers.md.
    constexpr dealii::types::global_dof_index crossover_2d = 1000000;
    constexpr dealii::types::global_dof_index crossover_3d = 12000;
  } // namespace



  const Registry<LinearSolver, const LinearSolverOptions &> &
  all_linear_solvers()
  {
    static const Registry<LinearSolver, const LinearSolverOptions &> list(
      "linear solver",
      {{"direct",
        "a sparse direct solver, the best one that is there (MUMPS, "
        "distributed, before those of Trilinos); the log names it",
        [](
          const LinearSolverOptions &options) -> std::unique_ptr<LinearSolver> {
          return std::make_unique<DirectSolver>("", options.ordering);
        }},
       {"block AMG",
        "FGMRES with a block-triangular preconditioner, algebraic multigrid "
        "for u and a weighted mass matrix for p; in the displacement "
        "formulation conjugate gradients with the multigrid alone. Memory and "
        "time grow with the number of unknowns",
        [](
          const LinearSolverOptions &options) -> std::unique_ptr<LinearSolver> {
          return std::make_unique<BlockAmgSolver>(options);
        }},
       {"matrix-free",
        "block AMG without its largest matrix: products with it are integrated "
        "cell by cell each time, and multigrid has the matrix of linear "
        "displacements only. Mixed formulation. The least memory, and in 3-d "
        "the least time",
        [](
          const LinearSolverOptions &options) -> std::unique_ptr<LinearSolver> {
          LinearSolverOptions matrix_free = options;
          matrix_free.is_matrix_free      = true;
          return std::make_unique<BlockAmgSolver>(matrix_free);
        }}});
    return list;
  }



  LinearSolverChoice
  choose_linear_solver(const std::string                    &name,
                       const int                             dim,
                       const dealii::types::global_dof_index n_dofs,
                       const bool                            has_products)
  {
    if (name != "auto")
      return {name, ""};
    const auto        crossover = dim == 2 ? crossover_2d : crossover_3d;
    const bool        iterative = n_dofs >= crossover;
    const std::string reason    = std::to_string(n_dofs) + " unknowns, " +
                               (iterative ? "at least " : "fewer than ") +
                               std::to_string(crossover) + " in " +
                               std::to_string(dim) + "-d";
    return {iterative ? (has_products ? "matrix-free" : "block AMG") : "direct",
            reason};
  }
} // namespace MixedCracks
