// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_linear_solver_h
#define mixed_cracks_solvers_linear_solver_h

#include <base/linear_algebra.h>
#include <base/registry.h>
#include <base/saddle_point_product.h>
#include <base/stop_request.h>

#include <functional>
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

  /// Matrices that are near to parts of the one to be solved with, or to its
  /// Schur complement, and easier.
  struct AuxiliaryMatrices
  {
    /// of a subspace of the displacements, which has numbers of its own;
    /// nullptr: the matrix itself serves
    const LinearAlgebra::SparseMatrix *displacement = nullptr;
    /// from the unknowns of that subspace to all; other rows are empty
    const Epetra_CrsMatrix *interpolation = nullptr;
    /// one entry per owned row of the whole: whether it is an unknown of the
    /// subspace; in their order
    const std::vector<bool> *is_coarse = nullptr;
    /// in the numbering of the whole, rows of displacements empty; positive
    /// definite; nullptr where there is no pressure
    const LinearAlgebra::SparseMatrix *pressure = nullptr;
    /// of displacements that neither smoother nor subspace reduce, in numbers
    /// of its own, to be solved for exactly; nullptr where there are none
    const LinearAlgebra::SparseMatrix *block = nullptr;
    /// positions of its owned rows among those of the whole
    const std::vector<unsigned int> *rows_of_block = nullptr;
  };

  /// A matrix with what an iterative solver wants to know about its
  /// unknowns. Direct solvers need matrix and symmetry only.
  struct LinearSystem
  {
    /// must outlive the solver; its values may change, its pattern not.
    /// nullptr for a solver that needs none.
    const LinearAlgebra::SparseMatrix *matrix = nullptr;
    /// the same as a product, for such a solver
    const SaddlePointProduct *product  = nullptr;
    MatrixSymmetry            symmetry = MatrixSymmetry::none;
    /// components of the displacement; those of one node follow each other
    unsigned int n_components = 1;
    /// one entry per owned row; the others are displacements
    std::vector<bool> is_pressure;
    /// one entry per owned row: whether a constraint determines the unknown.
    /// Its row and column hold a diagonal entry only.
    std::vector<bool> is_constrained;
    /// what costs no energy: of each motion the entries of the owned
    /// displacements that are chosen, in order. Collective.
    std::function<std::vector<std::vector<double>>(
      const std::vector<bool> &chosen)>
      rigid_body_modes;
    /// assemble for the present values of the matrix. Collective.
    std::function<AuxiliaryMatrices()> auxiliary;
    /// does the work handed over and books its time as set-up, not as
    /// solution; may be empty
    std::function<void(const std::function<void()> &work)> as_set_up;
    /// asked in every iteration and after a set-up
    StopCheck stop;
  };

  /// Options of all solvers; each takes what concerns it.
  struct LinearSolverOptions
  {
    std::string  ordering       = "automatic"; ///< of direct solvers
    unsigned int max_iterations = 200;         ///< of iterative ones
    /// A multigrid hierarchy is kept for new values of the matrix as long as
    /// it needs at most this times the iterations it needed at first; 0:
    /// always a new one.
    double tolerated_growth = 1.3;
    /// whether the matrix is a product only, see LinearSystem
    bool is_matrix_free = false;
  };

  /// Solves with one matrix, many times. Collective.
  class LinearSolver
  {
  public:
    virtual ~LinearSolver() = default;

    /// Take a system with a new pattern, and analyse it.
    virtual LinearOutcome initialize(const LinearSystem &system) = 0;

    /// Let go of the present system: to be called before its matrix gets
    /// another pattern, for libraries ask the old one to the last.
    virtual void
    release()
    {}

    /// Take the present values of the matrix.
    virtual LinearOutcome factorize() = 0;

    /// matrix * @p solution = @p right_hand_side, the residual reduced by
    /// @p relative_tolerance at least; direct solvers take no notice of it.
    virtual LinearOutcome solve(LinearAlgebra::Vector       &solution,
                                const LinearAlgebra::Vector &right_hand_side,
                                double relative_tolerance) = 0;

    /// Whether factors are expensive, and good for many exact solutions.
    virtual bool is_direct() const = 0;

    /// Whether LinearSystem::matrix is used, or LinearSystem::product.
    virtual bool
    needs_matrix() const
    {
      return true;
    }

    /// How often factors or hierarchies were computed.
    virtual unsigned int n_setups() const = 0;

    /// In a few words, for the log.
    virtual std::string description() const = 0;
  };

  /// Linear solvers by name: "direct", "block AMG" and "matrix-free".
  const Registry<LinearSolver, const LinearSolverOptions &> &
  all_linear_solvers();

  /// Which solver is used, and why.
  struct LinearSolverChoice
  {
    std::string name;
    std::string reason; ///< empty where the user named it
  };

  /// "auto" resolved by dimension and number of unknowns of the matrix
  /// (doc/solvers.md); other names are returned as they are. @p has_products:
  /// whether there are products without a matrix.
  LinearSolverChoice
  choose_linear_solver(const std::string              &name,
                       int                             dim,
                       dealii::types::global_dof_index n_dofs,
                       bool                            has_products);
} // namespace MixedCracks

#endif
