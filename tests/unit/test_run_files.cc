// SPDX-License-Identifier: GPL-2.0-or-later
// What a run records of its files, and what is removed by that.
#include <output/disk.h>
#include <output/run_files.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace MixedCracks;

namespace
{
  namespace fs = std::filesystem;

  class RunFilesOfADirectory : public ::testing::Test
  {
  protected:
    const fs::path folder =
      fs::temp_directory_path() / ("run_files_" + std::to_string(getpid()));
    const std::string directory = (folder / "run").string();

    void
    SetUp() override
    {
      fs::create_directories(directory);
    }

    void
    TearDown() override
    {
      fs::remove_all(folder);
    }

    void
    write(const std::string &name, const std::string &text = "text\n")
    {
      const fs::path path = fs::path(directory) / name;
      fs::create_directories(path.parent_path());
      std::ofstream(path) << text;
    }

    bool
    there_is(const std::string &name) const
    {
      return fs::exists(fs::path(directory) / name);
    }

    void
    remove_all_of_runs()
    {
      remove_run_files(directory, files_of_runs(directory));
    }
  };
} // namespace



TEST_F(RunFilesOfADirectory, AreThoseThatWereNotThereBefore)
{
  write("report.html");
  write("fields/important.dat");
  ASSERT_TRUE(begin_run_files(
    directory, {}, {"log.txt", "report.html", "fields/", "crack_path/"}));
  ASSERT_TRUE(note_run_files(directory, {"fields/fields_00000.0.vtu"}));
  write("log.txt");
  write("fields/fields_00000.0.vtu");
  write("fields/fields_00001.0.vtu"); // nobody has recorded it
  write("crack_path/mine.txt");
  remove_all_of_runs();
  for (const char *name : {"log.txt", "fields/fields_00000.0.vtu"})
    EXPECT_FALSE(there_is(name)) << name;
  for (const char *name : {"report.html",
                           "fields/important.dat",
                           "fields/fields_00001.0.vtu",
                           "crack_path/mine.txt"})
    EXPECT_TRUE(there_is(name)) << name;
  EXPECT_FALSE(has_run_files(directory));
}



TEST_F(RunFilesOfADirectory, IncludeFoldersOnlyWhenTheyAreEmpty)
{
  ASSERT_TRUE(begin_run_files(directory, {}, {"fields/", "crack_path/"}));
  write("fields/x");
  fs::create_directories(fs::path(directory) / "crack_path");
  remove_all_of_runs();
  EXPECT_TRUE(there_is("fields/x"));
  EXPECT_FALSE(there_is("crack_path"));
}



TEST_F(RunFilesOfADirectory, NeverLieOutsideOfIt)
{
  const fs::path outside = folder / "outside.txt";
  std::ofstream(outside) << "text\n";
  ASSERT_TRUE(begin_run_files(directory, {}, {}));
  ASSERT_TRUE(note_run_files(
    directory, {"../outside.txt", outside.string(), "x/../../outside.txt"}));
  fs::create_directory_symlink(folder, fs::path(directory) / "fields");
  ASSERT_TRUE(note_run_files(directory, {"fields/"}));
  remove_all_of_runs();
  EXPECT_TRUE(fs::exists(outside));
  EXPECT_TRUE(there_is("fields/outside.txt"));
}



TEST_F(RunFilesOfADirectory, AreNotRecordedWithoutAList)
{
  EXPECT_TRUE(note_run_files(directory, {"log.txt"}));
  EXPECT_FALSE(there_is(run_files_name));
  write(run_files_name, "a list of mine\n");
  EXPECT_FALSE(has_run_files(directory));
  EXPECT_TRUE(files_of_runs(directory).empty());
}



TEST_F(RunFilesOfADirectory, AreListedOnce)
{
  ASSERT_TRUE(begin_run_files(directory, {}, {"log.txt", "fields/"}));
  ASSERT_TRUE(note_run_files(directory, {"fields/a", "fields/b", "fields/a"}));
  const std::string list = contents_of_file(directory + "/run_files.txt");
  ASSERT_TRUE(begin_run_files(directory, {}, {"log.txt", "fields/"}));
  ASSERT_TRUE(note_run_files(directory, {"fields/b"}));
  EXPECT_EQ(contents_of_file(directory + "/run_files.txt"), list);
  EXPECT_EQ(files_of_runs(directory).size(), 4u);
}



// What is added must not go on with such a line.
TEST_F(RunFilesOfADirectory, AreAddedBehindALineThatWasCutOff)
{
  ASSERT_TRUE(begin_run_files(directory, {}, {"log.txt"}));
  std::ofstream(fs::path(directory) / run_files_name, std::ios::app) << "fie";
  ASSERT_TRUE(note_run_files(directory, {"summary.json"}));
  EXPECT_EQ(files_of_runs(directory),
            (std::vector<std::string>{"log.txt", "summary.json"}));
}



// The names of a checkpoint alone say nothing about who wrote it.
TEST_F(RunFilesOfADirectory, LeaveOutACheckpointOfSomebodyElse)
{
  const std::string record = "checkpoint/generation-0/record.txt";
  write(record);
  EXPECT_TRUE(files_of_runs(directory).empty());
  ASSERT_TRUE(begin_run_files(directory, {}, {"log.txt"}));
  remove_all_of_runs();
  EXPECT_TRUE(there_is(record));
  // one of a run that was killed, whose list names the folder
  ASSERT_TRUE(begin_run_files(directory, {}, {"checkpoint/generation-1/"}));
  write("checkpoint/generation-1/record.txt");
  remove_all_of_runs();
  EXPECT_FALSE(there_is("checkpoint/generation-1"));
  EXPECT_TRUE(there_is(record));
}



// A line that was being written when the run was killed names another file.
TEST_F(RunFilesOfADirectory, LeaveOutALineThatWasCutOff)
{
  ASSERT_TRUE(begin_run_files(directory, {}, {"log.txt"}));
  std::ofstream(fs::path(directory) / run_files_name, std::ios::app)
    << "fields/fields";
  EXPECT_EQ(files_of_runs(directory), std::vector<std::string>{"log.txt"});
}



TEST_F(RunFilesOfADirectory, OfEarlierVersionsAreKnownByTheirNames)
{
  write("statistics.csv");
  write("fields/fields_00012.3.vtu");
  EXPECT_TRUE(files_of_runs(directory).empty()); // of whom?
  write("log.txt");
  write("parameters.prm");
  write("crack_path/crack_path_000012.vtp");
  for (const char *name : {"fields/fields_12.vtu",
                           "fields/fields_00012.vtu.bak",
                           "crack_path/crack_path_12.vtp",
                           "notes.txt"})
    write(name);
  remove_all_of_runs();
  for (const char *name : {"statistics.csv",
                           "parameters.prm",
                           "fields/fields_00012.3.vtu",
                           "crack_path/crack_path_000012.vtp"})
    EXPECT_FALSE(there_is(name)) << name;
  for (const char *name : {"fields/fields_12.vtu",
                           "fields/fields_00012.vtu.bak",
                           "crack_path/crack_path_12.vtp",
                           "notes.txt"})
    EXPECT_TRUE(there_is(name)) << name;
}



TEST_F(RunFilesOfADirectory, HaveMoreDigitsFromStep100000On)
{
  write("crack_path/crack_path_1000000.vtp");
  for (const char *name : {"fields/fields_99999.pvtu",
                           "fields/fields_100000.0.vtu",
                           "fields/fields_100000.h5",
                           "fields/mesh_100000.h5.part",
                           "fields/crack_surface_100000.vtp"})
    write(name);
  EXPECT_EQ(numbered_files(directory).size(), 6u);
}



TEST_F(RunFilesOfADirectory, IncludeThoseThatTheSealOfACheckpointNames)
{
  const std::string generation = "checkpoint/generation-1/";
  write(generation + "seal.txt", "3\nmesh 12\nmore.data 13\n../../x 5\n");
  for (const char *name : {"mesh", "more.data", "mine.txt"})
    write(generation + name);
  write("x");
  remove_all_of_runs();
  for (const char *name : {"seal.txt", "mesh", "more.data"})
    EXPECT_FALSE(there_is(generation + name)) << name;
  EXPECT_TRUE(there_is(generation + "mine.txt"));
  EXPECT_TRUE(there_is("x"));
}
