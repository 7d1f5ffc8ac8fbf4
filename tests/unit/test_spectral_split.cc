// SPDX-License-Identifier: GPL-2.0-or-later
// The spectral split where the general tests of splits do not look: against
// its energy, and at equal and vanishing principal strains, where automatic
// differentiation of eigenvalues is wrong.
#include "strains.h"

#include <deal.II/physics/transformations.h>

#include <gtest/gtest.h>

#include <model/spectral_split.h>

#include <type_traits>

using namespace MixedCracks;
using namespace MixedCracks::Testing;
using dealii::SymmetricTensor;
using dealii::Tensor;

namespace
{
  constexpr double mu = 2.4;

  template <int dim>
  SymmetricTensor<2, dim>
  diagonal(const std::array<double, dim> &entries)
  {
    SymmetricTensor<2, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d][d] = entries[d];
    return result;
  }

  // some rotation that mixes all axes
  template <int dim>
  Tensor<2, dim>
  rotation()
  {
    if constexpr (dim == 2)
      return dealii::Physics::Transformations::Rotations::rotation_matrix_2d(
        0.7);
    else
      return dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
        dealii::Tensor<1, 3>({1. / 3., 2. / 3., -2. / 3.}), 0.7);
  }

  template <int dim>
  SymmetricTensor<2, dim>
  rotated(const SymmetricTensor<2, dim> &tensor)
  {
    const Tensor<2, dim> q = rotation<dim>();
    return symmetrize(q * Tensor<2, dim>(tensor) * transpose(q));
  }

  template <int dim>
  double
  tension_energy(const SymmetricTensor<2, dim> &strain)
  {
    double sum = 0.;
    for (const double value : eigenvalues(strain))
      sum += mu * std::pow(std::max(value, 0.), 2);
    return sum;
  }

  // strains at the kinks: equal and vanishing principal strains
  template <int dim>
  std::vector<SymmetricTensor<2, dim>>
  strains_at_kinks()
  {
    std::vector<std::array<double, dim>> entries;
    if constexpr (dim == 2)
      entries = {{{0., 0.}},
                 {{0.01, 0.01}},
                 {{-0.01, -0.01}},
                 {{0.01, 0.}},
                 {{0., -0.01}},
                 {{0.01, -0.01}}};
    else
      entries = {{{0., 0., 0.}},
                 {{0.01, 0.01, 0.01}},
                 {{0.01, 0.01, -0.02}},
                 {{-0.01, 0.02, -0.01}},
                 {{0.01, 0.01, 0.}},
                 {{0., 0., 0.02}},
                 {{0., -0.02, 0.}},
                 {{-0.01, -0.01, -0.01}},
                 {{0.01, 0., -0.01}}};
    std::vector<SymmetricTensor<2, dim>> result;
    for (const auto &each : entries)
      result.push_back(diagonal<dim>(each));
    return result;
  }

  template <typename Dimension>
  class SpectralSplitTest : public ::testing::Test
  {};

  using Dimensions = ::testing::Types<std::integral_constant<int, 2>,
                                      std::integral_constant<int, 3>>;
  TYPED_TEST_SUITE(SpectralSplitTest, Dimensions);
} // namespace



TYPED_TEST(SpectralSplitTest, PrincipalStrainsComposeTheStrain)
{
  constexpr int dim     = TypeParam::value;
  auto          strains = random_strains<dim>(50);
  for (const auto &strain : strains_at_kinks<dim>())
  {
    strains.push_back(strain);
    strains.push_back(rotated(strain));
  }
  for (const auto &strain : strains)
  {
    const PrincipalStrains<dim> principal = principal_strains(strain);
    Tensor<2, dim>              sum, basis;
    for (unsigned int a = 0; a < dim; ++a)
    {
      sum += principal.values[a] *
             outer_product(principal.directions[a], principal.directions[a]);
      basis[a] = principal.directions[a];
      if (a > 0)
      {
        EXPECT_GE(principal.values[a - 1], principal.values[a]);
      }
    }
    EXPECT_LT((sum - Tensor<2, dim>(strain)).norm(), 1e-16);
    EXPECT_LT((basis * transpose(basis) -
               Tensor<2, dim>(dealii::unit_symmetric_tensor<dim>()))
                .norm(),
              1e-14);
  }
}



TYPED_TEST(SpectralSplitTest, StressIsTheDerivativeOfTheEnergy)
{
  constexpr int            dim = TypeParam::value;
  const SpectralSplit<dim> split;
  for (const auto &strain : random_strains<dim>(50))
  {
    const SymmetricTensor<2, dim> stress = split.evaluate(strain, mu).positive;
    EXPECT_NEAR(stress * strain, 2. * tension_energy(strain), 1e-15);
    const auto expected = energy_quotient<dim>(tension_energy<dim>, strain);
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i; j < dim; ++j)
        EXPECT_NEAR(stress[i][j], expected[i][j], 1e-8 * mu);
  }
}



// Central differences meet the mean of the one-sided limits at a kink, and
// the limit formula where equal principal strains hide none.
TYPED_TEST(SpectralSplitTest, TangentsAtKinksMatchDifferenceQuotients)
{
  constexpr int            dim = TypeParam::value;
  const SpectralSplit<dim> split;
  for (const auto &strain : strains_at_kinks<dim>())
  {
    SCOPED_TRACE(strain);
    const auto tangent  = split.evaluate(strain, mu).positive_tangent;
    const auto quotient = difference_quotient<dim>(
      [&](const auto &x) { return split.evaluate(x, mu).positive; }, strain);
    EXPECT_LT((tangent - quotient).norm(), 2e-4 * mu);
  }
}



TYPED_TEST(SpectralSplitTest, DoesNotDependOnTheAxes)
{
  constexpr int            dim     = TypeParam::value;
  auto                     strains = random_strains<dim>(20);
  const SpectralSplit<dim> split;
  for (const auto &strain : strains_at_kinks<dim>())
    strains.push_back(strain);
  const auto direction = random_strains<dim>(1).front();
  for (const auto &strain : strains)
  {
    SCOPED_TRACE(strain);
    const auto here  = split.evaluate(strain, mu);
    const auto there = split.evaluate(rotated(strain), mu);
    EXPECT_LT((rotated(here.positive) - there.positive).norm(), 1e-15);
    // rounding of a turned strain decides the sign of a vanishing one
    bool vanishes = false;
    for (const double value : eigenvalues(strain))
      vanishes |= value == 0.;
    if (!vanishes)
    {
      EXPECT_LT((rotated<dim>(here.positive_tangent * direction) -
                 there.positive_tangent * rotated(direction))
                  .norm(),
                1e-14);
    }
  }
}



// the formula of unequal strains would divide rounding by rounding here
TYPED_TEST(SpectralSplitTest, NearlyEqualStrainsGiveTheLimit)
{
  constexpr int            dim = TypeParam::value;
  const SpectralSplit<dim> split;
  auto                     strain = strains_at_kinks<dim>()[2];
  const auto               limit  = split.evaluate(strain, mu);
  strain[0][1] += 1e-17;
  strain[0][0] += 2e-18;
  const auto near = split.evaluate(strain, mu);
  EXPECT_LT((near.positive - limit.positive).norm(), 1e-15);
  EXPECT_LT((near.positive_tangent - limit.positive_tangent).norm(), 1e-13);
}



// a plane strain is a strain in space
TEST(SpectralSplit, PlaneStrainIsTheRestrictionOfTheLawInSpace)
{
  for (const auto &strain : random_strains<2>(50))
  {
    SymmetricTensor<2, 3> in_space;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = i; j < 2; ++j)
        in_space[i][j] = strain[i][j];
    const auto plane = SpectralSplit<2>().evaluate(strain, mu);
    const auto space = SpectralSplit<3>().evaluate(in_space, mu);
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
      {
        EXPECT_NEAR(plane.positive[i][j], space.positive[i][j], 1e-16);
        for (unsigned int k = 0; k < 2; ++k)
          for (unsigned int l = 0; l < 2; ++l)
            EXPECT_NEAR(plane.positive_tangent[i][j][k][l],
                        space.positive_tangent[i][j][k][l],
                        1e-13);
      }
  }
}



namespace
{
  // (M4) as it is written down, with principal strains and directions
  // whatever their signs
  template <int dim>
  SplitStress<dim>
  by_principal_strains(const SymmetricTensor<2, dim> &strain)
  {
    const PrincipalStrains<dim> principal = principal_strains(strain);
    const auto                 &value     = principal.values;
    const auto       slope = [](const double a) { return a > 0. ? 1. : 0.; };
    SplitStress<dim> result;
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
      {
        const auto across = symmetrize(
          outer_product(principal.directions[a], principal.directions[b]));
        const double secant =
          value[a] == value[b]
            ? slope(value[a])
            : (std::max(value[a], 0.) - std::max(value[b], 0.)) /
                (value[a] - value[b]);
        result.positive_tangent +=
          2. * mu * secant * dealii::outer_product(across, across);
        if (a == b)
          result.positive += 2. * mu * std::max(value[a], 0.) * across;
      }
    return result;
  }

  // strains of one sign and of both, by the smallest and the largest one
  template <int dim>
  SymmetricTensor<2, dim>
  shifted(const SymmetricTensor<2, dim> &strain, const double shift)
  {
    return strain + shift * dealii::unit_symmetric_tensor<dim>();
  }
} // namespace



TYPED_TEST(SpectralSplitTest, WithoutDirectionsItIsTheSame)
{
  constexpr int            dim = TypeParam::value;
  const SpectralSplit<dim> split;
  unsigned int             n_tension = 0, n_compression = 0, n_both = 0;
  for (const auto &strain : random_strains<dim>(40))
    for (const double shift : {-0.04, -0.011, -0.003, 0., 0.003, 0.011, 0.04})
    {
      const auto here = shifted(strain, shift);
      SCOPED_TRACE(here);
      const auto   found    = split.evaluate(here, mu);
      const auto   expected = by_principal_strains(here);
      const double largest  = eigenvalues(here)[0];
      const double smallest = eigenvalues(here)[dim - 1];
      EXPECT_LT((found.positive - expected.positive).norm(), 1e-15);
      EXPECT_LT((found.positive_tangent - expected.positive_tangent).norm(),
                1e-13);
      EXPECT_EQ(split.tangent_regime(here),
                smallest > 0. ? 1 : (largest < 0. ? 0 : -1));
      n_tension += smallest > 0.;
      n_compression += largest < 0.;
      n_both += smallest < 0. && largest > 0.;
    }
  EXPECT_GT(std::min({n_tension, n_compression, n_both}), 30u);
}



// On both sides of a principal strain of 0, as near as doubles get: the stress
// is continuous, and a regime other than -1 promises the tangent of one sign.
TYPED_TEST(SpectralSplitTest, NearAVanishingStrainBothWaysAgree)
{
  constexpr int            dim = TypeParam::value;
  const SpectralSplit<dim> split;
  const auto               identity = 2. * mu * dealii::identity_tensor<dim>();
  for (const double other : {0.01, -0.01})
    for (const double size : {0., 1e-30, 1e-20, 1e-17, 1e-14, 1e-12, 1e-8})
      for (const double sign : {-1., 1.})
      {
        std::array<double, dim> entries;
        entries.fill(other);
        entries[dim - 1]  = sign * size;
        const auto strain = rotated(diagonal<dim>(entries));
        SCOPED_TRACE(strain);
        const auto found = split.evaluate(strain, mu);
        EXPECT_LT(
          (found.positive - by_principal_strains(strain).positive).norm(),
          1e-15);
        EXPECT_LT((found.positive + found.negative - 2. * mu * strain).norm(),
                  1e-16);
        const int regime = split.tangent_regime(strain);
        if (regime >= 0)
        {
          EXPECT_EQ(regime, other > 0. ? 1 : 0);
          EXPECT_EQ((found.positive_tangent - regime * identity).norm(), 0.);
        }
        if (size == 1e-8) // far from rounding
        {
          EXPECT_EQ(regime, sign * other < 0. ? -1 : (other > 0. ? 1 : 0));
        }
      }
}



// Without angles: all around Mohr's circle, and as near to its axis as can be.
TEST(SpectralSplit, DirectionsInThePlaneAreExact)
{
  std::vector<std::array<double, 2>> points{{{1., 0.}},
                                            {{-1., 0.}},
                                            {{0., 1.}},
                                            {{0., -1.}},
                                            {{-1., 1e-9}},
                                            {{-1., -1e-9}},
                                            {{-1., 1e-20}},
                                            {{1., 1e-20}},
                                            {{1e-12, 1.}},
                                            {{-1e-12, 1.}}};
  for (unsigned int i = 0; i < 48; ++i)
  {
    const double angle = 2. * dealii::numbers::PI * i / 48;
    points.push_back({{std::cos(angle), std::sin(angle)}});
  }
  for (const auto &[difference, shear] : points)
  {
    SymmetricTensor<2, 2> strain;
    strain[0][0]         = 0.01 * (0.3 + difference);
    strain[1][1]         = 0.01 * (0.3 - difference);
    strain[0][1]         = 0.01 * shear;
    const auto principal = principal_strains(strain);
    SCOPED_TRACE(strain);
    for (unsigned int a = 0; a < 2; ++a)
    {
      EXPECT_NEAR(principal.directions[a].norm(), 1., 1e-15);
      EXPECT_LT((strain * principal.directions[a] -
                 principal.values[a] * principal.directions[a])
                  .norm(),
                1e-17);
    }
  }
}
