// SPDX-License-Identifier: GPL-2.0-or-later
// Refinement where the phase field asks for it, and what becomes of the fields.
#include <deal.II/base/function_lib.h>
#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <discretization/adaptation.h>

#include <gtest/gtest.h>

using namespace MixedCracks;

namespace
{
  constexpr int dim = 2;
  using dealii::Point;
  using Vector = LinearAlgebra::Vector;

  // The unit square, 8 x 8 cells, level 0; all of it on each number of ranks
  class AdaptiveSquare : public ::testing::Test
  {
  protected:
    AdaptiveSquare()
      : triangulation(MPI_COMM_WORLD)
      , fields(triangulation, {true, 2})
      , constraints(fields, {})
    {
      dealii::GridGenerator::subdivided_hyper_cube(triangulation, 8);
      fields.distribute();
      constraints.reinit();
      rule.threshold    = 0.7;
      rule.finest_level = 1;
      rule.margin       = 0.;
    }

    // a crack from the left edge to (0.5, 0.5)
    static double
    cracked(const Point<dim> &p)
    {
      const double beside = p.distance({std::min(p[0], 0.5), 0.5});
      return std::min(1., 4. * beside);
    }

    template <typename Function>
    Vector
    interpolated(const dealii::DoFHandler<dim> &handler,
                 const DofSets                 &dofs,
                 const Function                &function) const
    {
      Vector owned = fields.owned_vector(dofs);
      dealii::VectorTools::interpolate(
        fields.mapping, handler, function, owned);
      Vector result = fields.ghosted_vector(dofs);
      result        = owned;
      return result;
    }

    Vector
    phase_field(const std::function<double(const Point<dim> &)> &value) const
    {
      return interpolated(fields.phase_field,
                          fields.phase_field_dofs,
                          dealii::ScalarFunctionFromFunctionObject<dim>(value));
    }

    unsigned int
    n_flagged() const
    {
      unsigned int n = 0;
      for (const auto &cell : triangulation.active_cell_iterators())
        n += cell->is_locally_owned() && cell->refine_flag_set();
      return dealii::Utilities::MPI::sum(n, MPI_COMM_WORLD);
    }

    dealii::parallel::distributed::Triangulation<dim> triangulation;
    Fields<dim>                                       fields;
    Constraints<dim>                                  constraints;
    AdaptationRule                                    rule;
  };

  // polynomials that the elements hold exactly
  const dealii::FunctionFromFunctionObjects<dim>
    quadratic({[](const Point<dim> &p) { return p[0] * p[0] - p[0] * p[1]; },
               [](const Point<dim> &p) { return 3. * p[1] * p[1] + p[0]; },
               [](const Point<dim> &p) { return 2. - p[0] + p[0] * p[1]; }});
} // namespace



TEST_F(AdaptiveSquare, LeavesAnIntactBodyAlone)
{
  EXPECT_FALSE(
    flag_damaged_cells(fields,
                       phase_field([](const Point<dim> &) { return 1.; }),
                       rule,
                       triangulation));
  EXPECT_EQ(n_flagged(), 0u);
}



TEST_F(AdaptiveSquare, FlagsTheCellsAroundTheCrack)
{
  // damaged are the nodes on y = 0.5 and, at a distance of 1/8, those with
  // phi = 0.5: cells that touch them
  EXPECT_TRUE(
    flag_damaged_cells(fields, phase_field(cracked), rule, triangulation));
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const Point<dim> center = cell->center();
      const bool       near =
        std::abs(center[1] - 0.5) < 0.2 && center[0] < 0.5 + 0.2;
      const bool at_crack = std::abs(center[1] - 0.5) < 0.1 && center[0] < 0.5;
      EXPECT_FALSE(!near && cell->refine_flag_set()) << center;
      EXPECT_FALSE(at_crack && !cell->refine_flag_set()) << center;
    }
}



TEST_F(AdaptiveSquare, TakesTheMarginAhead)
{
  flag_damaged_cells(fields, phase_field(cracked), rule, triangulation);
  const unsigned int without = n_flagged();
  for (const auto &cell : triangulation.active_cell_iterators())
    cell->clear_refine_flag();
  rule.margin = 0.25;
  flag_damaged_cells(fields, phase_field(cracked), rule, triangulation);
  EXPECT_GT(n_flagged(), without + 8);
}



TEST_F(AdaptiveSquare, EndsWhenDamagedCellsAreFineEnough)
{
  rule.finest_level   = 3;
  unsigned int rounds = 0;
  while (flag_damaged_cells(fields, phase_field(cracked), rule, triangulation))
  {
    refine_and_transfer(triangulation, fields, constraints, {}, {});
    ASSERT_LE(++rounds, 3u);
  }
  EXPECT_EQ(rounds, 3u);
  const Vector phi = phase_field(cracked);
  for (const auto &cell : fields.phase_field.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      EXPECT_LE(cell->level(), 3);
      for (const unsigned int v : cell->vertex_indices())
        EXPECT_FALSE(phi(cell->vertex_dof_index(v, 0)) < rule.threshold &&
                     cell->level() < 3);
    }
}



TEST_F(AdaptiveSquare, CarriesTheFieldsOverExactly)
{
  rule.finest_level = 2;
  Vector elastic = interpolated(fields.elastic, fields.elastic_dofs, quadratic);
  Vector phi     = phase_field(cracked);
  const auto linear = [](const Point<dim> &p) {
    return 0.3 * p[0] + 0.5 * p[1];
  };
  Vector other = phase_field(linear);
  while (flag_damaged_cells(fields, phi, rule, triangulation))
    refine_and_transfer(
      triangulation, fields, constraints, {&elastic}, {&phi, &other});
  EXPECT_GT(triangulation.n_global_active_cells(), 64u);

  Vector expected =
    interpolated(fields.elastic, fields.elastic_dofs, quadratic);
  for (const auto dof : fields.elastic_dofs.relevant)
    EXPECT_NEAR(elastic(dof), expected(dof), 1e-13);
  expected = phase_field(linear);
  for (const auto dof : fields.phase_field_dofs.relevant)
  {
    EXPECT_NEAR(other(dof), expected(dof), 1e-14);
    EXPECT_GE(phi(dof), 0.);
    EXPECT_LE(phi(dof), 1.);
  }
}
