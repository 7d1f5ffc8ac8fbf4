// SPDX-License-Identifier: GPL-2.0-or-later
// Who has an output directory, with locks of the file system and without.
#include <base/errors.h>

#include <output/disk.h>
#include <output/run_lock.h>
#include <output/run_lock_holder.h>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

using namespace MixedCracks;

namespace
{
  namespace fs = std::filesystem;

  // Each rank has a directory of its own.
  class RunLockTest : public ::testing::Test
  {
  protected:
    RunLockTest()
    {
      std::string pattern =
        (fs::temp_directory_path() / "run-lock-XXXXXX").string();
      folder    = mkdtemp(pattern.data());
      directory = folder + "/a/results";
    }

    ~RunLockTest() override
    {
      fs::remove_all(folder);
    }

    std::string
    lock_file() const
    {
      return directory + "/.lock";
    }

    // what a second one is told; empty when it gets the directory
    std::string
    refusal(const RunLockOptions &options = {}) const
    {
      try
      {
        const RunLock second(directory, options);
        return "";
      }
      catch (const FileError &error)
      {
        return error.what();
      }
    }

    std::string folder, directory;
  };

  // as on a file system that has no locks; short times, for tests wait
  RunLockOptions
  without_locks(const int error = ENOLCK)
  {
    RunLockOptions options;
    options.lock      = [error](int) { return error; };
    options.heartbeat = 0.1;
    options.stale     = 3.; // a busy machine may let the thread wait
    options.patience  = 0.05;
    return options;
  }

  void
  wait(const double seconds)
  {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  }

  // the age the last heartbeat would have
  void
  make_older(const std::string &path, const long seconds)
  {
    struct stat status;
    ASSERT_EQ(stat(path.c_str(), &status), 0);
    timespec times[2] = {status.st_atim, status.st_mtim};
    times[1].tv_sec -= seconds;
    ASSERT_EQ(utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
  }
} // namespace



TEST_F(RunLockTest, ASecondOneIsToldWhoHasTheDirectory)
{
  const RunLock     first(directory);
  const std::string before = contents_of_file(lock_file());
  const LockHolder  holder = read_holder(lock_file());
  const std::string text   = refusal();
  EXPECT_EQ(holder.process, std::to_string(getpid()));
  EXPECT_NE(text.find("'" + directory + "' is in use by process " +
                      std::to_string(getpid()) + " on host " + holder.host +
                      " since " + holder.since),
            std::string::npos)
    << text;
  EXPECT_TRUE(first.warning().empty());
  // and has changed nothing
  EXPECT_EQ(contents_of_file(lock_file()), before);
}



TEST_F(RunLockTest, NothingIsLeftBehind)
{
  {
    const RunLock lock(directory);
    EXPECT_TRUE(fs::exists(lock_file()));
  }
  EXPECT_FALSE(fs::exists(folder + "/a")) << "made for the lock alone";
  fs::create_directories(directory);
  {
    const RunLock lock(directory);
    std::ofstream(directory + "/results.csv") << "1\n";
  }
  EXPECT_TRUE(fs::exists(directory + "/results.csv"));
  EXPECT_FALSE(fs::exists(lock_file()));
}



TEST_F(RunLockTest, AKilledProcessHasNothingAnyMore)
{
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0)
  {
    const RunLock lock(directory);
    if (write(ready[1], "x", 1) == 1)
      pause();
    _exit(1);
  }
  char byte;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  EXPECT_NE(refusal().find("process " + std::to_string(child)),
            std::string::npos);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(lock_file()));
  EXPECT_EQ(refusal(), "");
}



TEST_F(RunLockTest, ALockIsNotHandedOnToOtherPrograms)
{
  pid_t child = 0;
  {
    const RunLock lock(directory);
    child = fork();
    if (child == 0)
    {
      execlp("sleep", "sleep", "60", nullptr);
      _exit(1);
    }
  }
  // as soon as it is another program
  for (unsigned int i = 0; i < 200 && !refusal().empty(); ++i)
    wait(0.1);
  EXPECT_EQ(refusal(), "");
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}



TEST_F(RunLockTest, WithoutLocksTheHeartbeatCounts)
{
  for (const int error : {ENOLCK, ENOSYS, EOPNOTSUPP, EINVAL})
  {
    const RunLock first(directory, without_locks(error));
    EXPECT_NE(first.warning().find("has no locks"), std::string::npos);
    if (error == ENOLCK)
      wait(3.5); // longer than it takes to become stale
    const std::string text = refusal(without_locks(error));
    EXPECT_NE(text.find("process " + std::to_string(getpid())),
              std::string::npos)
      << text;
    EXPECT_NE(text.find("last sign of life"), std::string::npos) << text;
  }
  EXPECT_FALSE(fs::exists(lock_file()));
}



TEST_F(RunLockTest, WithoutLocksAStaleHeartbeatIsOfADeadProcess)
{
  fs::create_directories(directory);
  std::ofstream(lock_file()) << "host far\nprocess 7\nsince then\n"
                             << "no locks here\n";
  const std::string text = refusal(without_locks());
  EXPECT_NE(text.find("process 7 on host far since then"), std::string::npos)
    << text;
  make_older(lock_file(), 10);
  EXPECT_EQ(refusal(without_locks()), "");
  // a file that a lock once belonged to says nothing
  std::ofstream(lock_file()) << "host far\nprocess 7\nsince then\n";
  EXPECT_EQ(refusal(without_locks()), "");
}



TEST_F(RunLockTest, WithoutLocksTheLastOfTwoInTheSameMomentHasIt)
{
  RunLockOptions options = without_locks();
  options.patience       = 3.;
  std::string what;
  std::thread first([&]() { what = refusal(options); });
  wait(0.5); // the first has looked, and waits
  replace_file(lock_file(), "host far\nprocess 7\nsince then\nno locks here\n");
  first.join();
  EXPECT_NE(what.find("process 7 on host far"), std::string::npos) << what;
  EXPECT_EQ(read_holder(lock_file()).process, "7");
}



TEST_F(RunLockTest, WhatCannotBeWrittenIsLeftToOthersToSay)
{
  std::ofstream(folder + "/file") << "text\n";
  directory = folder + "/file";
  EXPECT_EQ(refusal(), "");
  directory = folder + "/file/below";
  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(fs::file_size(folder + "/file"), 5u);
}
