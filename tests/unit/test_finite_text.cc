// SPDX-License-Identifier: GPL-2.0-or-later
// What CSV files hold: names that read back as they were, and no
// number that is not finite.
#include <base/finite_text.h>

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    const double infinity     = std::numeric_limits<double>::infinity();
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  } // namespace

  TEST(FiniteText, NumbersThatAreNotFiniteAreEmpty)
  {
    EXPECT_EQ(csv_number(1. / 3.), "0.3333333333");
    for (const double value : {infinity, -infinity, not_a_number})
      EXPECT_EQ(csv_number(value), "");
  }

  TEST(FiniteText, StreamsOfCsvFilesLeaveThemOut)
  {
    std::ostringstream out;
    out.imbue(csv_locale());
    out.precision(10);
    out << 7u << ',' << infinity << ',' << -not_a_number << ',' << 1. / 3.
        << ',' << 123456ul << ',' << -1e300 << ',' << -infinity;
    EXPECT_EQ(out.str(), "7,,,0.3333333333,123456,-1e+300,");
  }

  TEST(FiniteText, NamesReadBackAsTheyWere)
  {
    const std::vector<std::string> names = {
      "left", "", "left, lower", "the \"top\"", "\"", ",", ",\"x\",", "a b"};
    std::string line;
    for (const std::string &name : names)
      line += (line.empty() ? "" : ",") + csv_field(name);
    EXPECT_EQ(csv_fields(line), names);
    EXPECT_EQ(csv_field("left, \"low\""), "\"left, \"\"low\"\"\"");
    EXPECT_EQ(csv_field("left"), "left");
    EXPECT_EQ(csv_fields("1,2\r"), (std::vector<std::string>{"1", "2"}));
    EXPECT_EQ(csv_fields("1,2,").size(), 3u);
  }
} // namespace MixedCracks
