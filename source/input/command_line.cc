// SPDX-License-Identifier: GPL-2.0-or-later
// The command line. Options take their value behind '=' or as the next
// argument. What cannot be understood, or is given twice where one value is
// taken, is refused with what is allowed. A word that begins with "--" is never
// taken for a value: "--output --check" is a forgotten directory.

#include <base/errors.h>
#include <base/names.h>
#include <base/ranges.h>
#include <base/text.h>

#include <input/case_id.h>
#include <input/command_line.h>
#include <input/parameter_manual.h>

#include <algorithm>

namespace MixedCracks
{
  namespace
  {
    const std::vector<std::string> &
    option_names()
    {
      static const std::vector<std::string> names{"--set",
                                                  "--output",
                                                  "--check",
                                                  "--case-id",
                                                  "--resume",
                                                  "--overwrite",
                                                  "--parameters",
                                                  "--example",
                                                  "--cite",
                                                  "--version",
                                                  "--help"};
      return names;
    }

    bool
    is_option(const std::string &argument)
    {
      return starts_with(argument, "-");
    }

    // Goes through the arguments one by one.
    class Reader
    {
    public:
      Reader(const int argc, const char *const *const argv)
        : arguments(argv + std::min(argc, 1), argv + argc)
      {}

      CommandLine
      read()
      {
        for (; position < arguments.size(); ++position)
          if (is_option(arguments[position]))
            read_option(arguments[position]);
          else
            read_file(arguments[position]);
        return result;
      }

    private:
      void read_option(const std::string &argument);

      void read_file(const std::string &argument);

      void read_setting(const std::string &setting);

      // The value behind "=", or else the next argument, which @p name needs.
      std::string value_of(const std::string &name, const std::string &what);

      // The same, which need not be there.
      std::optional<std::string> optional_value();

      // What is given, which is one of those, or else the first of them.
      static std::string one_of(const std::string                &name,
                                const std::vector<std::string>   &allowed,
                                const std::optional<std::string> &given);

      std::vector<std::string> arguments;
      std::size_t              position = 0;
      /// of "--option=value"
      std::optional<std::string> attached;
      CommandLine                result;
    };



    void
    Reader::read_option(const std::string &argument)
    {
      const std::size_t equals = argument.find('=');
      const std::string name   = argument.substr(0, equals);
      attached.reset();
      if (equals != std::string::npos)
        attached = argument.substr(equals + 1);

      if (name == "--set")
        return read_setting(value_of(name, "\"Subsection/.../Entry=value\""));
      std::optional<std::string> *const once =
        name == "--parameters" ? &result.parameters
        : name == "--case-id"  ? &result.case_id
        : name == "--example"  ? &result.example
        : name == "--output"   ? &result.output
                               : nullptr;
      // (a word behind --case-id is the parameter file, a scope is attached)
      if (once != nullptr)
      {
        if (*once)
          throw InputError(name + " is given twice.");
        *once = name == "--parameters"
                  ? one_of(name, parameter_formats(), optional_value())
                : name == "--case-id" ? one_of(name, case_id_scopes(), attached)
                : name == "--example" ? optional_value().value_or("")
                                      : value_of(name, "a directory");
        return;
      }
      bool *const flag = name == "--check"       ? &result.check
                         : name == "--resume"    ? &result.resume
                         : name == "--overwrite" ? &result.overwrite
                         : name == "--cite"      ? &result.cite
                         : name == "--version"   ? &result.version
                         : name == "--help"      ? &result.help
                                                 : nullptr;
      if (flag == nullptr)
        throw InputError("command line: option " +
                         unknown_name_message(name, option_names()));
      if (attached)
        throw InputError(name + " takes no value, found " +
                         in_quotes(*attached) + ".");
      *flag = true;
    }



    void
    Reader::read_file(const std::string &argument)
    {
      if (argument.empty())
        throw InputError("command line: an argument is empty; expected the "
                         "name of a parameter file.");
      if (!result.file.empty())
        throw InputError("command line: two parameter files, " +
                         in_quotes(result.file) + " and " +
                         in_quotes(argument) +
                         "; expected one. Does a --set need quotation marks?");
      result.file = argument;
    }



    void
    Reader::read_setting(const std::string &setting)
    {
      const std::size_t equals = setting.find('=');
      if (equals == std::string::npos || equals == 0)
        throw InputError("--set " + in_quotes(setting) +
                         ": expected \"Subsection/.../Entry=value\", in "
                         "quotation marks when there are blanks.");
      result.set.push_back(setting);
    }



    std::string
    Reader::value_of(const std::string &name, const std::string &what)
    {
      std::string value;
      if (attached)
        value = *attached;
      else if (position + 1 < arguments.size() &&
               !starts_with(arguments[position + 1], "--"))
        value = arguments[++position];
      if (value.empty())
        throw InputError(name + " needs a value: " + what + ".");
      return value;
    }



    std::optional<std::string>
    Reader::optional_value()
    {
      if (attached)
        return attached;
      if (position + 1 < arguments.size() &&
          !is_option(arguments[position + 1]))
        return arguments[++position];
      return {};
    }



    std::string
    Reader::one_of(const std::string                &name,
                   const std::vector<std::string>   &allowed,
                   const std::optional<std::string> &given)
    {
      const std::string found = given.value_or(allowed.front());
      if (!contains(allowed, found))
        throw InputError(name + ": " + unknown_name_message(found, allowed));
      return found;
    }
  } // namespace



  CommandLine
  parse_command_line(const int argc, const char *const *const argv)
  {
    const CommandLine result = Reader(argc, argv).read();
    if (result.resume && result.overwrite)
      throw InputError("--resume and --overwrite exclude each other: continue "
                       "the run in the output directory, or replace it?");
    if (result.case_id && (result.check || result.resume || result.overwrite))
      throw InputError("--case-id only prints the id of the case; allowed with "
                       "it are --set and --output.");
    if (result.file.empty() && !result.is_question())
      throw InputError("command line: no parameter file.\n" + usage());
    return result;
  }



  std::string
  usage()
  {
    return R"(Usage: mpirun -n N mixed-cracks [options] case.prm

Computes how cracks run through a solid, as the parameter file describes it.

Options:
  --set "Subsection/.../Entry=value"
                    override an entry of the file; may be repeated
  --output DIR      write there instead of to Output/Directory
  --check           read and check everything, say what the run will need, stop
  --case-id[=problem|full]
                    print an id of the case, the same for the same problem
                    however it is written, and stop; full: load steps, solvers
                    and tolerances count too
  --resume          continue from the newest checkpoint in the output directory
  --overwrite       replace the run in the output directory
  --parameters [prm|json|markdown]
                    print every entry with default, allowed values, description
  --example [NAME]  write NAME.prm, and the files that it reads, into the
                    working directory; without a name: list the examples
  --cite            print how to cite the program, in the Citation File Format
  --version         print the versions of the program and its libraries
  --help            print this text

Exit status: 0 finished; 2 bad input; 3 the calculation cannot go on, last
accepted state written; 4 file trouble; 5 stopped on request with a checkpoint;
6 stopped on request before there was anything to continue from. To stop a run,
kill -USR1 its mpirun, or start it with mixed-cracks-run and press Ctrl-C.
)";
  }
} // namespace MixedCracks
