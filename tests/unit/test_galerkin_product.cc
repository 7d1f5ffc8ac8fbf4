// SPDX-License-Identifier: GPL-2.0-or-later
// The matrix of the first coarse level beside products with its three factors.
#include "elastic_system.h"

#include <ml_epetra_utils.h>
#include <ml_include.h>
#include <solvers/galerkin_product.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  std::vector<double>
  times(ML_Operator &matrix, std::vector<double> source)
  {
    std::vector<double> result(matrix.outvec_leng);
    ML_Operator_Apply(
      &matrix, source.size(), source.data(), result.size(), result.data());
    return result;
  }

  double
  norm(const std::vector<double> &vector)
  {
    double sum = 0.;
    for (const double value : vector)
      sum += value * value;
    return std::sqrt(dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD));
  }

  // Two levels for the linear displacements of the system, with hanging nodes
  // and a clamped side.
  template <int dim>
  void
  expect_galerkin_product(const unsigned int refinements)
  {
    ElasticSystemOptions options;
    options.refinements     = refinements;
    options.adaptive_levels = 1;
    ElasticSystem<dim> system(options);
    system.make_auxiliaries();
    system.assemble(system.states());
    const LinearSystem      described = system.system();
    const AuxiliaryMatrices auxiliary = described.auxiliary();
    const Epetra_CrsMatrix &matrix = auxiliary.displacement->trilinos_matrix();
    std::vector<double>     modes;
    const auto rigid = described.rigid_body_modes(*auxiliary.is_coarse);
    for (const std::vector<double> &mode : rigid)
      modes.insert(modes.end(), mode.begin(), mode.end());

    ML           *ml;
    ML_Aggregate *aggregates;
    ML_Create2(&ml, 2, MPI_COMM_WORLD);
    EpetraMatrix2MLMatrix(ml, 0, const_cast<Epetra_CrsMatrix *>(&matrix));
    ML_Set_SpectralNormScheme_Calc(ml);
    ML_Aggregate_Create(&aggregates);
    ML_Aggregate_Set_MaxLevels(aggregates, 2);
    ML_Aggregate_Set_CoarsenScheme_Uncoupled(aggregates);
    ML_Aggregate_Set_MaxCoarseSize(aggregates, 1);
    ML_Aggregate_Set_NullSpace(
      aggregates, dim, rigid.size(), modes.data(), matrix.NumMyRows());
    ASSERT_GE(ML_MultiLevel_Gen_Prolongator(ml, 0, 1, aggregates), 0);
    ML_MultiLevel_Gen_Restriction(ml, 0, 1, aggregates);
    set_galerkin_product(*ml, matrix, dim, rigid.size());

    std::vector<double> x(ml->Pmat[1].invec_leng);
    const unsigned int  rank =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = std::sin(1. + 3. * i + 5. * rank);
    const std::vector<double> expected =
      times(ml->Rmat[0], times(ml->Amat[0], times(ml->Pmat[1], x)));
    std::vector<double> error = times(ml->Amat[1], x);
    ASSERT_EQ(error.size(), expected.size());
    for (std::size_t i = 0; i < error.size(); ++i)
      error[i] -= expected[i];
    EXPECT_GT(norm(expected), 1e-3);
    EXPECT_LT(norm(error), 1e-13 * norm(expected));
    ML_Aggregate_Destroy(&aggregates);
    ML_Destroy(&ml);
  }
} // namespace



TEST(GalerkinProduct, IsThatOfItsThreeFactors)
{
  expect_galerkin_product<2>(5);
  expect_galerkin_product<3>(3);
}
