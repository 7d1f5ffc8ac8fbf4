// SPDX-License-Identifier: GPL-2.0-or-later
// The loops over the cells on a mesh with hanging nodes, shared by the ranks:
// residuals summed here against the matrix summed by deal.II, and a corrected
// matrix against a new one.
#include "refined_square.h"

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr int dim = 2;
  using dealii::Point;
  using Vector = LinearAlgebra::Vector;

  class RefinedSquare
    : public ::testing::Test
    , protected RefinedCells
  {
  protected:
    RefinedSquare()
      : RefinedCells(true,
                     description("volumetric-deviatoric", "relaxed bulk", 2))
    {
      make_matrix(matrix);
      residual = fields.owned_vector(fields.elastic_dofs);
    }

    void
    make_matrix(LinearAlgebra::SparseMatrix &result) const
    {
      make_sparse_matrix(fields.elastic,
                         fields.elastic_dofs,
                         constraints.elastic_hanging_nodes(),
                         result);
    }

    // smooth displacements, with tension on one side and compression on the
    // other
    Vector
    elastic_state() const
    {
      return with_ghosts(
        field([](const Point<dim> &x) { return std::sin(3. * x[0] + x[1]); },
              [](const Point<dim> &x) { return x[0] * x[1] * x[1]; },
              [](const Point<dim> &x) { return 5. * (x[0] - 0.4); }),
        fields.elastic_dofs);
    }

    // by copying: a temporary would be moved, ghosts and all
    Vector
    without_ghosts(const Vector &ghosted, const DofSets &dofs) const
    {
      Vector result = fields.owned_vector(dofs);
      result        = ghosted;
      return result;
    }

    void
    assemble(Assembler<dim>              &which,
             const Vector                &phi,
             LinearAlgebra::SparseMatrix &result)
    {
      which.elastic_residual(
        elastic_state(), phi, constraints.elastic_hanging_nodes(), residual);
      which.elastic_matrix(constraints.elastic_hanging_nodes(), result);
    }

    LinearAlgebra::SparseMatrix matrix;
    Vector                      residual;
  };

  // largest difference of their images of @p source
  double
  difference(const LinearAlgebra::SparseMatrix &a,
             const LinearAlgebra::SparseMatrix &b,
             const Vector                      &source)
  {
    Vector of_a(source), of_b(source);
    a.vmult(of_a, source);
    b.vmult(of_b, source);
    of_a.add(-1., of_b);
    return of_a.linfty_norm() / of_b.linfty_norm();
  }
} // namespace



TEST_F(RefinedSquare, HasHangingNodes)
{
  EXPECT_GT(
    dealii::Utilities::MPI::sum(
      constraints.elastic_hanging_nodes().n_constraints(), MPI_COMM_WORLD),
    0u);
}



TEST_F(RefinedSquare, IntactResidualIsTheMatrixTimesTheState)
{
  Vector intact = fields.ghosted_vector(fields.phase_field_dofs);
  Vector ones   = fields.owned_vector(fields.phase_field_dofs);
  ones          = 1.;
  intact        = ones;
  assemble(*assembler, intact, matrix);
  Vector state = without_ghosts(elastic_state(), fields.elastic_dofs);
  // rows of hanging nodes hold a diagonal of their own
  constraints.elastic_hanging_nodes().set_zero(state);
  Vector expected = fields.owned_vector(fields.elastic_dofs);
  matrix.vmult(expected, state);
  expected.add(-1., residual);
  EXPECT_GT(residual.linfty_norm(), 1e-3);
  EXPECT_LT(expected.linfty_norm(), 1e-12 * residual.linfty_norm());
}



TEST_F(RefinedSquare, CorrectedMatrixIsTheNewOne)
{
  assemble(*assembler, phase_field(0.2), matrix);
  for (const double x : {0.25, 0.4, 0.9})
  {
    assemble(*assembler, phase_field(x), matrix);
    Assembler<dim> fresh(fields, material);
    fresh.reinit();
    LinearAlgebra::SparseMatrix expected;
    make_matrix(expected);
    assemble(fresh, phase_field(x), expected);
    Vector source = without_ghosts(elastic_state(), fields.elastic_dofs);
    constraints.elastic_hanging_nodes().set_zero(source);
    EXPECT_LT(difference(matrix, expected, source), 1e-12) << "x = " << x;
  }
}



TEST_F(RefinedSquare, PhaseFieldResidualFollowsItsMatrix)
{
  // quadratic in the phase field: the matrix is the difference of residuals
  const auto                 &hanging = constraints.phase_field_hanging_nodes();
  const DofSets              &dofs    = fields.phase_field_dofs;
  LinearAlgebra::SparseMatrix phase_field_matrix;
  make_sparse_matrix(fields.phase_field, dofs, hanging, phase_field_matrix);

  assemble(*assembler, phase_field(0.3), matrix);
  const DrivingForce driving_force = assembler->driving_force();
  Vector first = fields.owned_vector(dofs), second = first, expected = first;
  assembler->phase_field_system(
    phase_field(0.3), driving_force, hanging, first, &phase_field_matrix);
  assembler->phase_field_system(
    phase_field(0.6), driving_force, hanging, second, nullptr);
  Vector end = without_ghosts(phase_field(0.6), dofs);
  end.add(-1., without_ghosts(phase_field(0.3), dofs));
  hanging.set_zero(end);
  phase_field_matrix.vmult(expected, end);
  second.add(-1., first);
  expected.add(-1., second);
  EXPECT_GT(second.linfty_norm(), 1e-3);
  EXPECT_LT(expected.linfty_norm(), 1e-12 * second.linfty_norm());
}
