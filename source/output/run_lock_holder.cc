// SPDX-License-Identifier: GPL-2.0-or-later
// .lock has a line "host NAME", "process NUMBER", "since TIME", and "no locks
// here" where its age counts. Only that last line decides anything, the others
// are for messages: of an empty file or one that is cut off, "another process".

#include <base/text.h>

#include <output/disk.h>
#include <output/run_lock_holder.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <ctime>
#include <fstream>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    const std::string host_word      = "host ";
    const std::string process_word   = "process ";
    const std::string since_word     = "since ";
    const std::string heartbeat_word = "no locks here";

    std::string
    this_host()
    {
      char name[256] = "";
      gethostname(name, sizeof(name) - 1);
      return name;
    }



    std::string
    present_time()
    {
      const std::time_t now = std::time(nullptr);
      std::tm           parts{};
      gmtime_r(&now, &parts);
      char text[64];
      std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M:%S UTC", &parts);
      return text;
    }



    // of this process alone, beside @p path
    std::string
    name_beside(const std::string &path)
    {
      return path + "." + this_host() + "." + std::to_string(getpid());
    }



    bool
    write_file(const std::string &path, const std::string &text)
    {
      std::ofstream file(path, std::ios::trunc);
      file << text << std::flush;
      return static_cast<bool>(file);
    }
  } // namespace



  std::string
  describe_this_process(const bool has_heartbeat)
  {
    return host_word + this_host() + '\n' + process_word +
           std::to_string(getpid()) + '\n' + since_word + present_time() +
           '\n' + (has_heartbeat ? heartbeat_word + '\n' : "");
  }



  LockHolder
  read_holder(const std::string &path)
  {
    LockHolder         holder;
    std::istringstream text(contents_of_file(path));
    for (std::string line; std::getline(text, line);)
    {
      const auto take = [&line](const std::string &word, std::string &value) {
        if (starts_with(line, word))
          value = line.substr(word.size());
      };
      take(host_word, holder.host);
      take(process_word, holder.process);
      take(since_word, holder.since);
      holder.has_heartbeat = holder.has_heartbeat || line == heartbeat_word;
    }
    return holder;
  }



  std::string
  in_words_of(const LockHolder &holder)
  {
    if (holder.host.empty() || holder.process.empty() || holder.since.empty())
      return "another process";
    return "process " + holder.process + " on host " + holder.host + " since " +
           holder.since;
  }



  // mtime(probe) - mtime(path), both given by the same server: differences
  // between the clocks of hosts, some minutes at times, do not matter.
  double
  seconds_since_touched(const std::string &path)
  {
    const std::string probe = name_beside(path);
    struct stat       now, then;
    const bool        known = write_file(probe, "now\n") &&
                       stat(probe.c_str(), &now) == 0 &&
                       stat(path.c_str(), &then) == 0;
    std::remove(probe.c_str());
    if (!known)
      return 0.;
    return static_cast<double>(now.st_mtim.tv_sec - then.st_mtim.tv_sec) +
           1e-9 *
             static_cast<double>(now.st_mtim.tv_nsec - then.st_mtim.tv_nsec);
  }



  bool
  replace_file(const std::string &path, const std::string &text)
  {
    const std::string whole = name_beside(path);
    const bool        done =
      write_file(whole, text) && std::rename(whole.c_str(), path.c_str()) == 0;
    if (!done)
      std::remove(whole.c_str());
    return done;
  }
} // namespace MixedCracks
