// SPDX-License-Identifier: GPL-2.0-or-later
// What drives the crack at one point, for every pressure law, split and n.
#include "materials.h"
#include "strains.h"

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;
using dealii::SymmetricTensor;

namespace
{
  template <typename Dimension>
  class MaterialEnergyTest : public ::testing::Test
  {};

  TYPED_TEST_SUITE(MaterialEnergyTest, Dimensions);
} // namespace



// g sigma+ : eps is what driving_force() promises; with g = 1 nothing may be
// lost, and nothing but compression may be left out
TYPED_TEST(MaterialEnergyTest, IntactDrivingForceIsBoundedByTheElasticEnergy)
{
  constexpr int dim = TypeParam::value;
  for_all_materials<dim>([](const Material<dim> &material) {
    for (const auto &strain : random_strains<dim>(20))
    {
      const double p      = material.pressure(strain, 1.);
      const double energy = material.elastic_energy(strain, p, 1.);
      const double force  = material.driving_force(strain, p, 1.);
      EXPECT_GE(force, 0.);
      EXPECT_LE(force, 2 * energy * (1. + 1e-12));
      if (material.description().energy_split == "none" ||
          (material.description().energy_split == "volumetric-deviatoric" &&
           trace(strain) > 0.))
      {
        EXPECT_NEAR(force, 2 * energy, 1e-14);
      }
    }
  });
}



// the pressure's part of the driving force, by law; see model.md, section 3
TYPED_TEST(MaterialEnergyTest, DrivingPressureFollowsTheLaw)
{
  constexpr int dim = TypeParam::value;
  const double  g = 0.25, p = 0.3;
  for (const auto &[law, factor] : {std::make_pair("relaxed bulk", 1. / g),
                                    std::make_pair("degraded divergence", 1.),
                                    std::make_pair("degraded bulk", 1.)})
    for (const auto &strain : random_strains<dim>(10))
    {
      SCOPED_TRACE(law);
      const Material<dim> amor(description("volumetric-deviatoric", law, 3));
      const Material<dim> none(description("none", law, 3));
      const double        work = factor * p * trace(strain);
      EXPECT_NEAR(amor.driving_force(strain, p, g) -
                    amor.driving_force(strain, 0., g),
                  work,
                  1e-14);
      EXPECT_EQ(amor.driving_force(strain, -p, g),
                amor.driving_force(strain, 0., g));
      EXPECT_NEAR(none.driving_force(strain, -p, g),
                  2 * mu * (strain * strain) - work,
                  1e-14);
    }
}



// [Amor09] without a pressure: "degraded bulk" in displacements has an energy,
// its stress is the derivative by the strain, its driving force by g
TYPED_TEST(MaterialEnergyTest, DegradedBulkIsTheClassicalModel)
{
  constexpr int dim = TypeParam::value;
  for (int n = dim; n <= 3; ++n)
    for (const auto &strain : random_strains<dim>(20))
      for (const double g : degradations)
      {
        const Material<dim> material(
          description("volumetric-deviatoric", "degraded bulk", n));
        std::vector<double> point = as_variables(strain);
        point.push_back(g);
        const Derivatives energy = differentiate(
          [n](const std::vector<Active> &x) -> Active {
            const double bulk      = lambda + 2 * mu / n;
            const Active trace     = strain_trace<dim>(x);
            const Active expands   = positive_part(trace);
            const Active contracts = positive_part(-trace);
            const Active shear =
              mu * (strain_square<dim>(x) - trace * trace / double(n));
            return x.back() * (bulk / 2. * expands * expands + shear) +
                   bulk / 2. * contracts * contracts;
          },
          point);
        const double p        = material.pressure(strain, g);
        const auto   response = material.eliminated(strain, g);
        EXPECT_NEAR(material.elastic_energy(strain, p, g), energy.value, 1e-14);
        EXPECT_LT((response.stress - as_stress<dim>(energy)).norm(), 1e-13);
        EXPECT_LT((response.stress_by_strain - as_tangent<dim>(energy)).norm(),
                  1e-11);
        EXPECT_NEAR(material.driving_force(strain, p, g) / 2,
                    energy.first[dim * dim],
                    1e-14);
      }
}



// [Miehe10a]: psi+ = lambda/2 <tr eps>^2 + mu eps+ : eps+ with its stress and
// its driving force; tangents are those of the split, which has its own tests
TYPED_TEST(MaterialEnergyTest, SpectralWithDegradedBulkIsMiehesModel)
{
  constexpr int       dim = TypeParam::value;
  const Material<dim> material(description("spectral", "degraded bulk", 3));
  const auto          energies = [](const SymmetricTensor<2, dim> &strain) {
    std::pair<double, double> result;
    const double              expansion = trace(strain);
    (expansion > 0. ? result.first : result.second) +=
      lambda / 2. * expansion * expansion;
    for (const double value : eigenvalues(strain))
      (value > 0. ? result.first : result.second) += mu * value * value;
    return result;
  };
  for (const auto &strain : random_strains<dim>(20))
    for (const double g : degradations)
    {
      const auto [positive, negative] = energies(strain);
      const double p                  = material.pressure(strain, g);
      EXPECT_NEAR(material.elastic_energy(strain, p, g),
                  g * positive + negative,
                  1e-14 * lambda);
      EXPECT_NEAR(
        material.driving_force(strain, p, g), 2. * positive, 1e-14 * lambda);
      const auto degraded = [&](const SymmetricTensor<2, dim> &x) {
        const auto [tension, compression] = energies(x);
        return g * tension + compression;
      };
      const auto stress   = material.eliminated(strain, g).stress;
      const auto expected = energy_quotient<dim>(degraded, strain);
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          EXPECT_NEAR(stress[i][j], expected[i][j], 1e-7 * lambda);
    }
}
