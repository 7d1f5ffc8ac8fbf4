// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/base/patterns.h>

#include <input/pattern_words.h>

#include <gtest/gtest.h>

namespace MixedCracks
{
  TEST(PatternWords, EveryPattern)
  {
    using namespace dealii::Patterns;
    const auto words = [](const PatternBase &pattern) {
      return pattern_in_words(pattern.description());
    };
    EXPECT_EQ(words(Double()), "a number");
    EXPECT_EQ(words(Double(0)), "a number, at least 0");
    EXPECT_EQ(words(Double(Double::min_double_value, 3)),
              "a number, at most 3");
    EXPECT_EQ(words(Double(-0.5, 1.5)), "a number between -0.5 and 1.5");
    EXPECT_EQ(words(Integer()), "a whole number");
    EXPECT_EQ(words(Integer(1)), "a whole number, at least 1");
    EXPECT_EQ(words(Bool()), "true or false");
    EXPECT_EQ(words(Selection("a b|c")), "one of: a b, c");
    EXPECT_EQ(words(Anything()), "any text");
    EXPECT_EQ(words(FileName()), "a file name");
    EXPECT_EQ(words(DirectoryName()), "a directory");
    EXPECT_EQ(words(List(Double(0), 2, 3, ";")),
              "2 to 3 values separated by ';', each a number, at least 0");
    EXPECT_EQ(words(List(Anything())),
              "any number of values separated by ',', each any text");
    EXPECT_EQ(words(List(List(Integer(), 2, 2, ","), 1, 9, ";")),
              "1 to 9 values separated by ';', each 2 values separated by "
              "',', each a whole number");
    EXPECT_EQ(words(MultipleSelection("a|b")),
              "any of these, separated by ',': a, b");
    EXPECT_EQ(pattern_in_words("[Unheard of]"), "[Unheard of]");
    EXPECT_EQ(pattern_choices("[Selection a|b c ]"),
              (std::vector<std::string>{"a", "b c"}));
    EXPECT_TRUE(pattern_choices("[Bool]").empty());
  }
} // namespace MixedCracks
