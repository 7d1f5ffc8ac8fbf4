// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_command_line_h
#define mixed_cracks_input_command_line_h

#include <optional>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// What the user asked for.
  struct CommandLine
  {
    std::string                file;       ///< empty only when none is needed
    std::vector<std::string>   set;        ///< "Subsection/.../Entry=value"
    std::optional<std::string> output;     ///< instead of Output/Directory
    std::optional<std::string> parameters; ///< print them in this format
    std::optional<std::string> case_id;    ///< print the one of this scope
    std::optional<std::string> example;    ///< write it; "": list them
    bool                       check     = false;
    bool                       resume    = false;
    bool                       overwrite = false;
    bool                       cite      = false;
    bool                       version   = false;
    bool                       help      = false;

    /// Whether there is a question to be answered, and no case.
    bool
    is_question() const
    {
      return help || version || cite || parameters || example;
    }
  };

  /// Reads the arguments behind the program's name. Throws InputError for
  /// what is unknown, incomplete or contradictory. Nothing is printed, and
  /// every rank comes to the same result.
  CommandLine parse_command_line(int argc, const char *const *argv);

  /// The text of --help.
  std::string usage();
} // namespace MixedCracks

#endif
