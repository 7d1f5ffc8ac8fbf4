// SPDX-License-Identifier: GPL-2.0-or-later
// The elastic cell kernel at finite strain: its Jacobian against differences of
// its residual, its residual against differences of its potential, and what it
// says of a cell that is stretched evenly.
#include "materials.h"
#include "one_cell.h"

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  using Constants = decltype(PointConstants::hyperelastic);

  struct Law
  {
    std::string name;
    Constants   constants;
  };

  // one whose tangent does not depend on I_1, and one whose does; mu = 2.4 MPa
  const std::vector<Law> laws = {{"neo-Hooke", {{mu}}},
                                 {"Yeoh", {{1.2, 0.02, 0.003}}}};

  MaterialDescription
  rubber(const Law         &law,
         const std::string &split,
         const std::string &pressure_law,
         const bool         plane_stress)
  {
    MaterialDescription result     = description("none", "relaxed bulk", 3);
    result.energy_split            = split;
    result.pressure_law            = pressure_law;
    result.strains                 = Strains::finite;
    result.hyperelastic_law        = law.name;
    result.plane_stress            = plane_stress;
    result.constants->hyperelastic = law.constants;
    return result;
  }

  /// Call test(material) for what changes the form of the kernel's integrands.
  template <int dim, typename Test>
  void
  for_all_rubbers(const Test &test)
  {
    for (const Law &law : laws)
      for (const std::string split : {"none", "volumetric"})
        for (const std::string pressure_law : {"relaxed bulk", "cubic"})
          for (const bool plane_stress : {false, true})
          {
            if (plane_stress && dim == 3)
              continue;
            SCOPED_TRACE(law.name + ", split " + split + ", " + pressure_law +
                         (plane_stress ? ", plane stress" : ""));
            test(Material<dim>(rubber(law, split, pressure_law, plane_stress)));
          }
  }

  // Stretched and sheared and turned, larger and smaller than it was
  template <int dim>
  std::vector<dealii::Tensor<2, dim>>
  gradients()
  {
    std::vector<dealii::Tensor<2, dim>> result;
    for (const double change : {0.35, -0.2})
    {
      dealii::Tensor<2, dim> gradient;
      for (unsigned int d = 0; d < dim; ++d)
        gradient[d][d] = change * (1. + 0.2 * d);
      gradient[0][1]       = 0.4;
      gradient[1][0]       = -0.25;
      gradient[dim - 1][0] = -0.3;
      result.push_back(gradient);
    }
    return result;
  }

  template <int dim>
  void
  compare_jacobian(OneCell<dim> &cell, const LocalVector &local)
  {
    cell.compare_jacobian(local, cell.steps(1e-6, 1e-5));
    EXPECT_TRUE(cell.kernel.jacobian_is_symmetric());
  }

  template <int dim>
  void
  compare_residual(OneCell<dim> &cell, const LocalVector &local)
  {
    const LocalVector found    = cell.residual(local);
    const LocalVector expected = difference_gradient(
      [&](const LocalVector &values) {
        cell.kernel.set_state(
          values, cell.lagged_phase_field, ElasticEvaluation::points);
        return cell.kernel.potential();
      },
      local,
      cell.steps(1e-6, 1e-5));
    double largest[2] = {0., 0.};
    for (unsigned int i = 0; i < local.size(); ++i)
      largest[cell.block[i]] =
        std::max(largest[cell.block[i]], std::abs(expected(i)));
    for (unsigned int i = 0; i < local.size(); ++i)
      EXPECT_NEAR(found(i), expected(i), 1e-6 * largest[cell.block[i]])
        << "row " << i;
  }
} // namespace

template <typename Dimension>
class FiniteStrainKernelOf : public ::testing::Test
{};
TYPED_TEST_SUITE(FiniteStrainKernelOf, Dimensions, );



TYPED_TEST(FiniteStrainKernelOf, MixedJacobianIsTheDerivativeOfTheResidual)
{
  constexpr int dim = TypeParam::value;
  for_all_rubbers<dim>([](const Material<dim> &material) {
    OneCell<dim> cell(true, material);
    for (const double pressure : {0.7, -0.5})
      compare_jacobian(cell, cell.values_near(gradients<dim>()[0], pressure));
  });
}



TYPED_TEST(FiniteStrainKernelOf,
           DisplacementJacobianIsTheDerivativeOfTheResidual)
{
  constexpr int dim = TypeParam::value;
  for_all_rubbers<dim>([](const Material<dim> &material) {
    OneCell<dim> cell(false, material);
    for (const auto &gradient : gradients<dim>())
      compare_jacobian(cell, cell.values_near(gradient, 0.));
  });
}



TYPED_TEST(FiniteStrainKernelOf, MixedResidualIsTheDerivativeOfThePotential)
{
  // by displacements and pressures
  constexpr int dim = TypeParam::value;
  for_all_rubbers<dim>([](const Material<dim> &material) {
    OneCell<dim> cell(true, material);
    for (const double pressure : {0.7, -0.5})
      compare_residual(cell, cell.values_near(gradients<dim>()[0], pressure));
  });
}



TYPED_TEST(FiniteStrainKernelOf, DisplacementResidualIsTheDerivativeOfTheEnergy)
{
  constexpr int dim = TypeParam::value;
  for_all_rubbers<dim>([](const Material<dim> &material) {
    OneCell<dim> cell(false, material);
    for (const auto &gradient : gradients<dim>())
    {
      const LocalVector local = cell.values_near(gradient, 0.);
      compare_residual(cell, local);
      // the energy of the line search is the one of the output
      const double energy = cell.energy(local); // sets the state
      EXPECT_NEAR(energy, cell.kernel.potential(), 1e-12 * energy);
    }
  });
}



namespace
{
  // damaged, but by its law: gamma = 1
  template <int dim>
  void
  whole(OneCell<dim> &cell)
  {
    std::fill(
      cell.lagged_phase_field.begin(), cell.lagged_phase_field.end(), 0.8);
  }
} // namespace



TYPED_TEST(FiniteStrainKernelOf, KnowsCellsThatAreTurnedInsideOut)
{
  constexpr int       dim = TypeParam::value;
  const Material<dim> material(rubber(laws[0], "none", "relaxed bulk", false));
  OneCell<dim>        cell(false, material);
  whole(cell);
  dealii::Tensor<2, dim> gradient;
  gradient[0][0] = 1.;
  const auto set = [&]() {
    LocalVector values = cell.values_near(gradient, 0.);
    cell.kernel.set_state(
      values, cell.lagged_phase_field, ElasticEvaluation::points);
  };
  set();
  EXPECT_NEAR(cell.kernel.smallest_determinant(), 2., 1e-4);
  EXPECT_TRUE(std::isfinite(cell.kernel.potential()));
  gradient[1][1] = -1.1;
  set();
  EXPECT_NEAR(cell.kernel.smallest_determinant(), -0.2, 1e-4);
  EXPECT_FALSE(cell.kernel.potential() <= 1e300);
  // a broken one has no inside
  std::fill(
    cell.lagged_phase_field.begin(), cell.lagged_phase_field.end(), 0.1);
  set();
  EXPECT_EQ(cell.kernel.smallest_determinant(), 1.);
  EXPECT_TRUE(std::isfinite(cell.kernel.potential()));
  // nor where the phase field has grown since
  const std::vector<double> grown(cell.lagged_phase_field.size(), 0.8);
  EXPECT_NEAR(cell.kernel.energy(grown), cell.kernel.energy(), 1e-12);
}



TYPED_TEST(FiniteStrainKernelOf, AveragesAreThoseOfAnEvenDeformation)
{
  // stretched by 2 along x and turned: the stress of Cauchy turns with it
  constexpr int       dim = TypeParam::value;
  const Material<dim> material(rubber(laws[0], "none", "relaxed bulk", false));
  OneCell<dim>        cell(false, material);
  whole(cell);
  const double           angle    = 0.4;
  dealii::Tensor<2, dim> rotation = dealii::unit_symmetric_tensor<dim>();
  rotation[0][0] = rotation[1][1] = std::cos(angle);
  rotation[1][0]                  = std::sin(angle);
  rotation[0][1]                  = -rotation[1][0];
  dealii::Tensor<2, dim> stretch  = dealii::unit_symmetric_tensor<dim>();
  stretch[0][0]                   = 2.;
  const auto averages             = [&](const dealii::Tensor<2, dim> &F) {
    dealii::Tensor<2, dim> gradient = F;
    for (unsigned int d = 0; d < dim; ++d)
      gradient[d][d] -= 1.;
    const LocalVector values = cell.values_near(gradient, 0.);
    cell.kernel.set_state(values, cell.lagged_phase_field);
    return cell.kernel.averages(cell.lagged_phase_field);
  };
  const auto straight = averages(stretch);
  const auto turned   = averages(rotation * stretch);
  EXPECT_NEAR(straight.largest_stretch, 2., 1e-4);
  EXPECT_NEAR(straight.volume_ratio, 2., 1e-4);
  EXPECT_NEAR(turned.largest_stretch, 2., 1e-4);
  EXPECT_GT(straight.stress[0][0], straight.stress[1][1]);
  const dealii::Tensor<2, dim> expected =
    rotation * dealii::Tensor<2, dim>(straight.stress) * transpose(rotation);
  EXPECT_LT((dealii::Tensor<2, dim>(turned.stress) - expected).norm(),
            1e-4 * expected.norm());
  EXPECT_NEAR(turned.energy_density,
              straight.energy_density,
              1e-4 * straight.energy_density);
}
