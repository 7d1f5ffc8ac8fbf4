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
// level is factorised. Elasticity takes two thirds of a cycle for products with
// its finest matrix: ML makes the hierarchy of it and is then given those of
// NodeBlocks.

#include <deal.II/base/exceptions.h>

#include <Epetra_Import.h>
#include <Epetra_IntVector.h>
#include <Epetra_Map.h>
#include <Epetra_Vector.h>
#include <Ifpack.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>
#include <solvers/multigrid.h>

#include <algorithm>

namespace MixedCracks
{
  namespace
  {
    using dealii::ExcMessage;

    // unknowns that the direct solver is left with, at most; its factors are
    // nearly dense and on one rank: 1500 take longer, and save no iteration
    constexpr int coarsest_size = 500;



    Teuchos::ParameterList
    multigrid_parameters(const MultigridOptions &options)
    {
      Teuchos::ParameterList list;
      ML_Epetra::SetDefaults("SA", list);
      list.set("ML output", 0);
      list.set("PDE equations", static_cast<int>(options.n_components));
      list.set("prec type", options.w_cycle ? "MGW" : "MGV");
      list.set("aggregation: type", "Uncoupled");
      list.set("aggregation: threshold", options.weak_coupling);
      list.set("aggregation: damping factor", options.prolongator_damping);
      list.set("smoother: type", "Chebyshev");
      list.set("smoother: sweeps", options.smoother_degree);
      list.set("smoother: Chebyshev alpha", options.smoothed_range);
      list.set("smoother: pre or post", "both");
      list.set("coarse: type", "Amesos-KLU");
      list.set("coarse: max size", coarsest_size);
      return list;
    }



    // apply an operator of Trilinos to arrays
    template <typename Operator>
    void
    apply(const Operator   &inverse,
          const Epetra_Map &map,
          double           *result,
          const double     *source)
    {
      const Epetra_Vector in(View, map, const_cast<double *>(source));
      Epetra_Vector       out(View, map, result);
      const int           error = inverse.ApplyInverse(in, out);
      AssertThrow(error == 0, ExcMessage("a preconditioner failed"));
    }
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



  namespace
  {
    // Of each column of a matrix: the number it has in the block on the rank
    // that owns it, -1 if it is left out.
    Epetra_IntVector
    numbers_in_block(const Epetra_CrsMatrix  &matrix,
                     const Epetra_Map        &block_columns,
                     const std::vector<bool> &chosen)
    {
      Epetra_IntVector owned(matrix.DomainMap());
      for (int column = 0, next = 0; column < owned.MyLength(); ++column)
        owned[column] = chosen[column] ? block_columns.GID(next++) : -1;
      Epetra_IntVector numbers(matrix.ColMap());
      if (const Epetra_Import *importer = matrix.Importer())
        numbers.Import(owned, *importer, Insert);
      else
        numbers = owned;
      return numbers;
    }



    // Replaces the numbers in the block by those among the columns that this
    // rank has entries in, in the order of the matrix, and returns their map.
    Epetra_Map
    number_columns(Epetra_IntVector &numbers, const Epetra_Comm &communicator)
    {
      std::vector<int> global;
      for (int column = 0; column < numbers.MyLength(); ++column)
        if (numbers[column] >= 0)
        {
          global.push_back(numbers[column]);
          numbers[column] = global.size() - 1;
        }
      return Epetra_Map(-1, global.size(), global.data(), 0, communicator);
    }



    Epetra_Map
    map_of(const std::vector<bool> &chosen, const Epetra_Comm &communicator)
    {
      const int n_owned = std::count(chosen.begin(), chosen.end(), true);
      return Epetra_Map(-1, n_owned, 0, communicator);
    }
  } // namespace



  // A_RC of the rows R and columns C, renumbered: what ML wants is a matrix of
  // its own with the nodes of one rank behind those of the rank before. Columns
  // of other ranks are found by sending their numbers in the block along the
  // import of A.
  std::unique_ptr<Epetra_CrsMatrix>
  extract_block(const Epetra_CrsMatrix  &matrix,
                const std::vector<bool> &rows,
                const std::vector<bool> &columns)
  {
    const Epetra_Map block_rows    = map_of(rows, matrix.Comm());
    const Epetra_Map block_columns = map_of(columns, matrix.Comm());
    Epetra_IntVector numbers = numbers_in_block(matrix, block_columns, columns);
    const Epetra_Map present = number_columns(numbers, matrix.Comm());

    int    *starts, *indices;
    double *values;
    AssertThrow(matrix.ExtractCrsDataPointers(starts, indices, values) == 0,
                ExcMessage("the matrix is not compressed"));
    std::vector<int> lengths;
    for (int row = 0; row < matrix.NumMyRows(); ++row)
      if (rows[row])
        lengths.push_back(std::count_if(
          indices + starts[row],
          indices + starts[row + 1],
          [&](const int column) { return numbers[column] >= 0; }));
    auto block = std::make_unique<Epetra_CrsMatrix>(
      Copy, block_rows, present, lengths.data(), true);
    std::vector<int>    found;
    std::vector<double> found_values;
    for (int row = 0, next = 0; row < matrix.NumMyRows(); ++row)
      if (rows[row])
      {
        found.clear();
        found_values.clear();
        for (int k = starts[row]; k < starts[row + 1]; ++k)
          if (numbers[indices[k]] >= 0)
          {
            found.push_back(numbers[indices[k]]);
            found_values.push_back(values[k]);
          }
        block->InsertMyValues(
          next++, found.size(), found_values.data(), found.data());
      }
    block->FillComplete(block_columns, block_rows);
    block->OptimizeStorage();
    return block;
  }



  void
  multiply(const Epetra_CrsMatrix &matrix,
           double                 *result,
           const double           *source,
           const bool              transposed)
  {
    const Epetra_Map &from =
      transposed ? matrix.RangeMap() : matrix.DomainMap();
    const Epetra_Map &to = transposed ? matrix.DomainMap() : matrix.RangeMap();
    const Epetra_Vector in(View, from, const_cast<double *>(source));
    Epetra_Vector       out(View, to, result);
    const int           error = matrix.Multiply(transposed, in, out);
    AssertThrow(error == 0, ExcMessage("a product with a matrix failed"));
  }



  // Lends the finest level of a hierarchy faster products, after its matrix
  // has been read, until this ends.
  class Multigrid::FinestProducts
  {
  public:
    FinestProducts(const ML_Epetra::MultiLevelPreconditioner &hierarchy,
                   const Epetra_CrsMatrix                    &matrix,
                   const unsigned int                         n_components)
      : finest(hierarchy.GetML()->Amat[hierarchy.GetML()->ML_finest_level])
      , of_ml(finest.data)
      , product_of_ml(finest.matvec->func_ptr)
      , blocks(matrix, n_components)
    {
      finest.data             = &blocks;
      finest.matvec->func_ptr = multiply;
    }

    ~FinestProducts()
    {
      finest.data             = of_ml;
      finest.matvec->func_ptr = product_of_ml;
    }

  private:
    static int
    multiply(ML_Operator *level, int, double *source, int, double *result)
    {
      static_cast<const NodeBlocks *>(level->data)->vmult(result, source);
      return 0;
    }

    ML_Operator                      &finest;
    void                             *of_ml;
    decltype(finest.matvec->func_ptr) product_of_ml;
    NodeBlocks                        blocks;
  };



  Multigrid::Multigrid(std::shared_ptr<const Epetra_CrsMatrix> new_matrix,
                       const MultigridOptions                 &options,
                       const std::vector<std::vector<double>> &modes)
    : matrix(std::move(new_matrix))
  {
    std::vector<double> all_modes;
    for (const std::vector<double> &mode : modes)
      all_modes.insert(all_modes.end(), mode.begin(), mode.end());
    Teuchos::ParameterList list = multigrid_parameters(options);
    list.set("null space: type", "pre-computed");
    list.set("null space: dimension", static_cast<int>(modes.size()));
    list.set("null space: vectors", all_modes.data());
    list.set("null space: add default vectors", false);
    cycle = std::make_unique<ML_Epetra::MultiLevelPreconditioner>(
      *matrix, list, true);
    AssertThrow(cycle->IsPreconditionerComputed(),
                ExcMessage("the multigrid hierarchy could not be built"));
    if (options.n_components > 1)
      finest_products =
        std::make_unique<FinestProducts>(*cycle, *matrix, options.n_components);
  }



  Multigrid::~Multigrid() = default;



  void
  Multigrid::vmult(double *result, const double *source) const
  {
    apply(*cycle, matrix->RowMap(), result, source);
  }



  double
  Multigrid::operator_complexity() const
  {
    double complexity, entries;
    const_cast<ML_Epetra::MultiLevelPreconditioner &>(*cycle).Complexities(
      complexity, entries);
    return complexity;
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
    factors->SetParameters(list);
    const int error = factors->Initialize() + factors->Compute();
    AssertThrow(error == 0, ExcMessage("incomplete factorisation failed"));
  }



  MassSolver::~MassSolver() = default;



  void
  MassSolver::vmult(double *result, const double *source) const
  {
    apply(*factors, matrix->RowMap(), result, source);
  }
} // namespace MixedCracks
