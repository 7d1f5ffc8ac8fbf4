// SPDX-License-Identifier: GPL-2.0-or-later
// Files that are whole or not there, and a disk that is full.
#include <output/disk.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include <sys/resource.h>

using namespace MixedCracks;

namespace
{
  // each rank has a folder of its own
  struct Folder
  {
    Folder()
      : path("disk_test_" +
             std::to_string(
               dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)))
    {
      std::filesystem::create_directories(path);
    }

    ~Folder()
    {
      std::filesystem::remove_all(path);
    }

    std::size_t
    n_files() const
    {
      std::size_t n = 0;
      for (const auto &entry : std::filesystem::directory_iterator(path))
        n += entry.exists() ? 1 : 0;
      return n;
    }

    const std::string path;
  };

  // files may have this size at most, as with ulimit -f
  struct SizeLimit
  {
    explicit SizeLimit(const rlim_t bytes)
    {
      getrlimit(RLIMIT_FSIZE, &before);
      rlimit limited   = before;
      limited.rlim_cur = bytes;
      setrlimit(RLIMIT_FSIZE, &limited);
      old_handler = std::signal(SIGXFSZ, SIG_DFL);
      survive_file_size_limit();
    }

    ~SizeLimit()
    {
      setrlimit(RLIMIT_FSIZE, &before);
      std::signal(SIGXFSZ, old_handler);
    }

    rlimit before;
    void (*old_handler)(int);
  };
} // namespace



TEST(Disk, WritesAFileAsAWhole)
{
  const Folder      folder;
  const std::string path = folder.path + "/file";
  EXPECT_EQ(write_durably(path, "first\n"), "");
  EXPECT_EQ(contents_of_file(path), "first\n");
  EXPECT_EQ(size_of_file(path), 6);
  EXPECT_TRUE(ends_with(path, "st\n"));
  EXPECT_FALSE(ends_with(path, "nothing that is in it\n"));
  EXPECT_EQ(folder.n_files(), 1u);
  EXPECT_EQ(size_of_file(folder.path + "/none"), -1);
}



TEST(Disk, KeepsTheOldFileWhenThereIsNoRoom)
{
  const Folder      folder;
  const std::string path = folder.path + "/file";
  EXPECT_EQ(write_durably(path, "old\n"), "");
  std::string message;
  {
    const SizeLimit limit(1000);
    message = write_durably(path, std::string(5000, 'x'));
  }
  EXPECT_NE(message.find(path), std::string::npos) << message;
  EXPECT_EQ(contents_of_file(path), "old\n");
  EXPECT_EQ(folder.n_files(), 1u);
}



TEST(Disk, KnowsBeforehandThatThereIsNoRoom)
{
  const Folder                 folder;
  const std::vector<SizedFile> files = {{folder.path + "/small", 500},
                                        {folder.path + "/large", 5000}};
  EXPECT_EQ(missing_space_for(files), "");
  {
    const SizeLimit   limit(1000);
    const std::string message = missing_space_for(files);
    EXPECT_NE(message.find("/large"), std::string::npos) << message;
    EXPECT_NE(message.find("5000 bytes"), std::string::npos) << message;
  }
  EXPECT_EQ(folder.n_files(), 0u);
  EXPECT_NE(missing_space_for({{folder.path + "/none/file", 1}}), "");
}



TEST(Disk, ChecksumsTellFilesApart)
{
  const Folder      folder;
  const std::string one = "some bytes", other = "some bytez";
  write_durably(folder.path + "/one", one);
  EXPECT_EQ(file_checksum(folder.path + "/one"),
            checksum(one.data(), one.data() + one.size()));
  EXPECT_NE(checksum(one.data(), one.data() + one.size()),
            checksum(other.data(), other.data() + other.size()));
}
