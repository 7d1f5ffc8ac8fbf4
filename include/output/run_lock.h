// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_run_lock_h
#define mixed_cracks_output_run_lock_h

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// How a directory is locked; other values are for tests.
  struct RunLockOptions
  {
    /// Locks an open file for this process without waiting: 0 or an error
    /// number. By default flock().
    std::function<int(int file_descriptor)> lock;
    /// Where the file system has no locks, the file is touched this often, ...
    double heartbeat = 20.; // s
    /// ... and its holder is believed dead when it has not been for so long.
    double stale = 120.; // s
    /// Two that take it in the same moment see each other after this.
    double patience = 0.5; // s
  };

  /// Keeps other processes out of a directory as long as it lives. The lock is
  /// that of the operating system on the file ".lock" in it, and is gone with
  /// the process however that ends; what is written in the file is for people.
  /// Where the file system has no locks the file itself is the lock, kept
  /// fresh by a thread.
  class RunLock
  {
  public:
    /// Makes the directory where it is not there. Throws FileError, naming the
    /// holder, when another process has it; then nothing was changed. Where
    /// the directory cannot be written nothing is locked.
    explicit RunLock(const std::string &directory,
                     RunLockOptions     options = RunLockOptions());

    /// Removes the file, and the directories that were made for it if nothing
    /// else is in them.
    ~RunLock();

    RunLock(const RunLock &)            = delete;
    RunLock &operator=(const RunLock &) = delete;

    /// What the user should know, one sentence; or empty.
    const std::string &
    warning() const
    {
      return in_words;
    }

  private:
    class Heartbeat;

    /// False when the file was removed by its last holder meanwhile.
    bool try_to_lock();

    void lock_by_heartbeat();

    void make_folders();

    void remove_folders();

    void write_holder() const;

    [[noreturn]] void refuse(const std::string &more = "");

    const std::string          directory;
    const std::string          path;
    RunLockOptions             options;
    int                        file = -1;
    std::vector<std::string>   new_folders; // outermost first
    std::string                in_words;
    std::unique_ptr<Heartbeat> heartbeat;
  };
} // namespace MixedCracks

#endif
