// SPDX-License-Identifier: GPL-2.0-or-later
// Which steps leave something over in the energy balance, from rows by hand.
#include <gtest/gtest.h>

#include <output/energy_balance.h>

using namespace MixedCracks;

namespace
{
  StatisticsRow
  row(const unsigned int step,
      const double       work,
      const double       elastic,
      const double       crack)
  {
    StatisticsRow result;
    result["step"]           = step;
    result["external_work"]  = work;
    result["elastic_energy"] = elastic;
    result["crack_energy"]   = crack;
    return result;
  }

  // balanced, then 4 mJ of 20 too many, then 1 of 21 too few
  const std::vector<StatisticsRow> rows = {row(0, 0., 0., 2.),
                                           row(1, 10., 9., 3.),
                                           row(2, 20., 10., 8.),
                                           row(3, 21., 12., 8.)};
} // namespace



TEST(EnergyBalance, IsThatOfOneStep)
{
  const StepImbalance balanced = imbalance(rows[0], rows[1]);
  EXPECT_DOUBLE_EQ(balanced.energy, 0.);
  EXPECT_FALSE(balanced.exceeds(1e-12));
  const StepImbalance off = imbalance(rows[1], rows[2]);
  EXPECT_DOUBLE_EQ(off.energy, 4.);
  EXPECT_DOUBLE_EQ(off.scale, 20.);
  EXPECT_FALSE(off.is_of_stored_energy);
  EXPECT_TRUE(off.exceeds(0.19));
  EXPECT_FALSE(off.exceeds(0.21));
}



// under loads that are there from the start
TEST(EnergyBalance, IsMeasuredWithTheStoredEnergyWhereNoWorkWasDone)
{
  const StepImbalance step = imbalance(row(0, 0., 9., 0.), row(1, 0., 8., 0.5));
  EXPECT_DOUBLE_EQ(step.energy, 0.5);
  EXPECT_DOUBLE_EQ(step.scale, 8.);
  EXPECT_TRUE(step.is_of_stored_energy);
}



TEST(EnergyBalance, WordsCountTheStepsOfTheWholeRun)
{
  EXPECT_EQ(imbalance_in_words(rows, {0.5}), "");
  EXPECT_EQ(imbalance_in_words(rows, {0.}), ""); // off
  EXPECT_EQ(imbalance_in_words({rows[0]}, {0.01}), "");
  const std::string one = imbalance_in_words(rows, {0.1});
  EXPECT_NE(one.find("step 2 leaves"), std::string::npos) << one;
  EXPECT_NE(one.find(" 4 mJ"), std::string::npos) << one;
  const std::string two = imbalance_in_words(rows, {0.01});
  EXPECT_NE(two.find("2 steps leave"), std::string::npos) << two;
  EXPECT_NE(two.find("most in step 2: 4 mJ"), std::string::npos) << two;
  EXPECT_NE(two.find("3 mJ in all"), std::string::npos) << two;
}



// a crack that runs through at once has energy to spare, and no place for it
TEST(EnergyBalance, WordsLeaveOutStepsInWhichACrackRan)
{
  std::vector<StatisticsRow> torn   = rows;
  torn[2]["max_phase_field_change"] = 0.95;
  EXPECT_EQ(imbalance_in_words(torn, {0.1, 0.3}), "");
  EXPECT_NE(imbalance_in_words(torn, {0.1}), "");
  // energy that is missing is not explained by that
  torn[3]["max_phase_field_change"] = 0.95;
  const std::string less            = imbalance_in_words(torn, {0.01, 0.3});
  EXPECT_NE(less.find("step 3 leaves"), std::string::npos) << less;
}



// a body that moves as a whole has the energy of rounding errors
TEST(EnergyBalance, WordsLeaveOutWhatIsRounding)
{
  ImbalanceRule rule{0.1};
  rule.least_energy = 20.5;
  EXPECT_EQ(imbalance_in_words({rows[0], rows[1], rows[2]}, rule), "");
  rule.least_energy = 19.5;
  EXPECT_NE(imbalance_in_words({rows[0], rows[1], rows[2]}, rule), "");
}
