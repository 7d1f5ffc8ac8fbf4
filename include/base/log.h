// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_log_h
#define mixed_cracks_base_log_h

#include <fstream>
#include <string>

namespace MixedCracks
{
  /// printf into a string.
  std::string format(const char *text, ...)
    __attribute__((format(printf, 1, 2)));

  /// What a run says: on the screen and, once open() was called, in a file.
  /// Only the rank it is active on writes; the others may call it all the
  /// same.
  class Log
  {
  public:
    explicit Log(bool active);
    ~Log();

    /// Also write to @p file_name, what was said so far included. With
    /// @p append an existing file is continued.
    void open(const std::string &file_name, bool append);

    /// Bytes that open() will write.
    std::size_t
    size_until_open() const
    {
      return before_file.size();
    }

    /// Write one line.
    void line(const std::string &text);

    /// What went wrong with the file, for a person; empty when all is well,
    /// and on the ranks that do not write.
    std::string failure() const;

    /// On a terminal, show this below the last line until the next one.
    void progress(const std::string &text);

  private:
    void clear_progress();

    const bool    active;
    const bool    on_terminal;
    bool          progress_shown = false;
    std::ofstream file;
    std::string   name;
    std::string   before_file;
  };
} // namespace MixedCracks

#endif
