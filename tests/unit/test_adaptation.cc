// SPDX-License-Identifier: GPL-2.0-or-later
// Refinement where the phase field asks for it, and what becomes of the fields.
#include <deal.II/base/function_lib.h>
#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
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

    // as a run does it, one level
    bool
    flag(const Vector &values)
    {
      const auto places = places_to_refine(fields, values, rule);
      return !places.empty() && flag_cells_near(places, rule, triangulation);
    }

    // and to the end
    void
    refine_around(const Vector &values)
    {
      const auto places = places_to_refine(fields, values, rule);
      while (flag_cells_near(places, rule, triangulation))
        refine_and_transfer(triangulation, fields, constraints, {}, {});
    }

    // the same where cells become coarse, too, as a run does it
    void
    refine_and_coarsen(const RefinedAtStart<dim> &was_refined,
                       Vector                    &elastic,
                       Vector                    &values)
    {
      const auto places = places_to_refine(fields, values, rule);
      ASSERT_FALSE(places.empty());
      while (flag_cells_near(places, rule, triangulation))
      {
        flag_cells_to_coarsen(places, rule, was_refined, fields, values);
        refine_and_transfer(
          triangulation, fields, constraints, {&elastic}, {&values});
      }
    }

    unsigned int
    level_at(const Point<dim> &point) const
    {
      int level = -1;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->point_inside(point))
          level = std::max(level, cell->level());
      return dealii::Utilities::MPI::max(level, MPI_COMM_WORLD);
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
  EXPECT_FALSE(flag(phase_field([](const Point<dim> &) { return 1.; })));
  EXPECT_EQ(n_flagged(), 0u);
}



TEST_F(AdaptiveSquare, FlagsTheCellsAroundTheCrack)
{
  // damaged are the nodes on y = 0.5 and, at a distance of 1/8, those with
  // phi = 0.5: cells that touch them
  EXPECT_TRUE(flag(phase_field(cracked)));
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
  flag(phase_field(cracked));
  const unsigned int without = n_flagged();
  for (const auto &cell : triangulation.active_cell_iterators())
    cell->clear_refine_flag();
  rule.margin = 0.25;
  flag(phase_field(cracked));
  EXPECT_GT(n_flagged(), without + 8);
}



TEST_F(AdaptiveSquare, LooksAheadOfTheTip)
{
  rule.finest_level = 2;
  rule.margin       = 0.1;
  rule.lookahead    = 0.15;
  refine_around(phase_field(cracked));
  // straight ahead of the tip at (0.5, 0.5), as fine as at the crack
  for (const double x : {0.26, 0.49, 0.6, 0.7, 0.76})
  {
    EXPECT_EQ(level_at({x, 0.49}), 2u) << x;
    EXPECT_EQ(level_at({x, 0.51}), 2u) << x;
  }
  // beside that line and beyond its end they are coarse, but for balance
  EXPECT_EQ(level_at({0.7, 0.9}), 0u);
  EXPECT_EQ(level_at({0.7, 0.1}), 0u);
  EXPECT_LE(level_at({0.97, 0.51}), 1u);
}



TEST_F(AdaptiveSquare, DoesNotLookAheadOfABandThatWidens)
{
  rule.margin    = 0.25;
  rule.lookahead = 0.3;
  // through the whole body: there is no tip
  const auto cut = [](const Point<dim> &p) {
    return std::min(1., 5. * std::abs(p[1] - 0.5));
  };
  const Vector values = phase_field(cut);
  const auto   places = places_to_refine(fields, values, rule);
  for (const Point<dim> &place : places.growing)
    // what lies outside the body refines nothing
    if (place[0] >= 0. && place[0] <= 1.)
    {
      EXPECT_LT(std::abs(place[1] - 0.5), 0.2) << place;
    }
}



// A crack grows out of a wide fine band: behind it the band becomes narrow.
class CoarseningSquare : public AdaptiveSquare
{
protected:
  CoarseningSquare()
  {
    rule.finest_level = 2;
    rule.margin       = 0.2;
    refine_around(phase_field(crack_to(0.3)));
    rule.margin      = 0.05;
    rule.kept_margin = 0.;
    phi              = phase_field(crack_to(0.7));
    elastic = interpolated(fields.elastic, fields.elastic_dofs, quadratic);
  }

  // from the left edge to (tip, 0.5), 1 from a distance of 0.125 on
  static std::function<double(const Point<dim> &)>
  crack_to(const double tip)
  {
    return [tip](const Point<dim> &p) {
      return std::min(1., 8. * p.distance({std::min(p[0], tip), 0.5}));
    };
  }

  // where it was fine, and is not damaged
  const Point<dim> beside = {0.1, 0.72};
  Vector           phi, elastic;
};



TEST_F(CoarseningSquare, MakesIntactCellsCoarseAgain)
{
  ASSERT_EQ(level_at(beside), 2u);
  ASSERT_LT(level_at({0.69, 0.51}), 2u);
  refine_and_coarsen([](const auto &) { return false; }, elastic, phi);
  EXPECT_LT(level_at(beside), 2u);
  // at the crack, old and new, they are fine
  for (const double x : {0.01, 0.26, 0.4, 0.69})
    EXPECT_EQ(level_at({x, 0.51}), 2u) << x;
}



TEST_F(CoarseningSquare, LeavesCellsThatWereRefinedAtTheStart)
{
  refine_and_coarsen(
    [](const auto &cell) { return cell->center()[0] < 0.25; }, elastic, phi);
  EXPECT_EQ(level_at(beside), 2u);
  EXPECT_EQ(level_at({0.1, 0.28}), 2u);
  EXPECT_LT(level_at({0.4, 0.72}), 2u);
}



TEST_F(CoarseningSquare, LeavesDamagedCells)
{
  // a little damage everywhere, as of a density without an elastic stage
  phi *= 0.999;
  refine_and_coarsen([](const auto &) { return false; }, elastic, phi);
  EXPECT_EQ(level_at(beside), 2u);
}



TEST_F(CoarseningSquare, CarriesTheFieldsOverExactly)
{
  refine_and_coarsen([](const auto &) { return false; }, elastic, phi);
  const Vector expected =
    interpolated(fields.elastic, fields.elastic_dofs, quadratic);
  for (const auto dof : fields.elastic_dofs.relevant)
    EXPECT_NEAR(elastic(dof), expected(dof), 1e-13);
  // nodes that were there before
  const auto whole = [](const double x, const unsigned int n) {
    return std::abs(n * x - std::round(n * x)) < 1e-9;
  };
  unsigned int n_compared = 0;
  for (const auto &cell : fields.phase_field.active_cell_iterators())
    if (cell->is_locally_owned())
      for (const unsigned int v : cell->vertex_indices())
      {
        const Point<dim> p         = cell->vertex(v);
        const bool       at_damage = p[0] < 0.25 && std::abs(p[1] - 0.5) < 0.13;
        const unsigned int n       = at_damage ? 32 : 8;
        if (!whole(p[0], n) || !whole(p[1], n))
          continue;
        ++n_compared;
        EXPECT_NEAR(phi(cell->vertex_dof_index(v, 0)), crack_to(0.7)(p), 1e-14)
          << p;
      }
  EXPECT_GT(dealii::Utilities::MPI::sum(n_compared, MPI_COMM_WORLD), 200u);
}



TEST_F(AdaptiveSquare, EndsWhenDamagedCellsAreFineEnough)
{
  rule.finest_level   = 3;
  unsigned int rounds = 0;
  while (flag(phase_field(cracked)))
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



// or a load step would ask for finer cells without end
TEST_F(AdaptiveSquare, LeavesNoDamagedCellCoarseHoweverDistorted)
{
  dealii::GridTools::distort_random(0.35, triangulation, true, 1);
  fields.distribute();
  constraints.reinit();
  const Vector values = phase_field(cracked);
  for (const auto &place : places_to_refine(fields, values, rule).growing)
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (cell->is_locally_owned() && cell->vertex(v) == place)
        {
          for (const auto &other : triangulation.active_cell_iterators())
            if (other->is_locally_owned())
              other->clear_refine_flag();
          flag_cells_near<dim>({{place}, {}}, rule, triangulation);
          EXPECT_TRUE(cell->refine_flag_set()) << cell->center();
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
  while (flag(phi))
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
