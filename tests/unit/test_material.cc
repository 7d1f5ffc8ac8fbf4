// SPDX-License-Identifier: GPL-2.0-or-later
// The material at one point, for every pressure law, split and n: linear
// elasticity where intact, consistent derivatives, one material in both
// formulations.
#include "materials.h"
#include "strains.h"

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;
using dealii::SymmetricTensor;

namespace
{
  const std::vector<double> pressures = {-0.8, 0.3};

  template <typename Dimension>
  class MaterialTest : public ::testing::Test
  {};

  TYPED_TEST_SUITE(MaterialTest, Dimensions);

  template <int dim>
  SymmetricTensor<4, dim>
  bulk_tensor()
  {
    return outer_product(dealii::unit_symmetric_tensor<dim>(),
                         dealii::unit_symmetric_tensor<dim>());
  }
} // namespace



TYPED_TEST(MaterialTest, IntactIsLinearlyElasticInMixedForm)
{
  constexpr int dim  = TypeParam::value;
  const auto    unit = dealii::unit_symmetric_tensor<dim>();
  for_all_materials<dim>([&](const Material<dim> &material) {
    if (!material.is_linear_when_intact())
      return;
    for (const auto &strain : random_strains<dim>(20))
      for (const double p : {-0.8, 0., 0.3, lambda * trace(strain)})
      {
        const auto response = material.mixed(strain, p, 1.);
        EXPECT_LT((response.stress - 2 * mu * strain - p * unit).norm(), 1e-14);
        EXPECT_LT(
          (response.stress_by_strain - 2 * mu * dealii::identity_tensor<dim>())
            .norm(),
          1e-12);
        EXPECT_DOUBLE_EQ(response.stress_by_pressure, 1.);
        EXPECT_NEAR(response.constraint, trace(strain) - p / lambda, 1e-16);
        EXPECT_DOUBLE_EQ(response.constraint_by_trace, 1.);
        EXPECT_DOUBLE_EQ(response.constraint_by_pressure, -1. / lambda);
      }
  });
}



TYPED_TEST(MaterialTest, IntactIsLinearlyElasticInDisplacements)
{
  constexpr int                 dim = TypeParam::value;
  const SymmetricTensor<4, dim> elasticity =
    2 * mu * dealii::identity_tensor<dim>() + lambda * bulk_tensor<dim>();
  for_all_materials<dim>([&](const Material<dim> &material) {
    if (!material.is_linear_when_intact())
      return;
    for (const auto &strain : random_strains<dim>(20))
    {
      const auto   response = material.eliminated(strain, 1.);
      const double pressure = material.pressure(strain, 1.);
      EXPECT_LT((response.stress - elasticity * strain).norm(), 1e-13);
      EXPECT_LT((response.stress_by_strain - elasticity).norm(), 1e-11);
      EXPECT_NEAR(pressure, lambda * trace(strain), 1e-14);
      EXPECT_NEAR(material.elastic_energy(strain, pressure, 1.),
                  0.5 * (strain * (elasticity * strain)),
                  1e-14);
    }
  });
}



TYPED_TEST(MaterialTest, MixedDerivativesMatchDifferenceQuotients)
{
  constexpr int dim  = TypeParam::value;
  const auto    unit = dealii::unit_symmetric_tensor<dim>();
  for_all_materials<dim>([&](const Material<dim> &material) {
    for (const auto &strain : random_strains<dim>(5))
      for (const double p : pressures)
        for (const double g : degradations)
        {
          const auto response = material.mixed(strain, p, g);
          const auto tangent  = difference_quotient<dim>(
            [&](const auto &x) {
              return symmetrize(material.mixed(x, p, g).stress);
            },
            strain);
          EXPECT_LT((response.stress_by_strain - tangent).norm(), 1e-6 * mu);

          const double step  = 0.01;
          const auto   plus  = material.mixed(strain, p + step, g);
          const auto   minus = material.mixed(strain, p - step, g);
          EXPECT_LT(((plus.stress - minus.stress) / (2 * step) -
                     response.stress_by_pressure * unit)
                      .norm(),
                    1e-11);
          EXPECT_NEAR((plus.constraint - minus.constraint) / (2 * step) /
                        response.constraint_by_pressure,
                      1.,
                      1e-9);
          const auto wider = material.mixed(strain + 1e-5 * unit / dim, p, g);
          EXPECT_NEAR((wider.constraint - response.constraint) / 1e-5,
                      response.constraint_by_trace,
                      1e-6);
        }
  });
}



TYPED_TEST(MaterialTest, EliminatedTangentMatchesDifferenceQuotients)
{
  constexpr int dim = TypeParam::value;
  for_all_materials<dim>([](const Material<dim> &material) {
    for (const auto &strain : random_strains<dim>(10))
      for (const double g : degradations)
      {
        const auto tangent = difference_quotient<dim>(
          [&](const auto &x) {
            return symmetrize(material.eliminated(x, g).stress);
          },
          strain);
        EXPECT_LT(
          (material.eliminated(strain, g).stress_by_strain - tangent).norm(),
          1e-6 * lambda);
      }
  });
}



// the two formulations are one material: at the pressure that satisfies the
// constraint they have one stress, and the condensed tangents agree
TYPED_TEST(MaterialTest, EliminationAgreesWithTheMixedForm)
{
  constexpr int dim = TypeParam::value;
  for_all_materials<dim>([](const Material<dim> &material) {
    for (const auto &strain : random_strains<dim>(20))
      for (const double g : degradations)
      {
        const double p          = material.pressure(strain, g);
        const auto   mixed      = material.mixed(strain, p, g);
        const auto   eliminated = material.eliminated(strain, g);
        EXPECT_NEAR(mixed.constraint, 0., 1e-15);
        EXPECT_LT((mixed.stress - eliminated.stress).norm(), 1e-13);
        EXPECT_LT((mixed.stress_by_strain -
                   mixed.stress_by_pressure * mixed.constraint_by_trace /
                     mixed.constraint_by_pressure * bulk_tensor<dim>() -
                   eliminated.stress_by_strain)
                    .norm(),
                  1e-11);
        EXPECT_NEAR(material.elastic_energy(strain, p, g),
                    0.5 * (symmetrize(eliminated.stress) * strain),
                    1e-14);
      }
  });
}



TYPED_TEST(MaterialTest, BranchTellsWhetherTheDerivativesAreTheSame)
{
  constexpr int dim = TypeParam::value;
  const double  g   = 0.2;
  for_all_materials<dim>([&](const Material<dim> &material) {
    const auto strains = random_strains<dim>(8);
    for (const auto &a : strains)
      for (const auto &b : strains)
        for (const double p : pressures)
          for (const double q : pressures)
          {
            if (material.tangent_regime(a, p) < 0 ||
                material.tangent_regime(b, q) < 0)
              continue;
            const auto mixed_a = material.mixed(a, p, g);
            const auto mixed_b = material.mixed(b, q, g);
            const bool are_same =
              mixed_a.stress_by_strain == mixed_b.stress_by_strain &&
              mixed_a.stress_by_pressure == mixed_b.stress_by_pressure &&
              mixed_a.constraint_by_trace == mixed_b.constraint_by_trace &&
              mixed_a.constraint_by_pressure == mixed_b.constraint_by_pressure;
            EXPECT_EQ(are_same,
                      material.tangent_regime(a, p) ==
                        material.tangent_regime(b, q));
            EXPECT_EQ(material.eliminated(a, g).stress_by_strain ==
                        material.eliminated(b, g).stress_by_strain,
                      material.tangent_regime(a, 0.) ==
                        material.tangent_regime(b, 0.));
          }
  });
}



TEST(Material, IsComposedAsDescribed)
{
  for (const std::string &name : all_crack_densities().names())
  {
    MaterialDescription wanted = description("none", "relaxed bulk", 3);
    wanted.crack_density       = name;
    const Material<2> material(wanted);
    EXPECT_EQ(material.crack_density().local(0.3),
              all_crack_densities().make(name)->local(0.3));
    EXPECT_EQ(material.degradation().value(0.), 1e-3);
    EXPECT_EQ(material.description().crack_density, name);
  }
}



TEST(Material, UnknownNamesAreInputErrors)
{
  EXPECT_THROW(Material<2>(description("nothing", "relaxed bulk", 3)),
               InputError);
  EXPECT_THROW(Material<3>(description("none", "relaxed bulg", 3)), InputError);
  MaterialDescription wanted = description("none", "relaxed bulk", 3);
  wanted.crack_density       = "AT3";
  EXPECT_THROW(Material<2>{wanted}, InputError);
}
