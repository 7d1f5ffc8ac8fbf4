// SPDX-License-Identifier: GPL-2.0-or-later
// Whether a run ends with a step, or before it was resumed, and what is said.
#include <simulation/run_ending.h>

#include <gtest/gtest.h>

using namespace MixedCracks;

namespace
{
  LoadParameters
  parameters()
  {
    LoadParameters result;
    result.end_time            = 10.;
    result.stop_fraction       = 0.5;
    result.stop_when_separated = true;
    return result;
  }

  StatisticsRow
  row_of(const double time, const double force)
  {
    StatisticsRow row;
    row["time"]    = time;
    row["force_y"] = force;
    return row;
  }

  const std::string attempt       = "Load stepping/First step = 0.5\n";
  const std::string other_attempt = "Load stepping/First step = 0.25\n";

  RunEnding
  resumed(const RunEnd earlier, const std::string &now, const bool is_cut)
  {
    RunRecord record;
    record.end        = earlier;
    record.attempt    = attempt;
    record.why_failed = ": why";
    record.rows       = {row_of(1., 4.)};
    LoadControl control(parameters());
    Log         log(false);
    return ending_of_resumed_run(
      record, now, parameters(), [is_cut]() { return is_cut; }, control, log);
  }
} // namespace



TEST(RunEnding, FollowsFromTheForceAndTheCracksOfAStep)
{
  LoadControl control(parameters());
  const auto  end = [&](const double force, const bool is_cut) {
    return end_after_step(force, is_cut, true, parameters(), control);
  };
  EXPECT_EQ(end(4., false), RunEnd::none);
  EXPECT_EQ(end(3., false), RunEnd::none);
  EXPECT_EQ(end(1.9, false), RunEnd::force_fell);
  EXPECT_EQ(end(1.9, true), RunEnd::separated);
}



TEST(RunEnding, ALoadThatIsNotCarriedIsNoPeak)
{
  LoadControl control(parameters());
  EXPECT_EQ(end_after_step(4., false, true, parameters(), control),
            RunEnd::none);
  EXPECT_EQ(end_after_step(9., true, false, parameters(), control),
            RunEnd::no_equilibrium);
  EXPECT_DOUBLE_EQ(control.peak_force(), 4.);
}



TEST(RunEnding, NamesTheLoadAtFailureAndWhoStoppedTheRun)
{
  const std::vector<StatisticsRow> rows = {row_of(1., 4.), row_of(2., 5.)};
  RunEnding                        ending;
  ending.is(RunEnd::no_equilibrium);
  const RunOutcome torn = ending.outcome(rows, "by its clock");
  EXPECT_EQ(torn.exit_status, 0);
  EXPECT_NE(torn.reason.find("between 4 N (t = 1 s)"), std::string::npos)
    << torn.reason;
  ending.is(RunEnd::stopped);
  EXPECT_EQ(ending.outcome(rows, "by its clock").reason, "by its clock");
  EXPECT_EQ(ending.outcome(rows, "by its clock").exit_status, 5);
  ending.is(RunEnd::failed, ": why");
  EXPECT_EQ(ending.outcome(rows, "by its clock").reason,
            in_words(RunEnd::failed) + ": why");
}



TEST(RunEnding, AResumedRunTriesAgainOnlyWithSomethingElse)
{
  EXPECT_TRUE(resumed(RunEnd::failed, attempt, false).had_ended);
  EXPECT_EQ(resumed(RunEnd::failed, attempt, false).end, RunEnd::failed);
  EXPECT_EQ(resumed(RunEnd::failed, attempt, false).why_failed, ": why");
  EXPECT_FALSE(resumed(RunEnd::failed, other_attempt, false).is_over());
  EXPECT_EQ(resumed(RunEnd::onset, attempt, false).end, RunEnd::onset);
  EXPECT_EQ(resumed(RunEnd::stopped, attempt, true).end, RunEnd::separated);
  EXPECT_EQ(resumed(RunEnd::no_equilibrium, other_attempt, true).end,
            RunEnd::no_equilibrium);
}



// The expression that has ended it may be another one now.
TEST(RunEnding, ARefusedRunGoesOn)
{
  const RunEnding ending = resumed(RunEnd::refused, attempt, false);
  EXPECT_FALSE(ending.is_over());
  EXPECT_FALSE(ending.had_ended);
  EXPECT_TRUE(ending.why_failed.empty());
}
