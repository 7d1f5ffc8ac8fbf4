// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>
#include <base/text.h>

#include <gtest/gtest.h>

namespace MixedCracks
{
  using Strings = std::vector<std::string>;

  TEST(Text, SplitsAndTrims)
  {
    EXPECT_EQ(split_list(" a ;b b;; c;", ';'), (Strings{"a", "b b", "c"}));
    EXPECT_TRUE(split_list("", ';').empty());
    EXPECT_TRUE(split_list(" ; ;", ';').empty());
    EXPECT_EQ(split_list("one", ';'), (Strings{"one"}));
  }

  TEST(Text, SingleSpaced)
  {
    EXPECT_EQ(single_spaced("  Hole \t  radius "), "Hole radius");
    EXPECT_EQ(single_spaced(" \n"), "");
  }

  TEST(Text, StartsWith)
  {
    EXPECT_TRUE(starts_with("alpha 1", "alpha"));
    EXPECT_TRUE(starts_with("alpha", ""));
    EXPECT_FALSE(starts_with("al", "alpha"));
    EXPECT_FALSE(starts_with("the alpha", "alpha"));
  }

  TEST(Text, InQuotesIsShort)
  {
    EXPECT_EQ(in_quotes("a"), "'a'");
    EXPECT_LT(in_quotes(std::string(1000, 'x')).size(), 100U);
  }

  TEST(Text, Numbers)
  {
    EXPECT_EQ(parse_number(" -1.5e-3 ", "A"), -1.5e-3);
    EXPECT_EQ(parse_number("+4", "A"), 4.);
    EXPECT_EQ(parse_numbers("1, 2.5 ,-3", "A"),
              (std::vector<double>{1., 2.5, -3.}));
    EXPECT_EQ(parse_numbers("7", "A"), (std::vector<double>{7.}));
    EXPECT_TRUE(parse_numbers("  ", "A").empty());
  }

  TEST(Text, RefusesWhatIsNoNumber)
  {
    for (const std::string text : {"",
                                   " ",
                                   "nan",
                                   "NaN",
                                   "inf",
                                   "-inf",
                                   "infinity",
                                   "1e999",
                                   "1,5",
                                   "4 mm",
                                   "4mm",
                                   "0x10",
                                   "1 2",
                                   "--1",
                                   "1e",
                                   "four"})
      try
      {
        parse_number(text, "Geometry/Hole radius");
        ADD_FAILURE() << "accepted '" << text << "'";
      }
      catch (const InputError &error)
      {
        const std::string message = error.what();
        EXPECT_NE(message.find("Geometry/Hole radius"), std::string::npos);
        EXPECT_NE(message.find("'" + text + "'"), std::string::npos);
      }
  }

  TEST(Text, RefusesWhatIsNoListOfNumbers)
  {
    for (const std::string text :
         {"1,,2", "1,2,", ",1", ",", "1;2", "1 2", "1, nan", "1, x", "1, inf"})
      try
      {
        parse_numbers(text, "Geometry/Hole center");
        ADD_FAILURE() << "accepted '" << text << "'";
      }
      catch (const InputError &error)
      {
        const std::string message = error.what();
        EXPECT_NE(message.find("Geometry/Hole center"), std::string::npos);
        EXPECT_NE(message.find("'" + text + "'"), std::string::npos);
      }
  }
} // namespace MixedCracks
