// SPDX-License-Identifier: GPL-2.0-or-later
// The load of a fluid summed over a mesh with hanging nodes: against the form
// of [Mikelic, Wheeler, Wick 2015] with the derivative of the pressure, and the
// force on the faces of a crack across the body.
#include "imposed_opening.h"

#include <assembly/fluid_assembler.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  template <int dim>
  using Scalar = dealii::ScalarFunctionFromFunctionObject<dim>;

  // integral of phi^2 (p div u + grad p . u) for p = 2 + x - 3 y
  template <int dim>
  double
  energy_with_derivative(const OpenedBody<dim> &body)
  {
    const auto               &fields = body.fields;
    const dealii::QGauss<dim> quadrature(5);
    dealii::FEValues<dim>     elastic(
      fields.mapping,
      fields.elastic.get_fe(),
      quadrature,
      dealii::update_values | dealii::update_gradients |
        dealii::update_JxW_values | dealii::update_quadrature_points);
    dealii::FEValues<dim>               phase(fields.mapping,
                                fields.phase_field.get_fe(),
                                quadrature,
                                dealii::update_values);
    const unsigned int                  n = quadrature.size();
    std::vector<double>                 divergences(n), phi(n);
    std::vector<dealii::Tensor<1, dim>> u(n);
    double                              sum = 0.;
    for (const auto &cell : fields.elastic.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        elastic.reinit(cell);
        phase.reinit(typename dealii::DoFHandler<dim>::active_cell_iterator(
          &cell->get_triangulation(),
          cell->level(),
          cell->index(),
          &fields.phase_field));
        elastic[fields.displacement].get_function_values(body.elastic, u);
        elastic[fields.displacement].get_function_divergences(body.elastic,
                                                              divergences);
        phase.get_function_values(body.phase_field, phi);
        for (unsigned int q = 0; q < n; ++q)
        {
          const auto  &x = elastic.quadrature_point(q);
          const double p = 2. + x[0] - 3. * x[1];
          sum += phi[q] * phi[q] *
                 (p * divergences[q] + u[q][0] - 3. * u[q][1]) * elastic.JxW(q);
        }
      }
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }
} // namespace

template <typename Dimension>
class FluidAssemblerOf : public ::testing::Test
{};
TYPED_TEST_SUITE(FluidAssemblerOf, Dimensions, );



TYPED_TEST(FluidAssemblerOf, EnergyIsThatOfTheFormWithTheDerivative)
{
  // where u vanishes on the boundary; the quadrature of Q2-Q1 is exact
  constexpr int   dim = TypeParam::value;
  OpenedBody<dim> body(/*mixed=*/true);
  body.set_displacement([](const dealii::Point<dim> &x) {
    double bubble = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      bubble *= 1. - x[d] * x[d];
    dealii::Tensor<1, dim> u;
    u[0] = bubble * x[1];
    u[1] = bubble * (0.3 + x[0]);
    return u;
  });
  body.set_phase_field([](const dealii::Point<dim> &x) {
    return std::min(1., 0.1 + 0.8 * std::abs(x[1] - 0.2 * x[0]));
  });
  FluidAssembler<dim> fluid(
    body.fields, std::make_shared<Scalar<dim>>([](const dealii::Point<dim> &x) {
      return 2. + x[0] - 3. * x[1];
    }));
  fluid.reinit();
  const double found    = fluid.energy(0., body.elastic, body.phase_field);
  const double expected = energy_with_derivative(body);
  EXPECT_GT(std::abs(expected), 0.1);
  EXPECT_NEAR(found, expected, 1e-11);

  // linear in u: the forces times the displacement, less the energy
  LinearAlgebra::Vector forces =
    body.fields.owned_vector(body.fields.elastic_dofs);
  LinearAlgebra::Vector displacement = forces;
  displacement                       = body.elastic;
  fluid.add_nodal_forces(
    0., body.phase_field, body.constraints.elastic_hanging_nodes(), forces);
  EXPECT_NEAR(forces * displacement, -expected, 1e-11);
}



TYPED_TEST(FluidAssemblerOf, DoesWorkWhenTheFacesPart)
{
  // A crack across the body in y = 0, phi = 2 |y|, and u_y = sign(y) at the
  // nodes. The integral of u d(phi^2)/dy across it is 4/3 on coarse cells and
  // 11/6 on fine ones. In the row of fine cells between the two it is their
  // mean, where the hanging nodes follow the coarse cells.
  constexpr int   dim = TypeParam::value;
  OpenedBody<dim> body(/*mixed=*/false);
  body.set_phase_field([](const dealii::Point<dim> &x) {
    return std::min(1., 2. * std::abs(x[1]));
  });
  FluidAssembler<dim> fluid(
    body.fields,
    std::make_shared<dealii::Functions::ConstantFunction<dim>>(3.));
  fluid.reinit();
  const auto work_on = [&](const double below, const double above) {
    body.set_displacement([=](const dealii::Point<dim> &x) {
      dealii::Tensor<1, dim> u;
      u[1] = x[1] > 1e-9 ? above : x[1] < -1e-9 ? below : 0.5 * (above + below);
      return u;
    });
    return -fluid.energy(0., body.elastic, body.phase_field);
  };
  const double coarse = 4. / 3., fine = 11. / 6.;
  const double volume =
    std::pow(2., dim - 2) * (coarse + 0.125 * (coarse + fine) + 0.75 * fine);
  EXPECT_NEAR(work_on(-1., 1.), 3. * volume, 1e-11);
  EXPECT_NEAR(work_on(1., -1.), -3. * volume, 1e-11);
  EXPECT_NEAR(work_on(1., 1.), 0., 1e-11);
}



TYPED_TEST(FluidAssemblerOf, FollowsTheTime)
{
  constexpr int   dim = TypeParam::value;
  OpenedBody<dim> body(/*mixed=*/false);
  body.set_phase_field(
    [](const dealii::Point<dim> &x) { return std::abs(x[1]); });
  body.set_displacement([](const dealii::Point<dim> &x) {
    dealii::Tensor<1, dim> u;
    u[1] = x[1];
    return u;
  });
  class Rising : public dealii::Function<dim>
  {
  public:
    double
    value(const dealii::Point<dim> &, const unsigned int = 0) const override
    {
      return this->get_time();
    }
  };
  FluidAssembler<dim> fluid(body.fields, std::make_shared<Rising>());
  fluid.reinit();
  const auto energy = [&](const double time) {
    return fluid.energy(time, body.elastic, body.phase_field);
  };
  EXPECT_EQ(energy(0.), 0.);
  EXPECT_LT(energy(1.), 0.);
  EXPECT_NEAR(energy(2.), 2. * energy(1.), 1e-12);
}
