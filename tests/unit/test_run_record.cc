// SPDX-License-Identifier: GPL-2.0-or-later
// What a checkpoint says of a run: complete, and refused when it is nonsense.
#include <base/errors.h>

#include <output/run_record.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

using namespace MixedCracks;

namespace
{
  // a different value for every member
  RunRecord
  example()
  {
    RunRecord record;
    record.signature           = "a/b = \"1\"\nc/d = 2\n";
    record.attempt             = "e = \\ 3\n";
    record.end                 = RunEnd::onset;
    record.why_failed          = ": it \"diverged\"";
    record.cell_size           = 0.1;
    record.time                = 1. / 3.;
    record.time_step           = 1e-5;
    record.next_step           = 2.5e-5;
    record.peak_force          = 1234.5678901234567;
    record.external_work       = -17.;
    record.peak_step           = 1;
    record.steps_to_wait       = 2;
    record.n_refinements       = 4;
    record.n_overlapping_steps = 35;
    record.deepest_overlap     = 36.;
    record.overlap_in_words    = "at (1, 2), \"deep\"";
    record.changed_loads       = {"one", "and \"another\""};
    record.totals              = {6, 7, 8, 9.5, {{"output", 0.5}, {"a b", 1.}}};
    record.rows.resize(2);
    StatisticsRow &row            = record.rows[1];
    row["step"]                   = 1;
    row["time"]                   = 10.;
    row["displacement"]           = 11.;
    row["force_x"]                = 12.;
    row["force_y"]                = 13.;
    row["force_z"]                = 14.;
    row["elastic_energy"]         = 15.;
    row["crack_energy"]           = 16.;
    row["external_work"]          = 17.;
    row["min_phase_field"]        = 18.;
    row["max_phase_field_change"] = 19.;
    row["newton_iterations"]      = 20;
    row["linear_iterations"]      = 21;
    row["active_set_size"]        = 22;
    row["cells"]                  = 23;
    row["dofs"]                   = 24;
    row["wall_time"]              = 25.;
    row["coupling_iterations"]    = 26;
    row["coupling_change"]        = 27.;
    row["factorizations"]         = 28;
    row["rejected_steps"]         = 29;
    row["refinements"]            = 30;
    row["crack_volume"]           = 31.;
    row["crack_length"]           = 32.;
    row["min_jacobian"]           = 37.;
    row.point_displacements       = {33., 34.};
    row.reactions                 = {38.};
    record.field_files            = {{0., "fields/a b.pvtu"}, {1., "c"}};
    record.tables                 = {{"crack_opening.csv", ""},
                                     {"crack_path.csv", "0,1,\"x, y\"\n2,3,z\n"}};
    return record;
  }

  std::string
  text_of(const RunRecord &record)
  {
    std::ostringstream out;
    write_record(out, record);
    return out.str();
  }

  RunRecord
  record_of(const std::string &text)
  {
    std::istringstream in(text);
    return read_record(in);
  }
} // namespace



TEST(RunRecord, ComesBackAsItWasWritten)
{
  const RunRecord record = record_of(text_of(example()));
  EXPECT_EQ(record.signature, example().signature);
  EXPECT_EQ(record.end, RunEnd::onset);
  EXPECT_EQ(record.time, 1. / 3.);
  EXPECT_EQ(record.totals.phases.at("a b"), 1.);
  EXPECT_EQ(record.field_files[0].second, "fields/a b.pvtu");
  EXPECT_EQ(record.rows[1].point_displacements[1], 34.);
  EXPECT_EQ(record.rows[1].reactions, std::vector<double>({38.}));
  EXPECT_EQ(record.n_overlapping_steps, 35u);
  EXPECT_EQ(record.deepest_overlap, 36.);
  EXPECT_EQ(record.overlap_in_words, example().overlap_in_words);
  EXPECT_EQ(record.changed_loads, example().changed_loads);
  EXPECT_EQ(record.tables, example().tables);
  EXPECT_EQ(text_of(record), text_of(example()));
}



TEST(RunRecord, EveryColumnIsWrittenAndRead)
{
  std::string text = text_of(example());
  std::replace(text.begin(), text.end(), '\n', ' ');
  for (int number = 10; number <= 37; ++number)
    EXPECT_NE(text.find(' ' + std::to_string(number) + ' '), std::string::npos)
      << "the column that is " << number << " in the example";
}



// Checkpoints of earlier versions are read by place; what is new goes last.
TEST(RunRecord, ARowHasTheLayoutOfTheFormat)
{
  EXPECT_NE(text_of(example()).find(
              "\n1 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 "
              "28 29 30 31 2\n33 34 32 37 "),
            std::string::npos);
}



TEST(RunRecord, WhatWasNotComputedStaysSo)
{
  const RunRecord record = record_of(text_of(example()));
  EXPECT_TRUE(std::isnan(record.rows[0]["crack_volume"]));
  EXPECT_EQ(record.rows[1]["crack_volume"], 31.);
}



TEST(RunRecord, EveryEndOfARunComesBack)
{
  RunRecord record = example();
  int       n      = 0;
  for (; n == 0 || !in_words(static_cast<RunEnd>(n)).empty(); ++n)
  {
    record.end = static_cast<RunEnd>(n);
    EXPECT_EQ(record_of(text_of(record)).end, record.end) << n;
  }
  EXPECT_EQ(n - 1, static_cast<int>(RunEnd::refused));
}



TEST(RunRecord, RefusesWhatIsOfNoRun)
{
  const auto refused = [](const std::function<void(RunRecord &)> &spoil) {
    RunRecord record = example();
    spoil(record);
    EXPECT_THROW(record_of(text_of(record)), FileError);
  };
  refused([](RunRecord &record) { record.rows.clear(); });
  refused([](RunRecord &record) { record.rows.pop_back(); });
  refused([](RunRecord &record) { record.rows[1]["step"] = 7.; });
  refused([](RunRecord &record) { record.next_step = 0.; });
  refused([](RunRecord &record) { record.time = std::nan(""); });
  refused([](RunRecord &record) { record.end = static_cast<RunEnd>(99); });
  const std::string text = text_of(example());
  for (std::size_t size = 0; size + 2 < text.size(); size += 7)
    EXPECT_THROW(record_of(text.substr(0, size)), FileError) << size;
}
