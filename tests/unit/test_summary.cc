// SPDX-License-Identifier: GPL-2.0-or-later
// summary.json is JSON, whatever words and numbers a run comes to.
#include <output/summary.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    // the file without its blanks and line ends; by each rank on its own
    std::string
    written(const Summary &summary, const std::string &events = "")
    {
      const std::string name =
        testing::TempDir() + "summary_" + std::to_string(getpid());
      write_summary(name, summary, {}, events);
      std::ifstream      file(name);
      std::ostringstream text;
      for (std::string word; file >> word;)
        text << word;
      std::remove(name.c_str());
      return text.str();
    }
  } // namespace

  TEST(Summary, NumbersAreFiniteOrNull)
  {
    Summary summary;
    summary.cost.wall_time = std::numeric_limits<double>::infinity();
    summary.thickness      = std::numeric_limits<double>::quiet_NaN();
    summary.cell_size      = 1. / 3.;
    summary.ranks          = 2;
    const std::string text = written(summary);
    for (const std::string part : {"\"wall_time_s\":null",
                                   "\"thickness_mm\":null",
                                   "\"finest_cell_mm\":0.3333333333,",
                                   "\"ranks\":2,",
                                   "\"separated\":null",
                                   "\"force_fell\":false"})
      EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  }

  TEST(Summary, WordsAreUtf8)
  {
    Summary summary;
    // quotation marks, a control character; cut off, out of place
    summary.warnings = {"a\"b\\c\n\x01", "\xc3\xa4", "\xc3", "\x80"};
    EXPECT_NE(written(summary).find("\"warnings\":[\"a\\\"b\\\\c\\n\\u0001\","
                                    "\"\xc3\xa4\",\"\xef\xbf\xbd\","
                                    "\"\xef\xbf\xbd\"]"),
              std::string::npos)
      << written(summary);
  }

  TEST(Summary, EventsAreObjectsWithoutEmptyFields)
  {
    const std::string text =
      written(Summary(),
              "step,event,boundary,length\n3,onset,,\n7,\"a, b\",hole,1.5\n");
    EXPECT_NE(text.find("\"events\":[{\"step\":3,\"event\":\"onset\""
                        "},{\"step\":7,\"event\":\"a,b\","
                        "\"boundary\":\"hole\",\"length\":1.5}]"),
              std::string::npos)
      << text;
  }
} // namespace MixedCracks
