// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_parameter_parser_h
#define mixed_cracks_input_parameter_parser_h

#include <input/parameter_source.h>
#include <input/parameter_tree.h>

#include <map>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A value that is allowed, and where it was found.
  struct ParameterAssignment
  {
    const ParameterEntry *entry;
    std::string           value;
    std::string           place;
    std::string           folder; ///< of the file; empty for --set
  };

  /// Turns statements and overrides into assignments. Mistakes are collected,
  /// not thrown, so that a user sees all of them at once.
  class ParameterParser
  {
  public:
    /// @p tree must outlive the parser and its assignments.
    explicit ParameterParser(const ParameterTree &tree);

    /// The statements of a file with all that it includes.
    void parse_file(const std::vector<SourceLine> &lines);

    /// "Subsection/.../Entry=value"
    void parse_override(const std::string &text);

    const std::vector<ParameterAssignment> &
    assignments() const
    {
      return accepted;
    }

    /// One message each, in the order in which they were met.
    const std::vector<std::string> &
    errors() const
    {
      return messages;
    }

  private:
    /// A subsection that is open, and the line that opened it. Inside an
    /// unknown one nothing is checked: one mistake, one message.
    struct OpenSubsection
    {
      std::string name;
      SourceLine  line;
      bool        is_known;
    };

    std::vector<std::string> path() const;

    void parse_statement(const SourceLine &line);

    void open_subsection(const SourceLine &line, const std::string &name);

    bool recover_from_missing_end(const SourceLine  &line,
                                  const std::string &name);

    void close_subsection(const SourceLine &line, const std::string &rest);

    void set(const SourceLine &line, const std::string &assignment);

    void report_malformed(const SourceLine &line);

    void assign(const std::string              &place,
                const std::string              &folder,
                const std::vector<std::string> &path,
                const std::string              &name,
                const std::string              &value);

    void report(const std::string &place, const std::string &message);

    const ParameterTree              &tree;
    std::vector<OpenSubsection>       open;
    unsigned int                      n_ends_to_forgive = 0;
    std::map<std::string, SourceLine> first_settings;
    std::vector<ParameterAssignment>  accepted;
    std::vector<std::string>          messages;
  };
} // namespace MixedCracks

#endif
