// SPDX-License-Identifier: GPL-2.0-or-later
// Energy splits in 2-d and 3-d: the parts add up, tangents are derivatives,
// stresses are those of the split energies.
#include "strains.h"

#include <model/energy_split.h>

#include <gtest/gtest.h>

#include <map>
#include <type_traits>

using namespace MixedCracks;
using namespace MixedCracks::Testing;
using dealii::SymmetricTensor;

namespace
{
  constexpr double mu = 2.4;

  template <typename Dimension>
  class EnergySplitTest : public ::testing::Test
  {};

  using Dimensions = ::testing::Types<std::integral_constant<int, 2>,
                                      std::integral_constant<int, 3>>;
  TYPED_TEST_SUITE(EnergySplitTest, Dimensions);

  // Call test(split, n) for every registered split and every n that exists in
  // this dimension.
  template <int dim, typename Test>
  void
  for_all_splits(const Test &test)
  {
    for (const std::string &name : all_energy_splits<dim>().names())
      for (int n = dim; n <= 3; ++n)
      {
        SCOPED_TRACE(name + ", n = " + std::to_string(n));
        test(*all_energy_splits<dim>().make(name, n), n);
      }
  }

  // The energies of (M3) without the pressure, by name
  struct Energies
  {
    std::function<Active(Active trace, Active square, double n)> positive;
    std::function<Active(Active trace, Active square, double n)> negative;
  };

  const std::map<std::string, Energies> energies = {
    {"none",
     {[](Active, Active square, double) -> Active { return mu * square; },
      [](Active, Active, double) -> Active { return 0.; }}},
    {"volumetric-deviatoric",
     {[](Active trace, Active square, double n) -> Active {
        const Active expansion = positive_part(trace);
        return mu * (square - trace * trace / n) +
               mu / n * expansion * expansion;
      },
      [](Active trace, Active, double n) -> Active {
        const Active contraction = positive_part(-trace);
        return mu / n * contraction * contraction;
      }}},
    {"volumetric-deviatoric as printed",
     {[](Active trace, Active square, double) -> Active {
        const Active expansion = positive_part(trace);
        return mu * (square - trace * trace / 3.) +
               0.5 * mu * expansion * expansion;
      },
      [](Active trace, Active, double) -> Active {
        const Active contraction = positive_part(-trace);
        return 0.5 * mu * contraction * contraction;
      }}}};
} // namespace



TYPED_TEST(EnergySplitTest, PartsAddUpToTheElasticStress)
{
  constexpr int dim = TypeParam::value;
  for_all_splits<dim>([](const EnergySplit<dim> &split, int) {
    for (const auto &strain : random_strains<dim>(50))
    {
      const SplitStress<dim> parts = split.evaluate(strain, mu);
      if (!split.adds_up())
      {
        // what the printed pair adds: (1 - 2/3) mu tr eps
        const double excess =
          (parts.positive + parts.negative)[0][0] - 2 * mu * strain[0][0];
        EXPECT_NEAR(excess, mu / 3. * trace(strain), 1e-15);
        continue;
      }
      EXPECT_LT((parts.positive + parts.negative - 2 * mu * strain).norm(),
                1e-15);
      EXPECT_LT((parts.positive_tangent + parts.negative_tangent -
                 2 * mu * dealii::identity_tensor<dim>())
                  .norm(),
                1e-12);
    }
  });
}



TYPED_TEST(EnergySplitTest, PartsAloneAreThoseWithTangents)
{
  constexpr int dim = TypeParam::value;
  for_all_splits<dim>([](const EnergySplit<dim> &split, int) {
    for (const auto &strain : random_strains<dim>(50))
      for (const double shift : {-0.03, 0., 0.03}) // one sign and both
      {
        const auto there =
          strain + shift * dealii::unit_symmetric_tensor<dim>();
        const StressParts<dim> alone = split.parts(there, mu);
        const SplitStress<dim> all   = split.evaluate(there, mu);
        EXPECT_LT((alone.positive - all.positive).norm(), 1e-16);
        EXPECT_LT((alone.negative - all.negative).norm(), 1e-16);
      }
  });
}



TYPED_TEST(EnergySplitTest, OnlyThePrintedPairDoesNotAddUp)
{
  constexpr int dim = TypeParam::value;
  for (const std::string &name : all_energy_splits<dim>().names())
    EXPECT_EQ(all_energy_splits<dim>().make(name, 3)->adds_up(),
              name != "volumetric-deviatoric as printed");
}



TYPED_TEST(EnergySplitTest, TangentsMatchDifferenceQuotients)
{
  constexpr int dim = TypeParam::value;
  for_all_splits<dim>([](const EnergySplit<dim> &split, int) {
    for (const auto &strain : random_strains<dim>(20))
    {
      const SplitStress<dim> parts    = split.evaluate(strain, mu);
      const auto             positive = difference_quotient<dim>(
        [&](const auto &x) { return split.evaluate(x, mu).positive; }, strain);
      const auto negative = difference_quotient<dim>(
        [&](const auto &x) { return split.evaluate(x, mu).negative; }, strain);
      EXPECT_LT((parts.positive_tangent - positive).norm(), 1e-6 * mu);
      EXPECT_LT((parts.negative_tangent - negative).norm(), 1e-6 * mu);
    }
  });
}



TYPED_TEST(EnergySplitTest, StressesAndTangentsAreThoseOfTheEnergies)
{
  constexpr int dim = TypeParam::value;
  for (const auto &[name, energy] : energies)
    for (int n = 2; n <= 3; ++n)
      for (const auto &strain : random_strains<dim>(20))
      {
        SCOPED_TRACE(name + ", n = " + std::to_string(n));
        // in 3-d the deviator has 3 dimensions whatever was asked for
        const double deviator = dim == 3 ? 3. : n;
        const auto   parts =
          all_energy_splits<dim>().make(name, n)->evaluate(strain, mu);
        const auto exact = [&](const auto &part) {
          return differentiate(
            [&](const std::vector<Active> &x) -> Active {
              return part(
                strain_trace<dim>(x), strain_square<dim>(x), deviator);
            },
            as_variables(strain));
        };
        const Derivatives positive = exact(energy.positive);
        const Derivatives negative = exact(energy.negative);
        EXPECT_NEAR(parts.positive * strain, 2 * positive.value, 1e-15);
        EXPECT_NEAR(parts.negative * strain, 2 * negative.value, 1e-15);
        EXPECT_LT((parts.positive - as_stress<dim>(positive)).norm(), 1e-14);
        EXPECT_LT((parts.negative - as_stress<dim>(negative)).norm(), 1e-14);
        EXPECT_LT((parts.positive_tangent - as_tangent<dim>(positive)).norm(),
                  1e-12);
        EXPECT_LT((parts.negative_tangent - as_tangent<dim>(negative)).norm(),
                  1e-12);
      }
}



TYPED_TEST(EnergySplitTest, DrivingPartIsNeverNegative)
{
  constexpr int dim = TypeParam::value;
  for_all_splits<dim>([](const EnergySplit<dim> &split, int) {
    for (const auto &strain : random_strains<dim>(50))
    {
      const SplitStress<dim> parts = split.evaluate(strain, mu);
      EXPECT_GE(parts.positive * strain, 0.);
      EXPECT_GE(parts.negative * strain, 0.);
    }
    EXPECT_EQ(split.evaluate({}, mu).positive.norm(), 0.);
    EXPECT_EQ(split.evaluate({}, mu).negative.norm(), 0.);
  });
}



TYPED_TEST(EnergySplitTest, BranchTellsWhetherTheTangentsAreTheSame)
{
  constexpr int dim = TypeParam::value;
  for_all_splits<dim>([](const EnergySplit<dim> &split, int) {
    const auto strains = random_strains<dim>(12);
    for (const auto &a : strains)
      for (const auto &b : strains)
      {
        if (split.tangent_regime(a) < 0 || split.tangent_regime(b) < 0)
          continue;
        const auto parts_a = split.evaluate(a, mu);
        const auto parts_b = split.evaluate(b, mu);
        const bool are_same =
          parts_a.positive_tangent == parts_b.positive_tangent &&
          parts_a.negative_tangent == parts_b.negative_tangent;
        EXPECT_EQ(are_same, split.tangent_regime(a) == split.tangent_regime(b));
      }
  });
}



// compression alone must not drive a crack, and n decides what "alone" means
TEST(EnergySplit, PureCompressionDrivesNothing)
{
  SymmetricTensor<2, 3> in_3d;
  SymmetricTensor<2, 2> in_2d;
  for (unsigned int d = 0; d < 3; ++d)
    in_3d[d][d] = -0.01;
  in_2d[0][0] = in_2d[1][1] = -0.01;
  const std::string name    = "volumetric-deviatoric";
  EXPECT_NEAR(
    all_energy_splits<3>().make(name, 3)->evaluate(in_3d, mu).positive.norm(),
    0.,
    1e-16);
  EXPECT_NEAR(
    all_energy_splits<2>().make(name, 2)->evaluate(in_2d, mu).positive.norm(),
    0.,
    1e-16);
  // in plane strain an equibiaxial compression has a deviator
  EXPECT_GT(
    all_energy_splits<2>().make(name, 3)->evaluate(in_2d, mu).positive.norm(),
    1e-3);
}
