// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_multigrid_h
#define mixed_cracks_solvers_multigrid_h

#include <Epetra_CrsMatrix.h>

#include <memory>
#include <vector>

class Ifpack_Preconditioner;

namespace MixedCracks
{
  /// How a hierarchy is made and used; as it stands for one unknown per node.
  struct MultigridOptions
  {
    unsigned int n_components = 1;
    bool         w_cycle      = false;
    /// of the Chebyshev polynomials before and after each coarse step
    int smoother_degree = 1;
    /// of the largest eigenvalue to the least one that is smoothed
    double smoothed_range = 20.;
    /// Entries below this, relative to the diagonal, do not join aggregates;
    /// on each coarser level half of it. Without it the aggregates of coarser
    /// levels of elasticity are poor where cells differ in size.
    double weak_coupling = 0.;
    /// of the Jacobi step that smooths prolongators, over the largest
    /// eigenvalue
    double prolongator_damping = 4. / 3.;

    /// Elasticity, with what doc/solvers.md found best.
    static MultigridOptions elastic(unsigned int n_components);
  };

  /// One cycle of algebraic multigrid: smoothed aggregation by ML, Vanek,
  /// Mandel and Brezina, Computing 56 (1996), with given coarse functions and
  /// Chebyshev smoothers. A fixed linear operator, symmetric, and positive
  /// definite if the matrix is.
  class Multigrid
  {
  public:
    /// @p matrix: the components of a node follow each other. @p modes: the
    /// coarse functions, one vector of the owned rows each.
    Multigrid(std::shared_ptr<const Epetra_CrsMatrix> matrix,
              const MultigridOptions                 &options,
              const std::vector<std::vector<double>> &modes);
    ~Multigrid();

    /// Owned rows only. Collective.
    void vmult(double *result, const double *source) const;

    /// Entries of all levels over those of the first.
    double operator_complexity() const;

  private:
    class Hierarchy;

    std::shared_ptr<const Epetra_CrsMatrix> matrix;
    std::unique_ptr<Hierarchy>              hierarchy;
  };

  /// Incomplete factors without fill of a mass matrix, those of each rank
  /// with a layer of overlap.
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
