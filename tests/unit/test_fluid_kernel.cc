// SPDX-License-Identifier: GPL-2.0-or-later
// The load of a fluid in the cracks: residuals of u and phi against differences
// of the energy, together with what the kernels of both fields say, and the
// Jacobian of phi against differences of its residual.
#include "materials.h"
#include "single_cell.h"

#include <assembly/elastic_kernel.h>
#include <assembly/fluid_kernel.h>
#include <assembly/phase_field_kernel.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  // One crooked cell with a pressure that differs at every point. Without a
  // split, so that the total energy is smooth, and with the law that has one.
  template <int dim>
  class OneCell
  {
  public:
    explicit OneCell(const bool mixed)
      : material(description("none", "degraded bulk", 3))
      , mapping(1)
      , quadrature(mixed ? 3 : 2)
      , element(make_element(mixed))
      , linear(1)
      , elastic(element, quadrature, material, mixed)
      , phase(linear, quadrature, material)
      , fluid(element, linear, quadrature)
      , n_elastic(element.n_dofs_per_cell())
      , n_phase(linear.n_dofs_per_cell())
    {
      make_crooked_cell(triangulation);
      geometry =
        GeometryEvaluator<dim>(mapping, quadrature)(triangulation.begin());
      elastic.reinit(geometry);
      phase.reinit(geometry);
      fluid.reinit(geometry);
      for (const double value : random_values(quadrature.size(), 5))
        pressure.push_back(3. + 2. * value);
      fluid.set_pressure(pressure.data());
    }

    LocalVector
    elastic_values() const
    {
      LocalVector values = random_values(n_elastic);
      values *= 0.01;
      return values;
    }

    LocalVector
    phase_values() const
    {
      LocalVector values = random_values(n_phase, 11);
      values *= 0.4;
      values.add(0.5);
      return values;
    }

    double
    fluid_energy(const LocalVector &u, const LocalVector &phi)
    {
      fluid.set_phase_field(phi);
      fluid.set_displacement(u);
      return fluid.energy();
    }

    double
    total_energy(const LocalVector &u, const LocalVector &phi)
    {
      std::vector<double> at_points;
      phase.interpolate(phi, at_points);
      elastic.set_state(u, at_points);
      phase.set_state(phi, std::vector<double>(at_points.size(), 0.).data());
      return elastic.energy() + phase.energy() + fluid_energy(u, phi);
    }

    LocalVector
    phase_residual(const LocalVector &u, const LocalVector &phi)
    {
      LocalVector result(n_phase);
      fluid.set_phase_field(phi);
      fluid.set_displacement(u);
      fluid.phase_field_residual(result);
      return result;
    }

    const Material<dim>         material;
    dealii::Triangulation<dim>  triangulation;
    const dealii::MappingQ<dim> mapping;
    const dealii::QGauss<dim>   quadrature;
    const dealii::FESystem<dim> element;
    const dealii::FE_Q<dim>     linear;
    CellGeometry<dim>           geometry;
    ElasticKernel<dim>          elastic;
    PhaseFieldKernel<dim>       phase;
    FluidKernel<dim>            fluid;
    const unsigned int          n_elastic;
    const unsigned int          n_phase;
    std::vector<double>         pressure;

  private:
    static dealii::FESystem<dim>
    make_element(const bool mixed)
    {
      const dealii::FE_Q<dim> linear(1), quadratic(2);
      if (mixed)
        return dealii::FESystem<dim>(quadratic, dim, linear, 1);
      return dealii::FESystem<dim>(linear, dim);
    }
  };

  LocalVector
  equal_steps(const unsigned int n, const double step)
  {
    LocalVector result(n);
    result = step;
    return result;
  }

  void
  expect_equal(const LocalVector &found, const LocalVector &expected)
  {
    ASSERT_GT(expected.linfty_norm(), 0.);
    for (unsigned int i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found(i), expected(i), 1e-7 * expected.linfty_norm());
  }
} // namespace

template <typename Dimension>
class FluidKernelOf : public ::testing::Test
{};
TYPED_TEST_SUITE(FluidKernelOf, Dimensions, );



TYPED_TEST(FluidKernelOf, NodalForcesAreMinusTheDerivativeOfTheEnergy)
{
  constexpr int dim = TypeParam::value;
  for (const bool mixed : {true, false})
  {
    OneCell<dim>      cell(mixed);
    const LocalVector phi = cell.phase_values();
    LocalVector       found(cell.n_elastic);
    cell.fluid.set_phase_field(phi);
    cell.fluid.nodal_forces(found);
    found *= -1.;
    expect_equal(
      found,
      difference_gradient(
        [&](const LocalVector &u) { return cell.fluid_energy(u, phi); },
        cell.elastic_values(),
        equal_steps(cell.n_elastic, 0.1)));
  }
}



TYPED_TEST(FluidKernelOf, ResidualOfTheDisplacementIsThatOfTheTotalEnergy)
{
  // what the step solves: internal less external forces
  constexpr int     dim = TypeParam::value;
  OneCell<dim>      cell(/*mixed=*/false);
  const LocalVector phi = cell.phase_values(), u = cell.elastic_values();
  const LocalVector expected = difference_gradient(
    [&](const LocalVector &values) { return cell.total_energy(values, phi); },
    u,
    equal_steps(cell.n_elastic, 1e-4));
  cell.total_energy(u, phi);
  LocalVector found(cell.n_elastic), forces(cell.n_elastic);
  cell.elastic.residual(found);
  cell.fluid.nodal_forces(forces);
  found -= forces;
  expect_equal(found, expected);
}



TYPED_TEST(FluidKernelOf, ResidualOfThePhaseFieldIsThatOfTheTotalEnergy)
{
  constexpr int dim = TypeParam::value;
  for (const bool mixed : {true, false})
  {
    OneCell<dim>      cell(mixed);
    const LocalVector phi = cell.phase_values();
    LocalVector       u   = cell.elastic_values();
    // at the p of the constraint, where the energy is stationary in p: a
    // state of pure shear has p = 0
    if (mixed)
      for (unsigned int i = 0; i < cell.n_elastic; ++i)
      {
        const auto [component, node] =
          cell.element.system_to_component_index(i);
        u(i) = 0.;
        if (component == 0)
        {
          const auto position = cell.mapping.transform_unit_to_real_cell(
            cell.triangulation.begin(),
            cell.element.base_element(0).get_unit_support_points()[node]);
          u(i) = 0.02 * position[1] + 0.01;
        }
      }
    const LocalVector expected = difference_gradient(
      [&](const LocalVector &values) { return cell.total_energy(u, values); },
      phi,
      equal_steps(cell.n_phase, 1e-4));
    cell.total_energy(u, phi);
    std::vector<double> driving;
    for (const auto &point : cell.elastic.points())
      driving.push_back(
        cell.elastic.driving_force(point, cell.material.uniform_constants()));
    cell.phase.set_state(phi, driving.data());
    LocalVector found(cell.n_phase);
    cell.phase.residual(found);
    found += cell.phase_residual(u, phi);
    expect_equal(found, expected);
  }
}



TYPED_TEST(FluidKernelOf, JacobianIsTheDerivativeOfTheResidual)
{
  constexpr int dim = TypeParam::value;
  for (const bool mixed : {true, false})
  {
    OneCell<dim>      cell(mixed);
    const LocalVector phi = cell.phase_values(), u = cell.elastic_values();
    const auto        expected = difference_matrix(
      [&](const LocalVector &values) { return cell.phase_residual(u, values); },
      phi,
      equal_steps(cell.n_phase, 0.1));
    dealii::FullMatrix<double> found(cell.n_phase, cell.n_phase);
    cell.fluid.phase_field_jacobian(found);
    expect_equal_by_blocks(
      found, expected, std::vector<unsigned int>(cell.n_phase, 0), 1e-10);
  }
}



TYPED_TEST(FluidKernelOf, DoesNothingToIntactMaterial)
{
  constexpr int dim = TypeParam::value;
  OneCell<dim>  cell(/*mixed=*/true);
  LocalVector   forces(cell.n_elastic), phi(cell.n_phase);
  phi = 1.;
  cell.fluid.set_phase_field(phi);
  cell.fluid.nodal_forces(forces);
  EXPECT_LT(forces.linfty_norm(), 1e-13);
}
