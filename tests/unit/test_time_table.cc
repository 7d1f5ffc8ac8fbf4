// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>
#include <base/expression.h>
#include <base/time_table.h>

#include <gtest/gtest.h>

namespace MixedCracks
{
  namespace
  {
    TimeTable
    table_of(const std::string &text)
    {
      TimeTable table;
      EXPECT_EQ(table.read(text), "");
      return table;
    }

    std::string
    problem_of(const std::string &text)
    {
      TimeTable table;
      return table.read(text);
    }

    bool
    has(const std::string &text, const std::string &part)
    {
      return text.find(part) != std::string::npos;
    }
  } // namespace

  TEST(TimeTable, IsLinearBetweenItsRowsAndConstantBeyond)
  {
    const TimeTable table = table_of("1,10\n2,30\n4,-10\n");
    for (const auto &[time, value] :
         std::vector<std::pair<double, double>>{{0., 10.},
                                                {1., 10.},
                                                {1.25, 15.},
                                                {2., 30.},
                                                {3., 10.},
                                                {4., -10.},
                                                {5., -10.}})
      EXPECT_DOUBLE_EQ(table(time), value) << time;
    EXPECT_EQ(table.last_time(), 4.);
  }

  TEST(TimeTable, PassesOverNamesRemarksAndMarks)
  {
    EXPECT_DOUBLE_EQ(
      table_of("\xef\xbb\xbf# of a test\r\ntime (s), force (N)\r\n\r\n 0 , 1"
               "\r\n# more\r\n+1e0,\t2.5\r\n")(1.),
      2.5);
  }

  TEST(TimeTable, SaysWhichLineIsWrong)
  {
    EXPECT_TRUE(has(problem_of("0,1\n1;2\n"), "line 2 '1;2'"));
    EXPECT_TRUE(has(problem_of("t,f\n0,5,1,5\n"), "line 2 '0,5,1,5'"));
    EXPECT_TRUE(has(problem_of("t;f\n0,5;1,5\n"), "decimals take a point"));
    EXPECT_TRUE(has(problem_of("0,1\n1,x\n"), "line 2 '1,x'"));
    EXPECT_TRUE(has(problem_of("0,1\n1,nan\n"), "line 2"));
    EXPECT_TRUE(has(problem_of("0,1\n1\n"), "line 2 '1'"));
    EXPECT_TRUE(has(problem_of("0,1\ntime,force\n1,2\n"), "line 2"));
    EXPECT_TRUE(has(problem_of("0,1\n1,2\n\n1,3\n"), "line 4 '1,3'"));
    EXPECT_TRUE(has(problem_of("0,1\n1,2\n\n1,3\n"), "increase"));
    EXPECT_TRUE(has(problem_of("time,force\n"), "no row"));
    EXPECT_TRUE(has(problem_of(""), "no row"));
    EXPECT_TRUE(has(problem_of("0,1\n"), "one row"));
  }

  TEST(TimeTable, IsFoundInAText)
  {
    const std::string text =
      "2*table( \"a b.csv\" )+ table(\"c.csv\")*stable(\"d\")+table(e)";
    const auto calls = table_calls(text);
    ASSERT_EQ(calls.size(), 2u);
    EXPECT_EQ(calls[0].path, "a b.csv");
    EXPECT_EQ(calls[1].path, "c.csv");
    EXPECT_EQ(
      replace_tables(
        text, [](const TableCall &call) { return '<' + call.path + '>'; }),
      "2*<a b.csv>+ <c.csv>*stable(\"d\")+table(e)");
  }

  TEST(TimeTable, IsAValueInExpressions)
  {
    keep_time_table("ramp.csv", table_of("0,0\n2,1\n"));
    keep_time_table("fall.csv", table_of("0,8\n2,4\n"));
    const auto value = [](const std::string &text) {
      return Expression(text, {"x", "y", "z", "t"}, "A")({2., 3., 5., 1.});
    };
    EXPECT_DOUBLE_EQ(value("table(\"ramp.csv\")"), 0.5);
    EXPECT_DOUBLE_EQ(value("-x*table(\"ramp.csv\") + z"), 4.);
    EXPECT_DOUBLE_EQ(value("y*table(\"ramp.csv\")*table(\"fall.csv\")*t"), 9.);
    EXPECT_DOUBLE_EQ(value("x*y*z*t*table(\"ramp.csv\")"), 15.);
    const Expression expression("table(\"ramp.csv\")", {"x", "t"}, "A");
    EXPECT_TRUE(expression.uses("t"));
    EXPECT_FALSE(expression.uses("x"));
    EXPECT_FALSE(expression.uses("ramp"));
    EXPECT_EQ(expression.text(), "table(\"ramp.csv\")");
  }

  TEST(TimeTable, WhatIsNoTableIsRefused)
  {
    keep_time_table("ramp.csv", table_of("0,0\n2,1\n"));
    const auto message = [](const std::string              &text,
                            const std::vector<std::string> &variables) {
      try
      {
        const Expression expression(text, variables, "A");
      }
      catch (const InputError &error)
      {
        return std::string(error.what());
      }
      return std::string("accepted");
    };
    const std::vector<std::string> all = {"x", "y", "z", "t"};
    EXPECT_TRUE(has(message("table(ramp.csv)", all), "quotation marks"));
    EXPECT_TRUE(has(message("table(\"ramp.csv\", 2)", all), "quotation marks"));
    EXPECT_TRUE(has(message("table(\"no.csv\")", all), "not been read"));
    EXPECT_TRUE(has(message("table(\"ramp.csv\")", {"h"}), "depends on t"));
    EXPECT_TRUE(has(message("table", all), "quotation marks"));
  }
} // namespace MixedCracks
