// SPDX-License-Identifier: GPL-2.0-or-later
// Where damage was seen first.
#include <cracks/damage_origins.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using dealii::Point;

namespace
{
  // a notch from (0, 0) to (1, 0), nodes 0.1 apart
  std::vector<Point<3>>
  notch()
  {
    std::vector<Point<3>> nodes;
    for (unsigned int i = 0; i <= 10; ++i)
      nodes.push_back({0.1 * i, 0., 0.});
    return nodes;
  }

  DamageOrigins
  notched()
  {
    return origins_at_start(0.9, notch());
  }
} // namespace



TEST(DamageOrigins, TheNotchItselfIsNone)
{
  DamageOrigins origins = notched();
  EXPECT_TRUE(origins.nuclei.empty());
  // its profile settles
  add_broken_nodes({{1.1, 0., 0.}, {0.5, 0.1, 0.}}, origins);
  EXPECT_TRUE(origins.nuclei.empty());
}



TEST(DamageOrigins, GrowthOfTheNotchStartsAtItsTip)
{
  DamageOrigins origins = notched();
  for (unsigned int i = 1; i < 40; ++i)
    add_broken_nodes({{1. + 0.1 * i, 0.02 * i, 0.}}, origins);
  ASSERT_EQ(origins.nuclei.size(), 1u);
  EXPECT_LT(origins.nuclei[0].distance(Point<3>(1., 0., 0.)), 1e-12);
}



TEST(DamageOrigins, DamageElsewhereIsAnotherOneInTheOrderOfTime)
{
  DamageOrigins origins = notched();
  add_broken_nodes({{8., 3., 0.}}, origins);
  add_broken_nodes({{8.1, 3., 0.}, {1.5, 0., 0.}}, origins);
  add_broken_nodes({{8.2, 3., 0.}, {1.9, 0., 0.}, {8.9, 3.3, 0.}}, origins);
  ASSERT_EQ(origins.nuclei.size(), 2u);
  EXPECT_LT(origins.nuclei[0].distance(Point<3>(8., 3., 0.)), 1e-12);
  EXPECT_LT(origins.nuclei[1].distance(Point<3>(1., 0., 0.)), 1e-12);
}



TEST(DamageOrigins, ACopyTakesARejectedStepBack)
{
  DamageOrigins       origins = notched();
  const DamageOrigins before  = origins;
  add_broken_nodes({{5., 5., 0.}}, origins);
  EXPECT_EQ(origins.nuclei.size(), 1u);
  EXPECT_TRUE(is_known({5., 5., 0.}, origins));
  origins = before;
  EXPECT_TRUE(origins.nuclei.empty());
  EXPECT_FALSE(is_known({5., 5., 0.}, origins));
  add_broken_nodes({{5., 5., 0.}}, origins);
  EXPECT_EQ(origins.nuclei.size(), 1u);
}
