// SPDX-License-Identifier: GPL-2.0-or-later
// Files that are whole or not there, and a disk that is full.
#include <base/checksum.h>

#include <output/disk.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

using namespace MixedCracks;

namespace
{
  // what was synced, in that order
  std::vector<std::string> synced;
} // namespace

// In the place of that of the C library, which goes on to do its work.
extern "C" int
fsync(const int file)
{
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  std::error_code   error;
  synced.push_back(std::filesystem::read_symlink(link, error).string());
  return static_cast<int>(syscall(SYS_fsync, file));
}

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



TEST(Disk, NamesOfFoldersAreOnTheDiskToo)
{
  const Folder      folder;
  const std::string top =
    std::filesystem::canonical(std::filesystem::path(folder.path)).string();
  const std::string path = folder.path + "/checkpoint/generation-0";
  synced.clear();
  EXPECT_EQ(make_folder_durably(path), "");
  EXPECT_TRUE(std::filesystem::is_directory(path));
  EXPECT_EQ(synced, (std::vector<std::string>{top + "/checkpoint", top}));
  // one that is there may have been made just before the machine stopped
  synced.clear();
  EXPECT_EQ(make_folder_durably(path), "");
  EXPECT_EQ(synced, std::vector<std::string>{top + "/checkpoint"});
  EXPECT_EQ(write_durably(folder.path + "/file", "text\n"), "");
  const std::string message = make_folder_durably(folder.path + "/file/none");
  EXPECT_NE(message.find("file/none"), std::string::npos) << message;
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
  EXPECT_EQ(checksum(one), checksum(one.data(), one.data() + one.size()));
  EXPECT_NE(checksum(one), checksum(other));
}
