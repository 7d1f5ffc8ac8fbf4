// SPDX-License-Identifier: GPL-2.0-or-later
// Loads along the normal, on a mesh with hanging nodes: the work of a constant
// pressure is that of the volume, whose derivative is taken by differences; the
// tangent against differences of the forces; symmetry where there is a
// potential.
#include "imposed_opening.h"

#include <assembly/normal_loads.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/base/quadrature_lib.h>

#include <discretization/sparse_matrix.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  using Vector = LinearAlgebra::Vector;

  template <int dim>
  class Pressed : public OpenedBody<dim>
  {
  public:
    Pressed()
      : OpenedBody<dim>(/*mixed=*/true)
    {
      this->set_displacement([](const dealii::Point<dim> &x) {
        dealii::Tensor<1, dim> u;
        u[0] = 0.3 * x[1] + 0.1 * x[0] * x[0];
        u[1] = -0.2 * x[0] + 0.15 * x[0] * x[1];
        u[dim - 1] += 0.1 * x[dim - 1] * x[0];
        return u;
      });
    }

    // numbers that depend on the position only, not on the ranks
    Vector
    direction(const double phase)
    {
      const Vector kept = this->elastic;
      this->set_displacement([phase](const dealii::Point<dim> &x) {
        dealii::Tensor<1, dim> u;
        for (unsigned int d = 0; d < dim; ++d)
          u[d] =
            std::sin(5. * x[0] + (3. + d) * x[1] + 2. * d * x[dim - 1] + phase);
        return u;
      });
      Vector result = this->fields.owned_vector(this->fields.elastic_dofs);
      result        = this->elastic;
      this->elastic = kept;
      return result;
    }

    Vector
    ghosted(const Vector &owned) const
    {
      Vector result = this->fields.ghosted_vector(this->fields.elastic_dofs);
      result        = owned;
      return result;
    }

    // the state moved by @p factor along @p direction
    Vector
    moved(const double factor, const Vector &direction) const
    {
      Vector owned = this->fields.owned_vector(this->fields.elastic_dofs);
      owned        = this->elastic;
      owned.add(factor, direction);
      return ghosted(owned);
    }

    // integral of det F
    double
    volume(const Vector &state) const
    {
      dealii::FEValues<dim>               values(this->fields.mapping,
                                   this->fields.elastic.get_fe(),
                                   dealii::QGauss<dim>(5),
                                   dealii::update_gradients |
                                     dealii::update_JxW_values);
      std::vector<dealii::Tensor<2, dim>> gradients(values.n_quadrature_points);
      double                              sum = 0.;
      for (const auto &cell : this->fields.elastic.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          values.reinit(cell);
          values[this->fields.displacement].get_function_gradients(state,
                                                                   gradients);
          for (unsigned int q = 0; q < gradients.size(); ++q)
          {
            for (unsigned int d = 0; d < dim; ++d)
              gradients[q][d][d] += 1.;
            sum += determinant(gradients[q]) * values.JxW(q);
          }
        }
      return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    }

    Vector
    forces(FollowerPressure<dim> &pressure, const Vector &state) const
    {
      Vector result = this->fields.owned_vector(this->fields.elastic_dofs);
      pressure.add_forces(
        state, this->constraints.elastic_hanging_nodes(), result);
      return result;
    }

    FollowerPressure<dim>
    pressure(const std::function<double(const dealii::Point<dim> &)> &p) const
    {
      return {
        this->fields,
        {{0,
          std::make_shared<dealii::ScalarFunctionFromFunctionObject<dim>>(p)}}};
    }
  };

  template <typename Dimension>
  class NormalLoadsOf : public ::testing::Test
  {};
  TYPED_TEST_SUITE(NormalLoadsOf, Dimensions, );
} // namespace



TYPED_TEST(NormalLoadsOf, AConstantPressureDoesTheWorkOfTheVolume)
{
  constexpr int dim = TypeParam::value;
  Pressed<dim>  body;
  auto pressure = body.pressure([](const dealii::Point<dim> &) { return 3.; });
  const Vector direction = body.direction(0.4);
  const double step      = 1e-4;
  const double growth    = (body.volume(body.moved(step, direction)) -
                         body.volume(body.moved(-step, direction))) /
                        (2. * step);
  EXPECT_GT(std::abs(growth), 1e-2);
  EXPECT_NEAR(body.forces(pressure, body.elastic) * direction,
              -3. * growth,
              1e-6 * std::abs(growth));
}



TYPED_TEST(NormalLoadsOf, TheTangentIsTheDerivativeOfTheForces)
{
  constexpr int dim = TypeParam::value;
  Pressed<dim>  body;
  auto          pressure = body.pressure(
    [](const dealii::Point<dim> &x) { return 2. + x[0] - x[dim - 1]; });
  const auto  &hanging   = body.constraints.elastic_hanging_nodes();
  const Vector direction = body.direction(1.3);
  const double step      = 1e-4;
  Vector       expected  = body.forces(pressure, body.moved(-step, direction));
  expected -= body.forces(pressure, body.moved(step, direction));
  expected *= 0.5 / step;

  body.forces(pressure, body.elastic);
  Vector product = body.fields.owned_vector(body.fields.elastic_dofs);
  pressure.add_tangent_times(body.ghosted(direction), hanging, product);
  const double size = expected.l2_norm();
  EXPECT_GT(size, 0.1);
  Vector difference = product;
  difference -= expected;
  EXPECT_LT(difference.l2_norm(), 1e-7 * size);

  LinearAlgebra::SparseMatrix matrix;
  make_sparse_matrix(
    body.fields.elastic, body.fields.elastic_dofs, hanging, matrix);
  pressure.add_tangent(hanging, matrix);
  // of hanging nodes the matrix has a diagonal of its own
  Vector free = direction;
  for (const auto dof : body.fields.elastic_dofs.owned)
    if (hanging.is_constrained(dof))
      free(dof) = 0.;
  free.compress(dealii::VectorOperation::insert);
  matrix.vmult(difference, free);
  difference -= product;
  EXPECT_LT(difference.l2_norm(), 1e-10 * size);
}



TYPED_TEST(NormalLoadsOf, ThereIsAPotentialWhereThePressureIsConstant)
{
  constexpr int dim = TypeParam::value;
  Pressed<dim>  body;
  const auto   &hanging = body.constraints.elastic_hanging_nodes();
  const Vector  a = body.direction(0.2), b = body.direction(2.);
  const auto    asymmetry = [&](FollowerPressure<dim> pressure) {
    body.forces(pressure, body.elastic);
    Vector of_a = body.fields.owned_vector(body.fields.elastic_dofs);
    Vector of_b = of_a;
    pressure.add_tangent_times(body.ghosted(a), hanging, of_a);
    pressure.add_tangent_times(body.ghosted(b), hanging, of_b);
    return std::abs(b * of_a - a * of_b) / std::abs(b * of_a);
  };
  EXPECT_LT(asymmetry(body.pressure([](const auto &) { return 2.; })), 1e-10);
  EXPECT_GT(asymmetry(body.pressure([](const auto &x) { return 2. + x[0]; })),
            1e-3);
}



TYPED_TEST(NormalLoadsOf, DeadLoadsAreThoseOfTheUndeformedBody)
{
  constexpr int dim = TypeParam::value;
  Pressed<dim>  body;
  const auto    p = [](const dealii::Point<dim> &x) { return 1. + x[1]; };
  auto          pressure = body.pressure(p);
  Vector        at_rest  = body.fields.owned_vector(body.fields.elastic_dofs);
  const Vector  expected = body.forces(pressure, body.ghosted(at_rest));
  Vector        found    = at_rest;
  const auto    function =
    std::make_shared<dealii::ScalarFunctionFromFunctionObject<dim>>(p);
  add_normal_forces<dim>(body.fields,
                         {{0, function}},
                         -1.,
                         body.constraints.elastic_hanging_nodes(),
                         found);
  EXPECT_GT(found.l2_norm(), 0.1);
  found -= expected;
  EXPECT_LT(found.l2_norm(), 1e-12);
}



// Half way between two times the pressure is the mean.
TEST(NormalLoads, LevelsAreLinearInThePressure)
{
  Pressed<2> body;
  class InTime : public dealii::Function<2>
  {
  public:
    double
    value(const dealii::Point<2> &, const unsigned int) const override
    {
      return this->get_time() * this->get_time();
    }
  };
  FollowerPressure<2> pressure(body.fields, {{0, std::make_shared<InTime>()}});
  const auto          size = [&]() {
    return body.forces(pressure, body.elastic).l2_norm();
  };
  pressure.set_level(1., 3., 1.);
  const double whole = size();
  pressure.set_level(1., 3., 0.);
  EXPECT_NEAR(size(), whole / 9., 1e-12);
  pressure.advance_level(0.5);
  EXPECT_NEAR(size(), whole * 5. / 9., 1e-12);
  pressure.advance_level(0.5);
  EXPECT_NEAR(size(), whole * 7. / 9., 1e-12);
}
