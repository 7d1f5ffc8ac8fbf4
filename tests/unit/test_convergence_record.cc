// SPDX-License-Identifier: GPL-2.0-or-later
// How far a solution has come after each iteration.
#include <gtest/gtest.h>

#include <solvers/convergence_record.h>

namespace MixedCracks
{
  TEST(ConvergenceRecord, WithoutOneAnythingIsBehind)
  {
    const ConvergenceRecord record;
    EXPECT_EQ(record.digits(), 0.);
    EXPECT_EQ(record.digits_after(0), HUGE_VAL);
    EXPECT_EQ(record.digits_after(3), HUGE_VAL);
  }

  TEST(ConvergenceRecord, KnowsWhatWasReachedAndGoesOnAtTheMeanRate)
  {
    ConvergenceRecord record;
    for (const double digits : {0.1, 0.5, 0.5, 2.})
      record.add(digits);
    EXPECT_EQ(record.digits(), 2.);
    EXPECT_EQ(record.digits_after(0), 0.);
    EXPECT_EQ(record.digits_after(1), 0.1);
    EXPECT_EQ(record.digits_after(3), 0.5);
    EXPECT_EQ(record.digits_after(4), 2.);
    EXPECT_DOUBLE_EQ(record.digits_after(16), 8.);
  }

  // conjugate gradients let the residual grow in between, at first, too
  TEST(ConvergenceRecord, AResidualThatGrowsHasStillBeenSmaller)
  {
    ConvergenceRecord record;
    for (const double digits : {-0.3, 1., 0.5, 3.})
      record.add(digits);
    EXPECT_EQ(record.digits_after(1), 0.);
    EXPECT_EQ(record.digits_after(3), 1.);
    EXPECT_EQ(record.digits(), 3.);
  }

  // with a plateau, too: it is compared with earlier iterations
  TEST(ConvergenceRecord, TheSameHistoryIsNeverBehind)
  {
    ConvergenceRecord record, again;
    for (const double digits : {0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.3, 2.})
      record.add(digits);
    for (unsigned int i = 1; i < 10; ++i)
    {
      again.add(record.digits_after(i));
      EXPECT_GE(again.digits(), record.digits_after(i / 1.3));
    }
  }
} // namespace MixedCracks
