// SPDX-License-Identifier: GPL-2.0-or-later
// Iterations that a reduction of the residual has cost.
#include <gtest/gtest.h>

#include <solvers/convergence_record.h>

namespace MixedCracks
{
  TEST(ConvergenceRecord, WithoutOneNothingIsTooSlow)
  {
    const ConvergenceRecord record;
    EXPECT_TRUE(record.is_empty());
    EXPECT_EQ(record.iterations_for(0.), HUGE_VAL);
    EXPECT_EQ(record.iterations_for(3.), HUGE_VAL);
  }

  TEST(ConvergenceRecord, CountsTheFirstIterationThatReachedIt)
  {
    ConvergenceRecord record;
    for (const double digits : {0.1, 0.5, 0.5, 2.})
      record.add(digits);
    EXPECT_EQ(record.iterations_for(0.), 1.);
    EXPECT_EQ(record.iterations_for(0.1), 1.);
    EXPECT_EQ(record.iterations_for(0.11), 2.);
    EXPECT_EQ(record.iterations_for(0.5), 2.);
    EXPECT_EQ(record.iterations_for(1.9), 4.);
    // 2 digits in 4 iterations
    EXPECT_DOUBLE_EQ(record.iterations_for(8.), 16.);
    record.clear();
    EXPECT_TRUE(record.is_empty());
  }

  // conjugate gradients let the residual grow in between
  TEST(ConvergenceRecord, AResidualThatGrowsHasStillBeenSmaller)
  {
    ConvergenceRecord record;
    for (const double digits : {1., 0.5, 3.})
      record.add(digits);
    EXPECT_EQ(record.iterations_for(0.7), 1.);
    EXPECT_EQ(record.iterations_for(2.), 3.);
  }

  TEST(ConvergenceRecord, WhatNeverFellIsNoMeasure)
  {
    ConvergenceRecord record;
    record.add(0.);
    EXPECT_EQ(record.iterations_for(1.), HUGE_VAL);
  }
} // namespace MixedCracks
