// SPDX-License-Identifier: GPL-2.0-or-later
// One log for a run: the first rank writes it to the standard output and, as
// soon as the directory is open, to log.txt; what was said before that is kept
// until then. Every line is flushed, since a run may be killed at any time.

#include <base/log.h>

#include <cstdarg>
#include <cstdio>
#include <iostream>
#include <vector>

#include <unistd.h>

namespace MixedCracks
{
  std::string
  format(const char *text, ...)
  {
    va_list arguments;
    va_start(arguments, text);
    const int size = std::vsnprintf(nullptr, 0, text, arguments);
    va_end(arguments);
    std::vector<char> result(static_cast<std::size_t>(size) + 1);
    va_start(arguments, text);
    std::vsnprintf(result.data(), result.size(), text, arguments);
    va_end(arguments);
    return result.data();
  }



  Log::Log(const bool active)
    : active(active)
    , on_terminal(active && isatty(STDOUT_FILENO) == 1)
  {}



  Log::~Log()
  {
    clear_progress();
  }



  void
  Log::open(const std::string &file_name, const bool append)
  {
    if (!active)
      return;
    name = file_name;
    file.open(name, append ? std::ios::app : std::ios::trunc);
    file << before_file << std::flush;
    before_file.clear();
  }



  std::string
  Log::failure() const
  {
    // a file that could not be opened has failed, too
    if (name.empty() || file)
      return "";
    return "Output/Directory: '" + name +
           "' cannot be written any more; is the disk full?";
  }



  void
  Log::clear_progress()
  {
    if (progress_shown)
      std::cout << "\r\033[K" << std::flush;
    progress_shown = false;
  }



  void
  Log::line(const std::string &text)
  {
    if (!active)
      return;
    clear_progress();
    std::cout << text << '\n' << std::flush;
    if (file.is_open())
      file << text << '\n' << std::flush;
    else
      before_file += text + '\n';
  }



  void
  Log::progress(const std::string &text)
  {
    if (!on_terminal)
      return;
    clear_progress();
    std::cout << text << std::flush;
    progress_shown = true;
  }
} // namespace MixedCracks
