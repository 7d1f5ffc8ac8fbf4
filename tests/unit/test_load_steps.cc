// SPDX-License-Identifier: GPL-2.0-or-later
// Load steps that follow from each other, their contradictions, and a schedule.
#include <base/errors.h>

#include <steps/load_control.h>

#include <gtest/gtest.h>

#include <functional>

using namespace MixedCracks;

namespace
{
  using Verdict = LoadControl::Verdict;

  GivenSteps
  nothing_given(const double end_time)
  {
    return {end_time, 0., 0., 0., 0., {}};
  }

  // times of the steps that a run makes in which every step is easy
  std::vector<double>
  easy_times(const LoadParameters &parameters)
  {
    LoadControl         control(parameters);
    std::vector<double> times;
    while (!control.at_end() && times.size() < 1000)
    {
      times.push_back(control.target_time());
      EXPECT_EQ(control.judge(true, 0.), Verdict::accept);
    }
    return times;
  }

  // the longest and the shortest step that ends in (begin, end]
  std::pair<double, double>
  extreme_steps(const std::vector<double> &times,
                const double               begin,
                const double               end)
  {
    double longest = 0., shortest = 1e300, last = 0.;
    for (const double time : times)
    {
      if (time > begin * (1. + 1e-9) && time <= end * (1. + 1e-9))
      {
        longest  = std::max(longest, time - last);
        shortest = std::min(shortest, time - last);
      }
      last = time;
    }
    return {longest, shortest};
  }
} // namespace



TEST(LoadSteps, FollowFromTheEndTimeAlone)
{
  const LoadSteps steps(nothing_given(3.5e-3));
  EXPECT_DOUBLE_EQ(steps.largest, 3.5e-4);
  EXPECT_DOUBLE_EQ(steps.first, 3.5e-4);
  EXPECT_DOUBLE_EQ(steps.onset, 3.5e-5);
  EXPECT_DOUBLE_EQ(steps.smallest, 3.5e-7);
  LoadParameters parameters;
  parameters.end_time = 3.5e-3;
  EXPECT_NO_THROW(parameters.check());
}



TEST(LoadSteps, AreThoseThatWereConstantsForAnEndTimeOfOne)
{
  const LoadSteps steps = LoadParameters().steps();
  EXPECT_DOUBLE_EQ(steps.first, 0.1);
  EXPECT_DOUBLE_EQ(steps.largest, 0.1);
  EXPECT_DOUBLE_EQ(steps.onset, 0.01);
  EXPECT_DOUBLE_EQ(steps.smallest, 1e-4);
}



TEST(LoadSteps, DerivedOnesNeverContradictGivenOnes)
{
  for (const double given : {1e-7, 1e-3, 0.05, 0.5, 20.})
    for (unsigned int which = 0; which < 4; ++which)
    {
      GivenSteps values = nothing_given(1.);
      double    *all[]  = {
            &values.first, &values.largest, &values.onset, &values.smallest};
      *all[which] = given;
      const LoadSteps steps(values);
      EXPECT_TRUE(contradictions(values).empty());
      EXPECT_LE(steps.smallest, steps.onset) << given << ' ' << which;
      EXPECT_LE(steps.smallest, steps.first) << given << ' ' << which;
      EXPECT_LE(steps.onset, steps.largest) << given << ' ' << which;
      EXPECT_LE(steps.first, steps.largest) << given << ' ' << which;
      const double kept[] = {
        steps.first, steps.largest, steps.onset, steps.smallest};
      EXPECT_EQ(kept[which], given);
    }
}



TEST(LoadSteps, SayWhichAreDerived)
{
  GivenSteps values       = nothing_given(1.);
  values.onset            = 0.02;
  const std::string words = LoadSteps(values).in_words();
  EXPECT_NE(words.find("onset 0.02 s"), std::string::npos) << words;
  EXPECT_NE(words.find("derived: largest, first, smallest"), std::string::npos)
    << words;
}



TEST(LoadSteps, AllContradictionsAtOnce)
{
  LoadParameters wrong;
  wrong.largest_step  = 0.1;
  wrong.first_step    = 0.2;
  wrong.onset_step    = 0.3;
  wrong.smallest_step = 0.4;
  wrong.step_schedule = "0 : 0.5";
  try
  {
    wrong.check();
    FAIL();
  }
  catch (const InputError &error)
  {
    const std::string text = error.what();
    for (const char *const part :
         {"Smallest step: 0.4 s is larger than Load stepping/Onset step, 0.3",
          "Onset step: 0.3 s is larger than Load stepping/Largest step, 0.1",
          "Smallest step: 0.4 s is larger than Load stepping/First step, 0.2",
          "First step: 0.2 s is larger than Load stepping/Largest step, 0.1",
          "Step schedule at 0 s: 0.5 s is larger than"})
      EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  }
}



TEST(LoadSteps, RefuseSchedulesThatAreNone)
{
  for (const char *const text : {"0",
                                 "0:",
                                 "0:1:2",
                                 "0:0",
                                 "-1:1",
                                 "1:0.1, 1:0.2",
                                 "2:0.1, 1:0.2",
                                 "x:1"})
    EXPECT_THROW(parse_schedule(text, "Load stepping/Step schedule"),
                 InputError)
      << text;
  EXPECT_EQ(parse_schedule("0:1e-4, 0.005:1e-5", "").size(), 2u);
  EXPECT_EQ(parse_schedule("0 : 1e-4 ; 0.005 : 1e-5", "").size(), 2u);
  EXPECT_TRUE(parse_schedule("", "").empty());
}



TEST(LoadSteps, AScheduleWithoutABoundGivesTheSteps)
{
  LoadParameters parameters;
  parameters.end_time                   = 0.006;
  parameters.step_schedule              = "0:1e-4, 0.005:1e-5";
  parameters.largest_phase_field_change = 0.;
  ASSERT_NO_THROW(parameters.check());
  const std::vector<double> times = easy_times(parameters);
  ASSERT_EQ(times.size(), 150u);
  for (unsigned int i = 0; i < 50; ++i)
    EXPECT_NEAR(times[i], 1e-4 * (i + 1), 1e-13);
  EXPECT_DOUBLE_EQ(times[49], 0.005);
  for (unsigned int i = 0; i < 100; ++i)
    EXPECT_NEAR(times[50 + i], 0.005 + 1e-5 * (i + 1), 1e-13);
  // and longer again at once
  parameters.step_schedule = "0:1e-5, 0.001:1e-4";
  EXPECT_EQ(easy_times(parameters).size(), 150u);
}



TEST(LoadSteps, AScheduleBoundsGrowingSteps)
{
  LoadParameters parameters;
  parameters.end_time      = 1.;
  parameters.first_step    = 0.03;
  parameters.largest_step  = 0.2;
  parameters.step_schedule = "0.5:0.02, 0.7:0.1";
  ASSERT_NO_THROW(parameters.check());
  const std::vector<double> times = easy_times(parameters);
  EXPECT_NEAR(times.back(), 1., 1e-12);
  for (const double time : {0.5, 0.7})
    EXPECT_EQ(std::count(times.begin(), times.end(), time), 1) << time;
  EXPECT_LE(extreme_steps(times, 0., 0.5).first, 0.2 * (1. + 1e-9));
  EXPECT_GT(extreme_steps(times, 0., 0.5).first, 0.1);
  EXPECT_NEAR(extreme_steps(times, 0.5, 0.7).first, 0.02, 1e-12);
  EXPECT_NEAR(extreme_steps(times, 0.7, 1.).first, 0.1, 1e-12);
  // no crumbs before a scheduled time
  EXPECT_GE(extreme_steps(times, 0., 0.7).second, 0.0099);
}



TEST(LoadSteps, AScheduleHoldsAfterAResume)
{
  LoadParameters parameters;
  parameters.end_time      = 0.006;
  parameters.step_schedule = "0:1e-4, 0.005:1e-5";
  LoadControl whole(parameters), resumed(parameters);
  for (unsigned int i = 0; i < 49; ++i)
    EXPECT_EQ(whole.judge(true, 0.), Verdict::accept);
  resumed.restore(whole.target_time() - whole.step(),
                  whole.step(),
                  0.,
                  whole.steps_to_wait());
  for (unsigned int i = 0; i < 20; ++i)
  {
    EXPECT_NEAR(whole.target_time(), resumed.target_time(), 1e-14);
    EXPECT_NEAR(whole.step(), resumed.step(), 1e-14);
    whole.judge(true, 0.);
    resumed.judge(true, 0.);
  }
}



TEST(LoadSteps, ThatAreLostInRoundingAreRefused)
{
  const auto problem = [](const std::function<void(LoadParameters &)> &change) {
    LoadParameters parameters;
    parameters.end_time = 0.02;
    change(parameters);
    try
    {
      parameters.check();
    }
    catch (const InputError &error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  using P = LoadParameters;
  for (double P::*const step :
       {&P::first_step, &P::largest_step, &P::onset_step, &P::smallest_step})
  {
    EXPECT_NE(problem([&](P &p) { p.*step = 1e-20; }).find("lost in rounding"),
              std::string::npos);
    EXPECT_EQ(problem([&](P &p) { p.*step = 1e-12; }), "");
  }
  for (const char *const schedule : {"0:2e-3, 0.004:1e-20", "0:1e-300"})
    EXPECT_NE(problem([&](P &p) {
                p.step_schedule = schedule;
              }).find("Step schedule at 0"),
              std::string::npos);
  // what acts early only, or never
  EXPECT_EQ(problem([](P &p) { p.step_schedule = "0:1e-16, 1e-5:1e-3"; }), "");
  EXPECT_EQ(problem([](P &p) { p.step_schedule = "0:1e-3, 1:1e-20"; }), "");
}



TEST(LoadSteps, DerivedOnesAreNotLostInRounding)
{
  GivenSteps values = nothing_given(1.);
  values.largest    = 1e-11;
  const LoadSteps steps(values);
  EXPECT_GE(steps.smallest, 0.99e-12);
  EXPECT_LE(steps.smallest, steps.onset);
  EXPECT_LE(steps.onset, steps.largest);
}



TEST(LoadSteps, AnAbsurdNumberOfThemIsWarnedOf)
{
  LoadParameters parameters;
  parameters.end_time = 0.02;
  EXPECT_EQ(parameters.warning(), "");
  parameters.step_schedule = "0:1e-3, 0.01:1e-9";
  EXPECT_NE(parameters.warning().find("at least 1e+07 load steps"),
            std::string::npos)
    << parameters.warning();
  parameters.step_schedule = "";
  parameters.first_step    = 1e-10;
  EXPECT_EQ(parameters.warning(), ""); // it grows
  parameters.largest_phase_field_change = 0.;
  EXPECT_NE(parameters.warning(), "");
}
