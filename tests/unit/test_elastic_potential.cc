// SPDX-License-Identifier: GPL-2.0-or-later
// What finite strain asks of the loops over the cells, on a mesh with hanging
// nodes that is shared by the ranks: the potential of Newton's line search
// against differences, the tangent times a vector, and the smallest det F.
#include "refined_square.h"

#include <assembly/elastic_potential.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr int dim = 2;
  using dealii::Point;
  using Vector = LinearAlgebra::Vector;

  MaterialDescription
  rubber(const bool plane_stress)
  {
    MaterialDescription result     = description("none", "relaxed bulk", 3);
    result.strains                 = Strains::finite;
    result.plane_stress            = plane_stress;
    result.constants->hyperelastic = {{mu}};
    return result;
  }

  // broken around (0.3, 0.5)
  struct RubberSquare : RefinedCells
  {
    RubberSquare(const bool mixed, const bool plane_stress)
      : RefinedCells(mixed, rubber(plane_stress))
      , potential(fields, constraints, *assembler)
      , phi(phase_field(0.3))
    {}

    Vector
    ghosted(const Vector &owned) const
    {
      return with_ghosts(owned, fields.elastic_dofs);
    }

    Vector
    state() const
    {
      return field(
        [](const Point<dim> &x) {
          return 0.3 * x[0] + 0.1 * std::sin(3. * x[1]);
        },
        [](const Point<dim> &x) { return 0.2 * x[0] * x[1] - 0.1 * x[1]; },
        [](const Point<dim> &x) { return x[0] - 0.4; });
    }

    Vector
    direction() const
    {
      return field(
        [](const Point<dim> &x) { return std::cos(2. * x[0]) * x[1]; },
        [](const Point<dim> &x) { return x[0] * x[0] - x[1]; },
        [](const Point<dim> &x) { return 1. + x[1]; });
    }

    double
    value(const Vector &owned)
    {
      return potential.value(ghosted(owned), phi);
    }

    ElasticPotential<dim> potential;
    Vector                phi;
  };

  Vector
  moved(const Vector &from, const double factor, const Vector &direction)
  {
    Vector result(from);
    result.add(factor, direction);
    return result;
  }
} // namespace



TEST(ElasticPotential, ItsSlopeIsItsDerivative)
{
  for (const bool mixed : {true, false})
    for (const bool plane_stress : {true, false})
    {
      SCOPED_TRACE(std::string(mixed ? "mixed" : "displacement") +
                   (plane_stress ? ", plane stress" : ", plane strain"));
      RubberSquare square(mixed, plane_stress);
      const Vector start = square.state(), along = square.direction();
      const double value = square.value(start);
      const double slope =
        square.potential.slope(square.ghosted(along), square.phi);
      const double step       = 1e-5;
      const double difference = (square.value(moved(start, step, along)) -
                                 square.value(moved(start, -step, along))) /
                                (2. * step);
      EXPECT_GT(value, 0.);
      EXPECT_NEAR(slope, difference, 1e-5 * std::abs(difference));
    }
}



TEST(ElasticPotential, DoesNotDependOnThePressureThatItStartsFrom)
{
  for (const bool plane_stress : {true, false})
  {
    RubberSquare square(true, plane_stress);
    const Vector start = square.state();
    const auto   none  = [](const Point<dim> &) { return 0.; };
    const Vector other =
      square.field(none, none, [](const Point<dim> &x) { return x[1]; });
    const double value = square.value(start);
    EXPECT_NEAR(
      square.value(moved(start, 1., other)), value, 1e-9 * std::abs(value));
  }
}



// More freedom for the pressure: the potential, a maximum over it, is larger.
TEST(ElasticPotential, IsBelowTheOneWithThePressureOfEachPoint)
{
  RubberSquare mixed(true, false), displacement(false, false);
  EXPECT_LT(mixed.value(mixed.state()),
            displacement.value(displacement.state()));
}



TEST(ElasticPotential, TangentTimesAVectorIsTheMatrixTimesIt)
{
  for (const bool mixed : {true, false})
  {
    RubberSquare square(mixed, false);
    const auto  &hanging = square.constraints.elastic_hanging_nodes();
    LinearAlgebra::SparseMatrix matrix;
    make_sparse_matrix(
      square.fields.elastic, square.fields.elastic_dofs, hanging, matrix);
    Vector expected = square.fields.owned_vector(square.fields.elastic_dofs);
    Vector found(expected);
    square.assembler->elastic_residual(
      square.ghosted(square.state()), square.phi, hanging, found);
    square.assembler->elastic_matrix(hanging, matrix);
    Vector along = square.direction();
    square.assembler->tangent_times(square.ghosted(along), hanging, found);
    matrix.vmult(expected, along);
    // rows of hanging nodes have a diagonal entry in the matrix
    hanging.set_zero(expected);
    hanging.set_zero(found);
    found.add(-1., expected);
    EXPECT_LT(found.linfty_norm(), 1e-11 * expected.linfty_norm());
  }
}



TEST(ElasticPotential, FindsTheSmallestDeterminantOfAllRanks)
{
  RubberSquare square(true, false);
  const auto   none     = [](const Point<dim> &) { return 0.; };
  const auto   smallest = [&](const double compression) {
    const Vector even = square.field(
      [=](const Point<dim> &x) { return -compression * x[0]; }, none, none);
    return square.assembler->smallest_determinant(square.ghosted(even),
                                                  square.phi);
  };
  EXPECT_NEAR(smallest(0.75), 0.25, 1e-12);
  EXPECT_NEAR(smallest(1.5), -0.5, 1e-12);
  const Energies energies = square.assembler->energies(
    square.ghosted(square.state()), square.phi, square.phi);
  EXPECT_LT(energies.smallest_jacobian, 1.3);
  EXPECT_GT(energies.smallest_jacobian, 0.5);
}
