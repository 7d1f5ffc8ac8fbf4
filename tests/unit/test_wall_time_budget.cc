// SPDX-License-Identifier: GPL-2.0-or-later
#include <simulation/wall_time_budget.h>

#include <gtest/gtest.h>

using namespace MixedCracks;

TEST(WallTimeBudget, WithoutALimitTimeIsNeverOver)
{
  WallTimeBudget budget(0.);
  budget.note_step(10.);
  EXPECT_FALSE(budget.is_over(1e9));
  EXPECT_FALSE(budget.is_over_for_a_step(1e9));
}



TEST(WallTimeBudget, TheLongestStepAndCheckpointMustFitIntoTheRest)
{
  WallTimeBudget budget(100.);
  EXPECT_FALSE(budget.is_over_for_a_step(99.)) << "nothing is known yet";
  EXPECT_TRUE(budget.is_over_for_a_step(101.));
  budget.note_checkpoint(3.);
  budget.note_step(20.);
  budget.note_step(5.); // the longest counts
  EXPECT_FALSE(budget.is_over_for_a_step(76.));
  EXPECT_TRUE(budget.is_over_for_a_step(78.));
}



TEST(WallTimeBudget, AStepIsGivenUpWhenCheckpointAndLongestCallJustFit)
{
  WallTimeBudget budget(100.);
  budget.note_step(20.);
  budget.note_checkpoint(3.);
  budget.note_call(4.);
  budget.note_call(1.);
  EXPECT_FALSE(budget.is_over(92.));
  EXPECT_TRUE(budget.is_over(94.));
  // a call is part of a step, not added to it
  EXPECT_FALSE(budget.is_over_for_a_step(76.));
}



TEST(WallTimeBudget, ACheckpointNotWrittenYetCountsAsAStep)
{
  WallTimeBudget budget(100.);
  budget.note_step(20.);
  EXPECT_TRUE(budget.is_over_for_a_step(61.));
  EXPECT_FALSE(budget.is_over_for_a_step(59.));
  budget.note_checkpoint(1.);
  EXPECT_FALSE(budget.is_over_for_a_step(61.));
}
