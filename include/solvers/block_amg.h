// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_block_amg_h
#define mixed_cracks_solvers_block_amg_h

#include <solvers/assembled_product.h>
#include <solvers/chebyshev.h>
#include <solvers/convergence_record.h>
#include <solvers/exact_block.h>
#include <solvers/linear_solver.h>
#include <solvers/multigrid.h>

namespace MixedCracks
{
  /// Iterative solver for displacement and pressure. The matrix
  ///
  ///     ( A  B^T )        is preconditioned from    ( A~  B^T )
  ///     ( B  -C  )        the right by              ( 0   -S~ )
  ///
  /// A~: one multigrid cycle. Where LinearSystem::auxiliary has a coarse
  /// displacement matrix, of a subspace, a cycle on that and then a Chebyshev
  /// smoother on A, which takes what the subspace lacks. S~, near to
  /// C + B A^-1 B^T: incomplete factors of its pressure matrix. B need not be
  /// the transpose of B^T. Without a pressure and with a symmetric matrix:
  /// conjugate gradients with the cycle alone.
  class BlockAmgSolver : public LinearSolver
  {
  public:
    explicit BlockAmgSolver(const LinearSolverOptions &options);
    ~BlockAmgSolver() override;

    LinearOutcome initialize(const LinearSystem &system) override;

    /// Only notes that the hierarchy is old; it may be good enough.
    LinearOutcome factorize() override;

    LinearOutcome solve(LinearAlgebra::Vector       &solution,
                        const LinearAlgebra::Vector &right_hand_side,
                        double relative_tolerance) override;

    bool
    is_direct() const override
    {
      return false;
    }

    bool
    needs_matrix() const override
    {
      return !options.is_matrix_free;
    }

    unsigned int
    n_setups() const override
    {
      return n_hierarchies;
    }

    std::string description() const override;

    /// Of the present hierarchy.
    double operator_complexity() const;

  private:
    using Vector = SaddlePointProduct::Vector;
    class ScaledMatrix;
    class Preconditioner;

    void set_up();

    void drop_hierarchy();

    /// The weighted mass matrix and the coupling, and a scale for its rows.
    void set_up_pressure(const LinearAlgebra::SparseMatrix &mass);

    /// Smoother and coarse level.
    void set_up_two_levels(const AuxiliaryMatrices &auxiliary);

    /// Continue from what is found already until the residual is below
    /// @p relative_tolerance of the right hand side, both scaled, or an old
    /// hierarchy has grown too slow.
    LinearOutcome iterate(double                       relative_tolerance,
                          const LinearAlgebra::Vector &right_hand_side);

    /// The same, by an old hierarchy or a new one.
    LinearOutcome find(const LinearAlgebra::Vector &right_hand_side,
                       double                       relative_tolerance);

    /// Multiply the rows of pressures so that they count as those of
    /// displacements do.
    void scale_pressure_rows(Vector &vector) const;

    /// What owned row @p i is multiplied by.
    double
    scale_of(const unsigned int i) const
    {
      return system.is_pressure[i] ? pressure_scale : 1.;
    }

    const SaddlePointProduct &
    product() const
    {
      return assembled ? *assembled : *system.product;
    }

    bool uses_conjugate_gradients() const;

    LinearSolverOptions        options;
    LinearSystem               system;
    bool                       has_pressure = false; // on any rank
    std::vector<bool>          is_displacement;
    std::vector<unsigned int>  pressures, constrained; // positions of owned
    std::unique_ptr<Multigrid> multigrid;
    /// from coarse displacements to all; null where multigrid works on A
    const Epetra_CrsMatrix            *interpolation = nullptr;
    std::unique_ptr<ChebyshevSmoother> smoother;
    std::unique_ptr<ExactBlock>        exact_block; // after the smoother
    std::unique_ptr<MassSolver>        mass_solver;
    /// of LinearSystem::matrix, if there is one
    std::unique_ptr<AssembledProduct> assembled;
    Vector                            known, found;
    double                            pressure_scale  = 1.;
    double                            matrix_diagonal = 0.; // mean, of A
    bool                              is_old          = false;
    /// of the last new hierarchy that has one, and whether it is the present
    /// one
    ConvergenceRecord when_new;
    bool              is_recorded   = false;
    unsigned int      n_hierarchies = 0;
    /// next matrices for which no old hierarchy is tried; how many they were
    /// after the last one that was given up
    unsigned int n_untried = 0, pause = 0;
  };
} // namespace MixedCracks

#endif
