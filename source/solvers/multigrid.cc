// SPDX-License-Identifier: GPL-2.0-or-later
// Smoothed aggregation (Vanek, Mandel and Brezina, Computing 56 (1996)), by ML.
// On each level nodes are put together to aggregates, and the prolongator is
//
//   P = (1 - omega/lambda_max D^-1 A) T,    A_coarse = P^T A P,
//
// T the given coarse functions (rigid body modes of elasticity, the constant
// for the phase field), restricted to each aggregate and made orthonormal
// there: what costs no energy is represented exactly on every level. omega is
// prolongator_damping, 4/3 in theory and 3/2 for elasticity here
// (doc/solvers.md). Entries with |a_ij| below weak_coupling * sqrt(a_ii a_jj)
// do not join nodes.
//
// Coarse unknowns per aggregate: as many as coarse functions, 3 in the plane
// and 6 in space (elasticity), 1 (phase field). Smoothers are Chebyshev
// polynomials before and after, so that the cycle is symmetric; the coarsest
// level is factorised. Of elasticity, products with the finest matrix are two
// thirds of a cycle, and P^T A P of it was most of a hierarchy: ML is given
// both in blocks (NodeBlocks, set_galerkin_product).

#include <deal.II/base/exceptions.h>

#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <Epetra_Vector.h>
#include <Ifpack.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_amesos.h>
#include <ml_epetra_utils.h>
#include <ml_include.h>
#include <solvers/galerkin_product.h>
#include <solvers/multigrid.h>
#include <solvers/node_blocks.h>

#include <algorithm>
#include <utility>

namespace MixedCracks
{
  namespace
  {
    using dealii::ExcMessage;

    // unknowns that the direct solver is left with, at most; its factors are
    // nearly dense and on one rank: 1500 take longer, and save no iteration
    constexpr int coarsest_size = 500;

    // levels that there may be; each has less than a fifth of the unknowns of
    // the one before
    constexpr int most_levels = 10;

    // of the largest eigenvalue that conjugate gradients find in so many
    // iterations, up to which polynomials smooth
    constexpr double eigenvalue_boost       = 1.1;
    constexpr int    iterations_eigenvalues = 10;
  } // namespace



  MultigridOptions
  MultigridOptions::elastic(const unsigned int n_components)
  {
    MultigridOptions options;
    options.n_components    = n_components;
    options.w_cycle         = true;
    options.smoother_degree = 2;
    options.weak_coupling   = 0.003;
    // the usual 4/3 needs one iteration more, up to three in the displacement
    // formulation
    options.prolongator_damping = 1.5;
    return options;
  }



  // Levels 0 (finest) to the coarsest, by the functions of ML in C: with its
  // class MultiLevelPreconditioner ML finds all products P^T A P itself.
  class Multigrid::Hierarchy
  {
  public:
    Hierarchy(const Epetra_CrsMatrix                 &matrix,
              const MultigridOptions                 &options,
              const std::vector<std::vector<double>> &modes);
    ~Hierarchy();

    void   vmult(double *result, const double *source);
    double operator_complexity() const;

  private:
    void set_coarsening(const std::vector<std::vector<double>> &modes);
    void make_levels(unsigned int n_modes);
    void set_smoothers();
    void use_faster_products();

    int
    n_rows(const int level) const
    {
      return ML_Comm_GsumInt(ml->comm, ml->Amat[level].outvec_leng);
    }

    static int multiply(ML_Operator *level, int, double *, int, double *);

    const Epetra_CrsMatrix     &matrix;
    const MultigridOptions      options;
    ML                         *ml         = nullptr;
    ML_Aggregate               *aggregates = nullptr;
    int                         coarsest   = 0;
    std::unique_ptr<NodeBlocks> blocks; // of the finest matrix
    void                       *data_of_ml = nullptr;
  };



  Multigrid::Hierarchy::Hierarchy(const Epetra_CrsMatrix &matrix,
                                  const MultigridOptions &options,
                                  const std::vector<std::vector<double>> &modes)
    : matrix(matrix)
    , options(options)
  {
    ML_Set_PrintLevel(0);
    ML_Create2(&ml,
               most_levels,
               dynamic_cast<const Epetra_MpiComm &>(matrix.Comm()).Comm());
    EpetraMatrix2MLMatrix(ml, 0, const_cast<Epetra_CrsMatrix *>(&matrix));
    ml->Cheby_eig_boost = eigenvalue_boost;
    ML_Set_SpectralNormScheme_Calc(ml);
    ML_Set_SpectralNorm_Iterations(ml, iterations_eigenvalues);
    ML_Aggregate_Create(&aggregates);
    set_coarsening(modes);
    make_levels(modes.size());
    set_smoothers();
    ML_Gen_Solver(ml, options.w_cycle ? ML_MGW : ML_MGV, 0, coarsest);
    if (options.n_components > 1)
      use_faster_products();
  }



  Multigrid::Hierarchy::~Hierarchy()
  {
    if (blocks)
      ml->Amat[0].data = data_of_ml;
    ML_Aggregate_Destroy(&aggregates);
    ML_Destroy(&ml);
  }



  void
  Multigrid::Hierarchy::set_coarsening(
    const std::vector<std::vector<double>> &modes)
  {
    std::vector<double> all_modes;
    for (const std::vector<double> &mode : modes)
      all_modes.insert(all_modes.end(), mode.begin(), mode.end());
    ML_Aggregate_Set_MaxLevels(aggregates, most_levels);
    ML_Aggregate_Set_StartLevel(aggregates, 0);
    ML_Aggregate_Set_CoarsenScheme_Uncoupled(aggregates);
    ML_Aggregate_Set_Threshold(aggregates, options.weak_coupling);
    ML_Aggregate_Set_DampingFactor(aggregates, options.prolongator_damping);
    ML_Aggregate_Set_PointDiagScaling(aggregates);
    ML_Aggregate_Set_MaxCoarseSize(aggregates, coarsest_size);
    ML_Aggregate_Set_NullSpace(aggregates,
                               options.n_components,
                               modes.size(),
                               all_modes.data(),
                               matrix.NumMyRows());
  }



  // until the coarsest size is reached, or nothing gets smaller
  void
  Multigrid::Hierarchy::make_levels(const unsigned int n_modes)
  {
    const bool in_blocks = (options.n_components == 2 && n_modes == 3) ||
                           (options.n_components == 3 && n_modes == 6);
    ml->ML_finest_level = 0;
    ml->LevelID[0]      = 0;
    int next            = ML_AGG_Increment_Level(ml, coarsest, aggregates);
    while (next >= 0 &&
           ML_MultiLevel_Gen_Prolongator(ml, coarsest, next, aggregates) >= 0)
    {
      ML_MultiLevel_Gen_Restriction(ml, coarsest, next, aggregates);
      if (coarsest == 0 && in_blocks)
        set_galerkin_product(*ml, matrix, options.n_components, n_modes);
      else
        ML_Gen_AmatrixRAP(ml, coarsest, next);
      coarsest              = next;
      ml->LevelID[coarsest] = coarsest;
      next                  = ML_AGG_Increment_Level(ml, coarsest, aggregates);
    }
  }



  // polynomials reach down to what the next level takes
  void
  Multigrid::Hierarchy::set_smoothers()
  {
    for (int level = 0; level < coarsest; ++level)
      ML_Gen_Smoother_Cheby(
        ml,
        level,
        ML_BOTH,
        std::max(options.smoothed_range,
                 static_cast<double>(n_rows(level)) / n_rows(level + 1)),
        options.smoother_degree);
    ML_Gen_Smoother_Amesos(ml,
                           coarsest,
                           ML_AMESOS_KLU,
                           /*MaxProcs=*/-1,
                           /*AddToDiag=*/0.,
                           /*SplitComm=*/1);
  }



  // ML has read the matrix, and needs its products only
  void
  Multigrid::Hierarchy::use_faster_products()
  {
    ML_Operator &finest = ml->Amat[0];
    blocks     = std::make_unique<NodeBlocks>(matrix, options.n_components);
    data_of_ml = std::exchange(finest.data, blocks.get());
    finest.matvec->func_ptr = multiply;
  }



  int
  Multigrid::Hierarchy::multiply(ML_Operator *level,
                                 int,
                                 double *source,
                                 int,
                                 double *result)
  {
    static_cast<const NodeBlocks *>(level->data)->vmult(result, source);
    return 0;
  }



  void
  Multigrid::Hierarchy::vmult(double *result, const double *source)
  {
    ML_Cycle_MG(&ml->SingleLevel[0],
                result,
                const_cast<double *>(source),
                ML_ZERO,
                ml->comm,
                ML_NO_RES_NORM,
                ml);
  }



  double
  Multigrid::Hierarchy::operator_complexity() const
  {
    double all = matrix.NumGlobalNonzeros();
    for (int level = 1; level <= coarsest; ++level)
      all += ML_Comm_GsumDouble(ml->comm, ml->Amat[level].N_nonzeros);
    return all / matrix.NumGlobalNonzeros();
  }



  Multigrid::Multigrid(std::shared_ptr<const Epetra_CrsMatrix> new_matrix,
                       const MultigridOptions                 &options,
                       const std::vector<std::vector<double>> &modes)
    : matrix(std::move(new_matrix))
    , hierarchy(std::make_unique<Hierarchy>(*matrix, options, modes))
  {}



  Multigrid::~Multigrid() = default;



  void
  Multigrid::vmult(double *result, const double *source) const
  {
    hierarchy->vmult(result, source);
  }



  double
  Multigrid::operator_complexity() const
  {
    return hierarchy->operator_complexity();
  }



  // ILU(0), of the rows of each rank and those next to them: for a mass matrix,
  // whose condition does not depend on h, no more is needed. Without the
  // latter GMRES needs one iteration more on two ranks than on one.
  MassSolver::MassSolver(std::unique_ptr<Epetra_CrsMatrix> new_matrix)
    : matrix(std::move(new_matrix))
  {
    Ifpack        preconditioners;
    constexpr int overlap = 1; // layers of rows of other ranks
    factors.reset(preconditioners.Create("ILU", matrix.get(), overlap));
    Teuchos::ParameterList list;
    list.set("fact: level-of-fill", 0);
    // it takes as long as the factors, and nobody reads it
    list.set("schwarz: compute condest", false);
    factors->SetParameters(list);
    const int error = factors->Initialize() + factors->Compute();
    AssertThrow(error == 0, ExcMessage("incomplete factorisation failed"));
  }



  MassSolver::~MassSolver() = default;



  void
  MassSolver::vmult(double *result, const double *source) const
  {
    const Epetra_Map   &map = matrix->RowMap();
    const Epetra_Vector in(View, map, const_cast<double *>(source));
    Epetra_Vector       out(View, map, result);
    const int           error = factors->ApplyInverse(in, out);
    AssertThrow(error == 0, ExcMessage("a preconditioner failed"));
  }
} // namespace MixedCracks
