// SPDX-License-Identifier: GPL-2.0-or-later
// Load steps: halving, growth, the two floors and the ends.
#include <base/errors.h>

#include <steps/load_control.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;

namespace
{
  using Verdict = LoadControl::Verdict;

  LoadParameters
  parameters()
  {
    LoadParameters result;
    result.end_time                   = 10.;
    result.first_step                 = 0.5;
    result.largest_step               = 1.;
    result.onset_step                 = 0.1;
    result.smallest_step              = 0.01;
    result.largest_phase_field_change = 0.3;
    return result;
  }

  double
  time_reached(const LoadControl &control)
  {
    return control.target_time() - control.step();
  }
} // namespace



TEST(LoadControl, GrowsAfterEasyStepsUpToTheLargest)
{
  LoadControl control(parameters());
  EXPECT_DOUBLE_EQ(control.target_time(), 0.5);
  EXPECT_EQ(control.judge(true, 0.01), Verdict::accept);
  EXPECT_DOUBLE_EQ(control.step(), 1.);
  EXPECT_EQ(control.judge(true, 0.01), Verdict::accept);
  EXPECT_DOUBLE_EQ(control.step(), 1.);
  EXPECT_DOUBLE_EQ(time_reached(control), 1.5);
  EXPECT_EQ(control.n_rejected(), 0u);
}



TEST(LoadControl, KeepsTheStepWhenItWasNotEasy)
{
  LoadControl control(parameters());
  EXPECT_EQ(control.judge(true, 0.29), Verdict::accept);
  EXPECT_DOUBLE_EQ(control.step(), 0.5);
}



TEST(LoadControl, HalvesUnderLargeChangesDownToTheOnsetStep)
{
  LoadControl control(parameters());
  for (const double step : {0.25, 0.125, 0.1})
  {
    EXPECT_DOUBLE_EQ(control.phase_field_bound(), 0.3);
    EXPECT_EQ(control.judge(true, 0.9), Verdict::repeat);
    EXPECT_DOUBLE_EQ(control.step(), step);
    EXPECT_DOUBLE_EQ(time_reached(control), 0.);
  }
  // a running crack is accepted now
  EXPECT_TRUE(std::isinf(control.phase_field_bound()));
  EXPECT_EQ(control.judge(true, 0.9), Verdict::accept);
  EXPECT_DOUBLE_EQ(control.step(), 0.1);
  EXPECT_DOUBLE_EQ(time_reached(control), 0.1);
  EXPECT_EQ(control.n_rejected(), 3u);
}



TEST(LoadControl, HalvesFailuresDownToTheSmallestStepThenGivesUp)
{
  LoadControl  control(parameters());
  unsigned int n_repeats = 0;
  double       step      = control.step();
  while (control.judge(false, 0.) == Verdict::repeat)
  {
    ++n_repeats;
    EXPECT_DOUBLE_EQ(control.step(), std::max(0.5 * step, 0.01));
    step = control.step();
    ASSERT_LT(n_repeats, 20u);
  }
  EXPECT_DOUBLE_EQ(step, 0.01);
  EXPECT_EQ(n_repeats, 6u); // 0.25 ... 0.015625, 0.01
  EXPECT_EQ(control.n_rejected(), 7u);
  EXPECT_DOUBLE_EQ(time_reached(control), 0.);
}



TEST(LoadControl, RecoversAfterFailures)
{
  LoadControl control(parameters());
  for (unsigned int i = 0; i < 5; ++i)
    EXPECT_EQ(control.judge(false, 0.), Verdict::repeat);
  EXPECT_DOUBLE_EQ(control.step(), 0.5 / 32.);
  for (const double step : {1. / 32., 1. / 16., 1. / 8., 0.25, 0.5, 1., 1.})
  {
    EXPECT_EQ(control.judge(true, 0.), Verdict::accept);
    EXPECT_DOUBLE_EQ(control.step(), step);
  }
}



TEST(LoadControl, GrowsOnlyAfterTwoMoreEasyStepsWhenChangesWereLarge)
{
  LoadControl control(parameters());
  EXPECT_EQ(control.judge(true, 0.9), Verdict::repeat);
  for (const double step : {0.25, 0.25, 0.5, 1.})
  {
    EXPECT_EQ(control.judge(true, 0.01), Verdict::accept);
    EXPECT_DOUBLE_EQ(control.step(), step);
  }
}



TEST(LoadControl, TreatsANumberThatIsNoneAsTooLargeAChange)
{
  LoadControl control(parameters());
  EXPECT_EQ(control.judge(true, std::nan("")), Verdict::repeat);
}



TEST(LoadControl, KeepsFixedStepsWithoutABound)
{
  LoadParameters fixed             = parameters();
  fixed.largest_phase_field_change = 0.;
  fixed.first_step                 = 1.;
  fixed.largest_step               = 2.; // not made use of
  LoadControl control(fixed);
  for (unsigned int i = 1; i <= 10; ++i)
  {
    EXPECT_TRUE(std::isinf(control.phase_field_bound()));
    EXPECT_DOUBLE_EQ(control.step(), 1.);
    EXPECT_EQ(control.judge(true, 1.), Verdict::accept);
    EXPECT_EQ(control.at_end(), i == 10);
  }
}



TEST(LoadControl, HitsTheEndTimeExactly)
{
  // 0.3 + 0.6 + ... does not divide 10, 0.1 is not exact in binary
  for (const double largest : {0.1, 0.3, 0.7, 3., 100.})
  {
    LoadParameters steps = parameters();
    steps.largest_step   = largest;
    steps.first_step     = 0.1;
    steps.onset_step     = 0.1;
    LoadControl  control(steps);
    unsigned int n           = 0;
    double       last_target = 0.;
    while (!control.at_end())
    {
      last_target = control.target_time();
      EXPECT_GT(control.step(), 0.);
      EXPECT_LE(control.step(), largest + steps.smallest_step);
      EXPECT_EQ(control.judge(true, 0.), Verdict::accept);
      ASSERT_LT(++n, 1000u);
    }
    EXPECT_NEAR(last_target, 10., 1e-12) << "largest step " << largest;
    EXPECT_GE(n, std::floor(10. / largest));
  }
}



TEST(LoadControl, TakesNoStepBeyondTheEnd)
{
  LoadParameters steps = parameters();
  steps.end_time       = 0.2;
  LoadControl control(steps);
  EXPECT_DOUBLE_EQ(control.target_time(), 0.2);
  EXPECT_EQ(control.judge(true, 0.), Verdict::accept);
  EXPECT_TRUE(control.at_end());
}



TEST(LoadControl, StopsWhenTheForceHasFallen)
{
  LoadParameters watching = parameters();
  watching.stop_fraction  = 0.15;
  LoadControl control(watching);
  for (const double force : {0., 50., 100., 40., 15.01})
    EXPECT_FALSE(control.has_fallen(force)) << force;
  EXPECT_DOUBLE_EQ(control.peak_force(), 100.);
  EXPECT_DOUBLE_EQ(control.fallen_force(), 15.);
  EXPECT_DOUBLE_EQ(control.force_when_apart(), 15.);
  EXPECT_TRUE(control.has_fallen(14.99));

  LoadControl blind(parameters());
  EXPECT_FALSE(blind.has_fallen(100.));
  EXPECT_FALSE(blind.has_fallen(0.));
  EXPECT_EQ(blind.fallen_force(), 0.);
  EXPECT_EQ(blind.force_when_apart(), 0.);
}



// A run that ends with separation does not end with a force that is low.
TEST(LoadControl, AForceTellsABodyThatIsApartWhateverEndsTheRun)
{
  LoadParameters cut_only      = parameters();
  cut_only.stop_when_separated = true;
  for (const double fraction : {0., 0.02})
  {
    cut_only.stop_fraction = fraction;
    LoadControl control(cut_only);
    EXPECT_FALSE(control.has_fallen(100.));
    EXPECT_FALSE(control.has_fallen(8.));
    EXPECT_DOUBLE_EQ(control.force_when_apart(), 15.);
    EXPECT_DOUBLE_EQ(control.fallen_force(), 100. * fraction);
  }
}



TEST(LoadControl, ContinuesFromACheckpoint)
{
  LoadControl control(parameters());
  control.restore(4., 0.25, 80., 1);
  EXPECT_DOUBLE_EQ(control.target_time(), 4.25);
  EXPECT_DOUBLE_EQ(control.peak_force(), 80.);
  EXPECT_EQ(control.steps_to_wait(), 1u);
  control.restore(9.9, 0.25, 80., 0);
  EXPECT_DOUBLE_EQ(control.target_time(), 10.);
}



TEST(LoadControl, KeepsTheStepThatTheEndTimeHasCut)
{
  LoadControl control(parameters());
  control.restore(9.6, 0.8, 80., 0);
  EXPECT_DOUBLE_EQ(control.step(), 10. - 9.6);
  EXPECT_DOUBLE_EQ(control.natural_step(), 0.8);
  EXPECT_EQ(control.judge(true, 0.2), Verdict::accept);
  EXPECT_TRUE(control.at_end());
  EXPECT_DOUBLE_EQ(control.natural_step(), 0.8);

  // the end time is put off
  LoadParameters later = parameters();
  later.end_time       = 20.;
  LoadControl extended(later);
  extended.restore(10., control.natural_step(), 80., 0);
  EXPECT_FALSE(extended.at_end());
  EXPECT_DOUBLE_EQ(extended.step(), 0.8);

  // what was refused was too long, with an end time or without
  control.restore(9.6, 0.8, 80., 0);
  EXPECT_EQ(control.judge(true, 0.9), Verdict::repeat);
  EXPECT_NEAR(control.natural_step(), 0.2, 1e-12);
}



TEST(LoadControl, ContinuesWithTheStepsThatAreAllowedNow)
{
  LoadParameters shorter = parameters();
  shorter.largest_step   = 0.5;
  LoadControl control(shorter);
  control.restore(4., 0.9, 80., 0);
  EXPECT_DOUBLE_EQ(control.step(), 0.5);
  control.restore(4., 1e-6, 80., 0);
  EXPECT_DOUBLE_EQ(control.step(), shorter.smallest_step);

  // without a bound on the phase field the first step is the step
  shorter.largest_phase_field_change = 0.;
  shorter.first_step                 = 0.25;
  LoadControl fixed(shorter);
  fixed.restore(4., 0.9, 80., 0);
  EXPECT_DOUBLE_EQ(fixed.step(), 0.25);
}



TEST(LoadControl, RefusesStepsInTheWrongOrder)
{
  EXPECT_NO_THROW(parameters().check());
  std::vector<LoadParameters> wrong(5, parameters());
  wrong[0].smallest_step = 0.2;
  wrong[1].onset_step    = 2.;
  wrong[2].first_step    = 2.;
  wrong[3].first_step    = 0.001;
  wrong[4].stop_fraction = 1.;
  for (const LoadParameters &each : wrong)
    EXPECT_THROW(each.check(), InputError);
}



TEST(LoadControl, EndsAtTheOnsetWhenThatIsTheQuestion)
{
  LoadParameters values = parameters();
  values.stop_at_onset  = true;
  LoadControl control(values);
  EXPECT_EQ(control.judge(true, 0.01), Verdict::accept);
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_EQ(control.judge(true, 0.9), Verdict::repeat);
  EXPECT_DOUBLE_EQ(control.step(), 0.1);
  EXPECT_DOUBLE_EQ(control.phase_field_bound(), 0.3);
  EXPECT_EQ(control.judge(true, 0.2), Verdict::accept);
  EXPECT_EQ(control.judge(true, 0.4), Verdict::onset);
  EXPECT_DOUBLE_EQ(time_reached(control), 0.6);
}



TEST(LoadControl, NoOnsetWithoutABound)
{
  LoadParameters values             = parameters();
  values.stop_at_onset              = true;
  values.largest_phase_field_change = 0.;
  EXPECT_THROW(values.check(), InputError);
}
