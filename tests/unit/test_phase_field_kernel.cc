// SPDX-License-Identifier: GPL-2.0-or-later
// The phase-field cell kernel for every crack density: its Jacobian against
// differences of its residual, its residual against differences of the energy.
#include "materials.h"
#include "single_cell.h"

#include <assembly/phase_field_kernel.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  template <int dim>
  class OneCell
  {
  public:
    explicit OneCell(const Material<dim> &material)
      : material(material)
      , mapping(1)
      , quadrature(2)
      , element(1)
      , kernel(element, quadrature, material)
      , fe_values(mapping, element, quadrature, dealii::update_JxW_values)
    {
      make_crooked_cell(triangulation);
      geometry =
        GeometryEvaluator<dim>(mapping, quadrature)(triangulation.begin());
      kernel.reinit(geometry);
      fe_values.reinit(triangulation.begin());
      for (const double value : random_values(quadrature.size(), 3))
        driving_force.push_back(20. + 15. * value);
    }

    LocalVector
    phase_field() const
    {
      LocalVector values = random_values(element.n_dofs_per_cell());
      values *= 0.45;
      values.add(0.5);
      return values;
    }

    LocalVector
    residual(const LocalVector &local)
    {
      LocalVector result(local.size());
      kernel.set_state(local, driving_force.data());
      kernel.residual(result);
      return result;
    }

    // crack energy, and g times the energy density that drives it
    double
    energy(const LocalVector &local)
    {
      kernel.set_state(local, driving_force.data());
      double              sum = kernel.energy();
      std::vector<double> values;
      kernel.interpolate(local, values);
      for (unsigned int q = 0; q < values.size(); ++q)
        sum += 0.5 * material.degradation().value(values[q]) *
               driving_force[q] * fe_values.JxW(q);
      return sum;
    }

    const Material<dim>        &material;
    dealii::Triangulation<dim>  triangulation;
    const dealii::MappingQ<dim> mapping;
    const dealii::QGauss<dim>   quadrature;
    const dealii::FE_Q<dim>     element;
    CellGeometry<dim>           geometry;
    PhaseFieldKernel<dim>       kernel;
    dealii::FEValues<dim>       fe_values;
    std::vector<double>         driving_force;
  };

  // test(cell) for every crack density
  template <int dim, typename Test>
  void
  for_all_densities(const Test &test)
  {
    for (const std::string &density : all_crack_densities().names())
    {
      SCOPED_TRACE(density);
      MaterialDescription constants =
        description("none", all_pressure_laws().names().front(), 3);
      constants.crack_density = density;
      const Material<dim> material(constants);
      OneCell<dim>        cell(material);
      test(cell);
    }
  }

  LocalVector
  steps(const unsigned int n)
  {
    LocalVector result(n);
    result = 1e-5;
    return result;
  }
} // namespace

template <typename Dimension>
class PhaseFieldKernelOf : public ::testing::Test
{};
TYPED_TEST_SUITE(PhaseFieldKernelOf, Dimensions, );



TYPED_TEST(PhaseFieldKernelOf, JacobianIsTheDerivativeOfTheResidual)
{
  constexpr int dim = TypeParam::value;
  for_all_densities<dim>([](OneCell<dim> &cell) {
    const LocalVector local    = cell.phase_field();
    const auto        expected = difference_matrix(
      [&](const LocalVector &values) { return cell.residual(values); },
      local,
      steps(local.size()));
    dealii::FullMatrix<double> found(local.size(), local.size());
    cell.kernel.set_state(local, cell.driving_force.data());
    cell.kernel.jacobian(found);
    expect_equal_by_blocks(
      found, expected, std::vector<unsigned int>(local.size(), 0), 1e-7);
  });
}



TYPED_TEST(PhaseFieldKernelOf, ResidualIsTheDerivativeOfTheEnergy)
{
  constexpr int dim = TypeParam::value;
  for_all_densities<dim>([](OneCell<dim> &cell) {
    const LocalVector local    = cell.phase_field();
    const LocalVector found    = cell.residual(local);
    const LocalVector expected = difference_gradient(
      [&](const LocalVector &values) { return cell.energy(values); },
      local,
      steps(local.size()));
    for (unsigned int i = 0; i < local.size(); ++i)
      EXPECT_NEAR(found(i), expected(i), 1e-7 * expected.linfty_norm());
  });
}



TYPED_TEST(PhaseFieldKernelOf, LumpedMassSumsUpToTheVolume)
{
  constexpr int dim = TypeParam::value;
  for_all_densities<dim>([](OneCell<dim> &cell) {
    LocalVector mass(cell.element.n_dofs_per_cell());
    cell.kernel.lumped_mass(mass);
    double sum = 0.;
    for (const double each : mass)
    {
      EXPECT_GT(each, 0.);
      sum += each;
    }
    EXPECT_NEAR(sum, cell.triangulation.begin()->measure(), 1e-12);
  });
}
