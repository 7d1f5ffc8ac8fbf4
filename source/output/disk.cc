// SPDX-License-Identifier: GPL-2.0-or-later
// Files that survive crashes. write_durably() leaves at its path, when the
// machine stops after
//
//   1. open path.part, write all of it     the old file
//   2. fsync(path.part)                    the old file
//   3. rename(path.part, path)             the old or the new one, whole
//   4. fsync(directory)                    the new one
//
// rename() is atomic for all that look (POSIX). Without 2 the name may reach
// the disk before the data, and the file is empty; without 4 the caller could
// go on and remove what the old file is needed for.

#include <output/disk.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace MixedCracks
{
  namespace
  {
    // an open file that closes itself
    class Descriptor
    {
    public:
      Descriptor(const std::string &path, const int flags)
        : number(open(path.c_str(), flags | O_CLOEXEC, 0666))
      {}

      Descriptor(const Descriptor &) = delete;

      ~Descriptor()
      {
        if (number >= 0)
          close(number);
      }

      const int number;
    };



    // 0, or what is wrong
    // write() may take less than it was given, or be interrupted by a signal.
    int
    write_all(const int file, const std::string &text)
    {
      std::size_t done = 0;
      while (done < text.size())
      {
        const ssize_t written =
          ::write(file, text.data() + done, text.size() - done);
        if (written < 0 && errno == EINTR)
          continue;
        if (written <= 0)
          return written < 0 ? errno : ENOSPC;
        done += static_cast<std::size_t>(written);
      }
      return fsync(file) == 0 ? 0 : errno;
    }



    std::string
    message(const std::string &path, const int error)
    {
      return "'" + path + "': " + std::strerror(error);
    }
  } // namespace



  // write() fails with EFBIG then, instead of SIGXFSZ ending the process.
  void
  survive_file_size_limit()
  {
    std::signal(SIGXFSZ, SIG_IGN);
  }



  // All files are held at the same time, since one after the other each would
  // find the same room. Allocated rather than asked for by statvfs(): quotas,
  // ulimit -f and blocks kept for root count as well. Another program may take
  // the room between here and the writing; the checks behind that remain.
  std::string
  missing_space_for(const std::vector<SizedFile> &files)
  {
    std::string problem;
    for (const SizedFile &file : files)
    {
      const std::string path = file.path + ".reserved";
      const Descriptor  reserved(path, O_WRONLY | O_CREAT | O_TRUNC);
      int               error = reserved.number < 0 ? errno : 0;
      if (error == 0 && file.size > 0)
        do
          error =
            posix_fallocate(reserved.number, 0, static_cast<off_t>(file.size));
        while (error == EINTR);
      if (error != 0)
      {
        problem = message(file.path, error) + ", where " +
                  std::to_string(file.size) + " bytes are to be written";
        break;
      }
    }
    for (const SizedFile &file : files)
      unlink((file.path + ".reserved").c_str());
    return problem;
  }



  std::string
  write_durably(const std::string &path, const std::string &text)
  {
    const std::string unfinished = path + ".part";
    int               error      = 0;
    {
      const Descriptor file(unfinished, O_WRONLY | O_CREAT | O_TRUNC);
      error = file.number < 0 ? errno : write_all(file.number, text);
    }
    if (error == 0 && std::rename(unfinished.c_str(), path.c_str()) != 0)
      error = errno;
    if (error != 0)
    {
      unlink(unfinished.c_str());
      return message(path, error);
    }
    return sync_directory(std::filesystem::path(path).parent_path().string());
  }



  // A folder is found again by its name in the one above it, which is synced
  // for each that is new. That of the last one always: it may have been made
  // just before the machine stopped.
  std::string
  make_folder_durably(const std::string &path)
  {
    namespace fs = std::filesystem;
    std::error_code       error;
    std::vector<fs::path> parents;
    for (fs::path folder = fs::absolute(path, error);
         parents.empty() || !fs::exists(folder, error);
         folder = folder.parent_path())
      parents.push_back(folder.parent_path());
    fs::create_directories(path, error);
    if (error)
      return message(path, error.value());
    for (const fs::path &parent : parents)
      if (const std::string problem = sync_directory(parent.string());
          !problem.empty())
        return problem;
    return "";
  }



  std::string
  sync_to_disk(const std::string &path)
  {
    const Descriptor file(path, O_RDONLY);
    if (file.number < 0 || fsync(file.number) != 0)
      return message(path, errno);
    posix_fadvise(file.number, 0, 0, POSIX_FADV_DONTNEED); // a hint
    return "";
  }



  std::string
  sync_directory(const std::string &path)
  {
    const Descriptor directory(path.empty() ? "." : path,
                               O_RDONLY | O_DIRECTORY);
    // names may be made where they may not be read
    if (directory.number < 0)
      return errno == EACCES ? "" : message(path, errno);
    // some file systems have nothing to do there, and say so
    if (fsync(directory.number) != 0 && errno != EINVAL)
      return message(path, errno);
    return "";
  }



  std::int64_t
  size_of_file(const std::string &path)
  {
    struct stat status;
    if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
      return -1;
    return status.st_size;
  }



  bool
  ends_with(const std::string &path, const std::string &ending)
  {
    std::ifstream file(path, std::ios::binary);
    std::string   found(ending.size(), '\0');
    file.seekg(-static_cast<std::streamoff>(ending.size()), std::ios::end);
    return file.read(&found[0], static_cast<std::streamsize>(found.size())) &&
           found == ending;
  }



  std::string
  contents_of_file(const std::string &path)
  {
    std::ifstream      file(path, std::ios::binary);
    std::ostringstream all;
    all << file.rdbuf();
    return all.str();
  }
} // namespace MixedCracks
