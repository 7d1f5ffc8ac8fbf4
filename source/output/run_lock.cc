// SPDX-License-Identifier: GPL-2.0-or-later
// One process per directory. With flock() on DIR/.lock,
//
//   take:   1. open, or create         free:  1. unlink .lock
//           2. flock(LOCK_NB)                 2. close, which unlocks
//           3. is .lock still the file that is open? if not, again from 1
//
// Without 3: A frees the lock between 1 and 2 of B, so that B locks a file that
// has no name any more, and C creates and locks a new one. Unlinked before it
// is unlocked, since afterwards the file of the next holder might be removed.
//
// flock() rather than fcntl(F_SETLK): such a lock is gone as soon as its
// process closes any descriptor of the file, after only reading it, say. Both
// end with the process, so that no stale lock is left after kill -9.
//
// Without locks (lock_by_heartbeat): the file is the lock while its age, by the
// clock of its file system, is below 120 s; a thread touches it every 20 s.
//
//   1. .lock has a holder and is young: refuse
//   2. replace it by a file with own host, process, time (rename: whole)
//   3. wait 0.5 s; if it is not one's own any more, the other was later: refuse
//
// Two that both pass 1 before either reaches 2 are told apart by 3 as long as
// their renames are less than 0.5 s apart; hence the warning.

#include <base/errors.h>

#include <output/disk.h>
#include <output/run_lock.h>
#include <output/run_lock_holder.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <thread>

namespace MixedCracks
{
  namespace
  {
    namespace fs = std::filesystem;

    int
    lock_by_system(const int file)
    {
      return flock(file, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    }

    // that somebody else has it
    bool
    is_held(const int error)
    {
      return error == EWOULDBLOCK || error == EAGAIN || error == EACCES;
    }

    // Whether a name still leads to an open file.
    bool
    is_same_file(const std::string &path, const int file)
    {
      struct stat named, open;
      return stat(path.c_str(), &named) == 0 && fstat(file, &open) == 0 &&
             named.st_dev == open.st_dev && named.st_ino == open.st_ino;
    }
  } // namespace



  // Touches the file until it is destroyed.
  class RunLock::Heartbeat
  {
  public:
    Heartbeat(const std::string &path, const double period)
      : thread([this, path, period]() {
        std::unique_lock<std::mutex>        guard(mutex);
        const std::chrono::duration<double> time(period);
        while (!waker.wait_for(guard, time, [this]() { return ended; }))
          utimensat(AT_FDCWD, path.c_str(), nullptr, 0);
      })
    {}

    ~Heartbeat()
    {
      {
        const std::lock_guard<std::mutex> guard(mutex);
        ended = true;
      }
      waker.notify_one();
      thread.join();
    }

  private:
    std::mutex              mutex;
    std::condition_variable waker;
    bool                    ended = false;
    std::thread             thread; // last: it uses the others
  };



  RunLock::RunLock(const std::string &directory, RunLockOptions given)
    : directory(directory)
    , path(directory + "/.lock")
    , options(std::move(given))
  {
    if (!options.lock)
      options.lock = lock_by_system;
    make_folders();
    while (!try_to_lock())
      ;
  }



  RunLock::~RunLock()
  {
    heartbeat.reset();
    if (file >= 0)
    {
      // its name goes before the lock: nobody else can have locked this file
      if (is_same_file(path, file))
        unlink(path.c_str());
      close(file);
    }
    remove_folders();
  }



  void
  RunLock::make_folders()
  {
    std::error_code          error;
    std::vector<std::string> missing;
    fs::path folder = fs::absolute(directory, error).lexically_normal();
    for (; folder.has_relative_path(); folder = folder.parent_path())
      if (folder.has_filename() && !fs::exists(folder, error))
        missing.push_back(folder.string());
    for (auto name = missing.rbegin(); name != missing.rend(); ++name)
      if (fs::create_directory(*name, error))
        new_folders.push_back(*name);
  }



  void
  RunLock::remove_folders()
  {
    std::error_code error;
    for (auto name = new_folders.rbegin(); name != new_folders.rend(); ++name)
      fs::remove(*name, error); // unless something is in it
  }



  bool
  RunLock::try_to_lock()
  {
    file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0 && errno == EACCES) // left by another user
      file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
    {
      const std::string reason = std::strerror(errno);
      std::error_code   unknown;
      // what is wrong with the directory is said where it is prepared
      if (!fs::exists(path, unknown))
        return true;
      remove_folders();
      throw FileError("Output/Directory: '" + path +
                      "', which keeps other runs out of the directory, cannot "
                      "be opened: " +
                      reason + ".");
    }
    const int error = options.lock(file);
    if (is_held(error))
      refuse();
    if (error != 0)
    {
      lock_by_heartbeat();
      return true;
    }
    if (!is_same_file(path, file))
    {
      close(file);
      file = -1;
      return false;
    }
    write_holder();
    return true;
  }



  // Whoever puts the file there has the directory. Of two processes that do so
  // in the same moment the contents tell, a little later, who was the last.
  void
  RunLock::lock_by_heartbeat()
  {
    const LockHolder before = read_holder(path);
    if (before.has_heartbeat)
    {
      const double age = seconds_since_touched(path);
      if (age < options.stale)
        refuse("; its last sign of life is " +
               std::to_string(static_cast<int>(age)) +
               " s old, and this file system has no locks: if it is dead, try "
               "again in " +
               std::to_string(static_cast<int>(options.stale - age) + 1) +
               " s");
    }
    const std::string mine    = describe_this_process(/*has_heartbeat=*/true);
    const bool        written = replace_file(path, mine);
    std::this_thread::sleep_for(
      std::chrono::duration<double>(options.patience));
    if (!written || contents_of_file(path) != mine)
      refuse();
    close(file);
    file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    in_words =
      "Output/Directory: the file system of '" + directory +
      "' has no locks; another process is recognised by the age of the file "
      "'.lock' there, and two that start in the same moment may not see each "
      "other";
    heartbeat = std::make_unique<Heartbeat>(path, options.heartbeat);
  }



  void
  RunLock::write_holder() const
  {
    const std::string text = describe_this_process(/*has_heartbeat=*/false);
    // a full disk leaves it empty, and the lock holds all the same
    if (ftruncate(file, 0) != 0 ||
        pwrite(file, text.data(), text.size(), 0) < 0)
      return;
  }



  void
  RunLock::refuse(const std::string &more)
  {
    const std::string holder = in_words_of(read_holder(path));
    close(file);
    file = -1;
    remove_folders();
    throw FileError("Output/Directory: '" + directory + "' is in use by " +
                    holder + more +
                    ". Allowed: another directory (--output DIR), or this one "
                    "when that run has ended.");
  }
} // namespace MixedCracks
