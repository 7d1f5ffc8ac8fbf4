// SPDX-License-Identifier: GPL-2.0-or-later
// What finite strain asks of the loops over the cells, on a mesh with hanging
// nodes that is shared by the ranks: the potential of Newton's line search
// against differences, the tangent times a vector, and the smallest det F.
#include "refined_square.h"

#include <assembly/elastic_potential.h>

#include <deal.II/dofs/dof_tools.h>

#include <gtest/gtest.h>

#include <steps/phase_field_bounds.h>

#include <limits>
#include <map>

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
    {
      potential.reinit();
    }

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



// No force is left on the pressures of the equilibrium that comes with it, and
// the displacements are those that were given.
TEST(ElasticPotential, ComesWithThePressureOfItsDisplacements)
{
  for (const bool plane_stress : {true, false})
  {
    RubberSquare square(true, plane_stress);
    const auto  &hanging = square.constraints.elastic_hanging_nodes();
    Vector residual    = square.fields.owned_vector(square.fields.elastic_dofs);
    const Vector start = square.state();
    const auto   pressures = dealii::DoFTools::extract_dofs(
      square.fields.elastic,
      square.fields.elastic.get_fe().component_mask(square.fields.pressure));
    const auto force_on_pressures = [&](const Vector &state) {
      square.assembler->elastic_residual(state, square.phi, hanging, residual);
      double largest = 0.;
      for (const auto i : pressures)
        largest = std::max(largest, std::abs(residual(i)));
      return dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);
    };
    const double before = force_on_pressures(square.ghosted(start));
    square.value(start);
    EXPECT_LT(force_on_pressures(square.potential.equilibrium()),
              1e-7 * before);
    for (const auto i : square.fields.elastic_dofs.owned)
    {
      const bool is_given =
        !pressures.is_element(i) && !hanging.is_constrained(i);
      if (is_given)
      {
        EXPECT_EQ(square.potential.equilibrium()(i), start(i));
      }
    }
  }
}



// Turned by half a turn the intact body has no energy but what rounding leaves
// of the terms that cancel.
TEST(ElasticPotential, OfARotationIsTheRoundingOfItsTerms)
{
  for (const bool mixed : {true, false})
  {
    RubberSquare square(mixed, false);
    square.phi         = square.phase_field(10.);
    const double value = std::abs(
      square.value(square.field([](const Point<dim> &x) { return -2. * x[0]; },
                                [](const Point<dim> &x) { return -2. * x[1]; },
                                [](const Point<dim> &) { return 0.; })));
    EXPECT_GT(square.potential.terms(), 0.);
    EXPECT_LE(
      value, std::numeric_limits<double>::epsilon() * square.potential.terms());
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



// u_x = -2 x^2, F_11 = 1 - 4 x: inside out beyond x = 1/4
TEST(ElasticPotential, MarksTheNodesOfCellsThatAreTurnedInsideOut)
{
  RubberSquare square(false, false);
  const auto   none  = [](const Point<dim> &) { return 0.; };
  const Vector state = square.field(
    [](const Point<dim> &x) { return -2. * x[0] * x[0]; }, none, none);
  const auto  &dofs    = square.fields.phase_field_dofs;
  const auto  &hanging = square.constraints.phase_field_hanging_nodes();
  Vector       marks   = square.fields.owned_vector(dofs);
  const Vector intact  = square.phase_field(10.);
  square.assembler->mark_inside_out(
    square.ghosted(state), intact, hanging, marks);
  Vector lowered = intact, half = marks;
  half = 0.5;
  lower_where(marks, half, lowered);

  std::map<dealii::types::global_dof_index, Point<dim>> places;
  const auto &element = square.fields.phase_field.get_fe();
  std::vector<dealii::types::global_dof_index> indices(
    element.n_dofs_per_cell());
  for (const auto &cell : square.fields.phase_field.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
        places[indices[i]] = square.fields.mapping.transform_unit_to_real_cell(
          cell, element.unit_support_point(i));
    }
  for (const auto i : dofs.owned)
    if (!hanging.is_constrained(i))
    {
      const bool is_inside_out = places.at(i)[0] > 0.25 - 1e-9;
      EXPECT_EQ(marks(i) > 0., is_inside_out) << places.at(i);
      EXPECT_EQ(lowered(i), is_inside_out ? 0.5 : 1.) << places.at(i);
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
