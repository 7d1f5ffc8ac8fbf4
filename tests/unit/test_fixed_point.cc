// SPDX-License-Identifier: GPL-2.0-or-later
// The acceleration of fixed-point iterations on maps whose solutions are
// known.
#include "small_systems.h"

#include <steps/fixed_point.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  using Map = std::function<double(unsigned int i, double x)>;

  const FixedPointOptions accelerated{1., 20., 5};
  constexpr unsigned int  n_unknowns = 6;

  LinearAlgebra::Vector
  image_of(const Map &map, const LinearAlgebra::Vector &x)
  {
    LinearAlgebra::Vector result(x);
    for (const auto i : x.locally_owned_elements())
      result(i) = map(i, x(i));
    result.compress(dealii::VectorOperation::insert);
    return result;
  }

  // x = g(x) from @p x on; returns the number of evaluations of g until the
  // difference is below 1e-8, at most @p most
  unsigned int
  iterations(const FixedPointOptions &options,
             const Map               &map,
             LinearAlgebra::Vector   &x,
             const unsigned int       most = 1000)
  {
    FixedPointAcceleration acceleration(options);
    for (unsigned int k = 1; k <= most; ++k)
    {
      const LinearAlgebra::Vector image = image_of(map, x);
      LinearAlgebra::Vector       difference(image);
      difference.add(-1., x);
      if (difference.linfty_norm() < 1e-8)
        return k;
      x = acceleration.next(x, image);
    }
    return most + 1;
  }

  // contracts to i by 0.95, 0.9, 0.5, ... in its components
  double
  slow(const unsigned int i, const double x)
  {
    const double rates[n_unknowns] = {0.95, 0.9, 0.5, 0.95, 0.3, 0.};
    return i + rates[i] * (x - i);
  }

  LinearAlgebra::Vector
  start()
  {
    return distributed(std::vector<double>(n_unknowns, 10.));
  }
} // namespace



TEST(FixedPoint, ConvergesToTheSolution)
{
  for (const FixedPointOptions &options : {FixedPointOptions{1., 1., 0},
                                           FixedPointOptions{1.5, 1.5, 0},
                                           FixedPointOptions{1.5, 20., 5},
                                           accelerated})
  {
    auto x = start();
    EXPECT_LE(iterations(options, slow, x), 1000u);
    const std::vector<double> found = gathered(x);
    for (unsigned int i = 0; i < n_unknowns; ++i)
      EXPECT_NEAR(found[i], i, 1e-6);
  }
}



TEST(FixedPoint, IsMuchFasterThanPlainIterationWhereThatIsSlow)
{
  auto               x = start(), y = start();
  const unsigned int plain = iterations({1., 1., 0}, slow, x);
  const unsigned int fast  = iterations(accelerated, slow, y);
  EXPECT_GT(plain, 300u);
  EXPECT_LT(fast, 20u);
}



// g pushes away from 0, to 1 or to -1: Anderson's method alone would settle at
// 0, where x = g(x) too
TEST(FixedPoint, LeavesAnUnstableState)
{
  const auto repelling = [](const unsigned int, const double x) {
    return x + 0.1 * (x - x * x * x);
  };
  for (const double begin : {1e-4, -1e-4, 0.3})
  {
    auto x = distributed(std::vector<double>(n_unknowns, begin));
    EXPECT_LT(iterations(accelerated, repelling, x), 60u);
    for (const double found : gathered(x))
      EXPECT_NEAR(found, begin > 0. ? 1. : -1., 1e-6);
  }
}



TEST(FixedPoint, SaysWhenItRunsAway)
{
  const auto repelling = [](const unsigned int, const double x) {
    return x + 0.1 * x;
  };
  const auto attracting = [](const unsigned int, const double x) {
    return 0.9 * x;
  };
  for (const bool away : {true, false})
  {
    FixedPointAcceleration acceleration(accelerated);
    auto x    = distributed(std::vector<double>(n_unknowns, 0.1));
    bool seen = false;
    for (unsigned int k = 0; k < 5; ++k)
    {
      const auto image =
        away ? image_of(repelling, x) : image_of(attracting, x);
      x    = acceleration.next(x, image);
      seen = seen || acceleration.runs_away();
    }
    EXPECT_EQ(seen, away);
    acceleration.restart();
    EXPECT_FALSE(acceleration.runs_away());
  }
}



// A front that moves by one unknown per iteration: steps have nothing to do
// with each other, and must not be made shorter than without acceleration
TEST(FixedPoint, DoesNotSlowDownAFront)
{
  constexpr unsigned int      n = 40;
  std::vector<double>         values(n, 1.);
  const std::function<void()> advance = [&values]() {
    for (double &value : values)
      if (value > 0.01)
      {
        value = 0.;
        return;
      }
  };
  unsigned int needed[2];
  for (const unsigned int depth : {0, 5})
  {
    values.assign(n, 1.);
    FixedPointAcceleration acceleration({1., 20., depth});
    auto                   x = distributed(values);
    unsigned int           k = 0;
    while (values.back() > 0.01 && k < 1000)
    {
      ++k;
      advance();
      x      = acceleration.next(x, distributed(values));
      values = gathered(x);
      for (double &value : values)
        value = std::min(1., std::max(0., value));
      x = distributed(values);
    }
    needed[depth > 0] = k;
  }
  EXPECT_LE(needed[1], needed[0]);
}



// With x + 1.5 (g(x) - x), differences from the solution grow by a quarter.
TEST(FixedPoint, SettlesWhereDifferencesTurnBack)
{
  const Map alternating = [](const unsigned int i, const double x) {
    return i - 0.5 * (x - i);
  };
  auto x = start();
  EXPECT_LE(iterations({1.5, 20., 5}, alternating, x), 40u);
  const std::vector<double> found = gathered(x);
  for (unsigned int i = 0; i < n_unknowns; ++i)
    EXPECT_NEAR(found[i], i, 1e-6);
}



TEST(FixedPoint, ForgetsWhenItIsRestarted)
{
  FixedPointAcceleration acceleration(accelerated);
  auto                   x     = start();
  const auto             first = acceleration.next(x, image_of(slow, x));
  acceleration.next(first, image_of(slow, first));
  acceleration.restart();
  EXPECT_EQ(acceleration.factor(), 0.);
  const auto again = acceleration.next(x, image_of(slow, x));
  EXPECT_EQ(gathered(first), gathered(again));
}
