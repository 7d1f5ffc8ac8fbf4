// SPDX-License-Identifier: GPL-2.0-or-later
// When an iteration is over that moves its unknowns by little, and for long.
#include <steps/rest.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace MixedCracks;

namespace
{
  constexpr double tolerance = 5e-5;

  // the first of at most @p most iterations that is at rest, after the energy
  // @p energy(x), x plain iterations after the start, in steps of @p factor
  unsigned int
  first_at_rest(const std::function<double(double)> &energy,
                const double                         factor,
                const unsigned int                   most = 400)
  {
    RestWatch watch;
    for (unsigned int i = 0; i < most; ++i)
    {
      watch.add(energy(i * factor), i == 0 ? 0. : factor);
      if (watch.is_at_rest(tolerance))
        return i;
    }
    return most;
  }
} // namespace



TEST(RestWatch, ACreepingTipIsNotAtRestWhateverTheStep)
{
  const auto creeping = [](const double x) { return 2. - 2e-4 * x; };
  for (const double factor : {1., 1.5, 5., 20.})
    EXPECT_EQ(first_at_rest(creeping, factor), 400u) << factor;
}



TEST(RestWatch, WhatIsLeftToATipThatComesToRestIsSmall)
{
  // stable growth: the energy to come falls by 0.5 % in a plain iteration
  const auto energy = [](const double x) {
    return 1. + 0.5 * std::exp(-0.005 * x);
  };
  for (const double factor : {1., 1.5, 5.})
  {
    const unsigned int i = first_at_rest(energy, factor, 4000);
    EXPECT_LT(energy(i * factor) - 1., 0.0105) << factor;
    EXPECT_GT(energy(i * factor) - 1., 0.005) << factor;
  }
}



TEST(RestWatch, NodesThatBreakBesideACrackDoNotCount)
{
  const auto energy = [](const double x) {
    return 1. + (x < 20. ? 0.02 * (20. - x) : 0.) + 1e-5 * std::sin(3. * x);
  };
  const unsigned int i = first_at_rest(energy, 1.5);
  EXPECT_GE(1.5 * i, 20.);
  EXPECT_LE(1.5 * i, 30.);
}



TEST(RestWatch, ABodyThatCarriesNextToNothingIsMeasuredByWhatItCarried)
{
  RestWatch watch;
  watch.add(100., 0.);
  watch.add(0.1, 1.5);
  for (const double value : {0.1005, 0.101, 0.1015, 0.102})
  {
    EXPECT_FALSE(watch.is_at_rest(tolerance));
    watch.add(value, 1.5);
  }
  watch.add(0.1025, 1.5);
  EXPECT_TRUE(watch.is_at_rest(tolerance));
  // a step that restarts does not know of it
  watch.restart();
  EXPECT_FALSE(watch.is_at_rest(tolerance));
}



TEST(RestWatch, ABetterValueOfTheSameIterationReplacesTheLast)
{
  RestWatch watch;
  for (unsigned int i = 0; i < 5; ++i)
    watch.add(1., i);
  for (unsigned int i = 0; i < 10; ++i)
    watch.add(1., 0.);
  EXPECT_FALSE(watch.is_at_rest(tolerance));
  watch.add(1., 1.);
  EXPECT_TRUE(watch.is_at_rest(tolerance));
  watch.add(1.1, 0.);
  EXPECT_FALSE(watch.is_at_rest(tolerance));
}
