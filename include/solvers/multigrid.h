// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_multigrid_h
#define mixed_cracks_solvers_multigrid_h

#include <core/linear_algebra.h>

#include <Epetra_CrsMatrix.h>

#include <memory>
#include <vector>

namespace ML_Epetra
{
  class MultiLevelPreconditioner;
}
class Ifpack_Preconditioner;

namespace MixedCracks
{
  /// The owned rows of a square @p matrix that have @p rows set, and the
  /// columns that have @p columns set, both renumbered without gaps: a copy
  /// with values of its own. Collective.
  std::unique_ptr<Epetra_CrsMatrix>
  extract_block(const Epetra_CrsMatrix  &matrix,
                const std::vector<bool> &rows,
                const std::vector<bool> &columns);

  /// @p result = @p matrix * @p source, or with its transpose, owned entries
  /// only. Collective.
  void multiply(const Epetra_CrsMatrix &matrix,
                double                 *result,
                const double           *source,
                bool                    transposed = false);

  struct MultigridOptions
  {
    /// of the Chebyshev polynomials before and after each coarse step
    unsigned int smoother_degree = 2;
    /// of the largest eigenvalue to the least one that is smoothed
    double smoothed_range = 20.;
    /// Entries below this, relative to the diagonal, do not join aggregates;
    /// on each coarser level half of it. Without it the aggregates of coarser
    /// levels are poor where cells differ in size, and iterations grow.
    double weak_coupling = 0.003;
  };

  /// One cycle of algebraic multigrid for an elastic operator: smoothed
  /// aggregation by ML, Vanek, Mandel and Brezina, Computing 56 (1996), with
  /// the rigid body modes as coarse functions, Chebyshev smoothers and a
  /// W-cycle. A fixed linear operator, symmetric positive definite.
  class Multigrid
  {
  public:
    /// @p matrix: the components of a node follow each other, @p n_components
    /// of them. @p modes: one vector of the owned rows each.
    Multigrid(std::unique_ptr<Epetra_CrsMatrix>       matrix,
              unsigned int                            n_components,
              const std::vector<std::vector<double>> &modes,
              const MultigridOptions                 &options = {});
    ~Multigrid();

    /// Owned rows only. Collective.
    void vmult(double *result, const double *source) const;

    /// Entries of all levels over those of the first.
    double operator_complexity() const;

  private:
    std::unique_ptr<Epetra_CrsMatrix>                    matrix;
    std::unique_ptr<ML_Epetra::MultiLevelPreconditioner> cycle;
  };

  /// Incomplete Cholesky-like factors without fill of a mass matrix, those of
  /// each rank apart.
  class MassSolver
  {
  public:
    explicit MassSolver(std::unique_ptr<Epetra_CrsMatrix> matrix);
    ~MassSolver();

    /// Owned rows only. Collective.
    void vmult(double *result, const double *source) const;

  private:
    std::unique_ptr<Epetra_CrsMatrix>      matrix;
    std::unique_ptr<Ifpack_Preconditioner> factors;
  };
} // namespace MixedCracks

#endif
