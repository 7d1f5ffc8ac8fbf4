// SPDX-License-Identifier: GPL-2.0-or-later
// The elastic cell kernel: its Jacobian against differences of its residual,
// its residual against differences of its energy, and the patch test.
#include "materials.h"
#include "one_cell.h"
#include "strains.h"

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  // a cell of Q2-Q1 elements has 89 unknowns in 3-d
  template <int dim>
  constexpr unsigned int n_states = dim == 2 ? 4 : 1;

  template <int dim>
  void
  compare_jacobian(OneCell<dim> &cell, const LocalVector &local)
  {
    cell.compare_jacobian(local, cell.steps(1e-8, 1e-6));
  }
} // namespace

template <typename Dimension>
class ElasticKernelOf : public ::testing::Test
{};
TYPED_TEST_SUITE(ElasticKernelOf, Dimensions, );



TYPED_TEST(ElasticKernelOf, MixedJacobianIsTheDerivativeOfTheResidual)
{
  constexpr int dim = TypeParam::value;
  for_all_materials<dim>([](const Material<dim> &material) {
    OneCell<dim> cell(true, material);
    for (const auto &strain : random_strains<dim>(n_states<dim>))
      for (const double pressure : {0.3, -0.2})
        compare_jacobian(cell, cell.values_near(strain, pressure));
  });
}



TYPED_TEST(ElasticKernelOf, DisplacementJacobianIsTheDerivativeOfTheResidual)
{
  constexpr int dim = TypeParam::value;
  for_all_materials<dim>([](const Material<dim> &material) {
    OneCell<dim> cell(false, material);
    for (const auto &strain : random_strains<dim>(n_states<dim>))
      compare_jacobian(cell, cell.values_near(strain, 0.));
  });
}



TYPED_TEST(ElasticKernelOf, DisplacementResidualIsTheDerivativeOfTheEnergy)
{
  // with the pressure eliminated every law derives from an energy
  constexpr int dim = TypeParam::value;
  for_all_materials<dim>([](const Material<dim> &material) {
    OneCell<dim> cell(false, material);
    for (const auto &strain : random_strains<dim>(n_states<dim>))
    {
      const LocalVector local    = cell.values_near(strain, 0.);
      const LocalVector found    = cell.residual(local);
      const LocalVector expected = difference_gradient(
        [&](const LocalVector &values) { return cell.energy(values); },
        local,
        cell.steps(1e-7, 1.));
      for (unsigned int i = 0; i < local.size(); ++i)
        EXPECT_NEAR(found(i), expected(i), 1e-6 * expected.linfty_norm());
    }
  });
}



TYPED_TEST(ElasticKernelOf, PassesThePatchTestWhenIntact)
{
  // constant strain, p = lambda tr eps: constraint met, and the stress of
  // Hooke's law times the gradients of the shape functions
  constexpr int dim = TypeParam::value;
  for_all_materials<dim>([](const Material<dim> &material) {
    if (!material.is_linear_when_intact())
      return;
    OneCell<dim> cell(true, material);
    cell.lagged_phase_field.assign(cell.quadrature.size(), 1.);
    const auto  strain   = random_strains<dim>(1)[0];
    const auto  identity = dealii::unit_symmetric_tensor<dim>();
    const auto  stress   = 2. * mu * strain + lambda * trace(strain) * identity;
    LocalVector local    = cell.values_near(strain, 0.);
    for (unsigned int i = 0; i < local.size(); ++i)
      if (cell.block[i] == 1)
        local(i) = lambda * trace(strain);
      else
        local(i) -= 1e-6 * random_values(local.size())(i);
    const LocalVector found = cell.residual(local);

    dealii::FEValues<dim> fe_values(cell.mapping,
                                    cell.element,
                                    cell.quadrature,
                                    dealii::update_gradients |
                                      dealii::update_JxW_values);
    fe_values.reinit(cell.triangulation.begin());
    double      volume = 0.;
    LocalVector expected(local.size());
    for (unsigned int q = 0; q < cell.quadrature.size(); ++q)
    {
      volume += fe_values.JxW(q);
      for (unsigned int i = 0; i < local.size(); ++i)
        for (unsigned int d = 0; d < dim && cell.block[i] == 0; ++d)
          expected(i) += stress[cell.component(i)][d] *
                         fe_values.shape_grad(i, q)[d] * fe_values.JxW(q);
    }
    for (unsigned int i = 0; i < local.size(); ++i)
      EXPECT_NEAR(found(i), expected(i), 1e-12 * expected.linfty_norm());
    EXPECT_NEAR(cell.energy(local),
                0.5 * (stress * strain) * volume,
                1e-12 * (stress * strain) * volume);
  });
}
