// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>

#include <input/command_line.h>

#include <gtest/gtest.h>

namespace MixedCracks
{
  namespace
  {
    CommandLine
    parse(const std::vector<std::string> &arguments)
    {
      std::vector<const char *> argv{"mixed-cracks"};
      for (const std::string &argument : arguments)
        argv.push_back(argument.c_str());
      return parse_command_line(static_cast<int>(argv.size()), argv.data());
    }
  } // namespace

  TEST(CommandLine, FileAlone)
  {
    const CommandLine line = parse({"case.prm"});
    EXPECT_EQ(line.file, "case.prm");
    EXPECT_TRUE(line.set.empty());
    EXPECT_FALSE(line.output || line.parameters || line.case_id);
    EXPECT_FALSE(line.check || line.resume || line.overwrite || line.version ||
                 line.help);
  }

  TEST(CommandLine, EveryOption)
  {
    const CommandLine line = parse({"--set",
                                    "A/B=1",
                                    "--check",
                                    "case.prm",
                                    "--overwrite",
                                    "--set=A/C = x=y",
                                    "--set",
                                    "D=-1",
                                    "--output",
                                    "results/a b"});
    EXPECT_EQ(line.file, "case.prm");
    EXPECT_EQ(line.set,
              (std::vector<std::string>{"A/B=1", "A/C = x=y", "D=-1"}));
    EXPECT_EQ(*line.output, "results/a b");
    EXPECT_TRUE(line.check && line.overwrite);
    EXPECT_FALSE(line.resume);
    EXPECT_EQ(*parse({"--output=dir", "a.prm"}).output, "dir");
    EXPECT_TRUE(parse({"a.prm", "--resume"}).resume);
    EXPECT_EQ(*parse({"--case-id", "a.prm"}).case_id, "problem");
    EXPECT_EQ(*parse({"a.prm", "--case-id=full"}).case_id, "full");
  }

  TEST(CommandLine, NoFileNeeded)
  {
    EXPECT_TRUE(parse({"--help"}).help);
    EXPECT_TRUE(parse({"--version"}).version);
    EXPECT_TRUE(parse({"--cite"}).cite);
    EXPECT_EQ(*parse({"--example"}).example, "");
    EXPECT_EQ(*parse({"--example", "strip"}).example, "strip");
    EXPECT_EQ(*parse({"--example=epdm/strip"}).example, "epdm/strip");
    EXPECT_EQ(*parse({"--parameters"}).parameters, "prm");
    EXPECT_EQ(*parse({"--parameters", "json"}).parameters, "json");
    EXPECT_EQ(*parse({"--parameters=markdown"}).parameters, "markdown");
    EXPECT_TRUE(parse({"--parameters", "--help"}).help);
  }

  TEST(CommandLine, SaysWhatIsWrong)
  {
    // arguments, part of the message
    const std::vector<std::pair<std::vector<std::string>, std::string>>
      mistakes{{{}, "no parameter file"},
               {{"--check"}, "no parameter file"},
               {{""}, "empty"},
               {{"a.prm", "b.prm"}, "'a.prm' and 'b.prm'"},
               {{"a.prm", "--chekc"}, "did you mean '--check'?"},
               {{"a.prm", "--outptu=x"}, "did you mean '--output'?"},
               {{"a.prm", "-v"}, "unknown '-v'"},
               {{"-", "a.prm"}, "unknown '-'"},
               {{"a.prm", "--"}, "unknown '--'"},
               {{"a.prm", "--set"}, "--set needs a value"},
               {{"--set", "--check", "a.prm"}, "--set needs a value"},
               {{"a.prm", "--set="}, "--set needs a value"},
               {{"a.prm", "--set", "A/B"}, "Entry=value"},
               {{"a.prm", "--set", "A/B", "=", "3"}, "quotation marks"},
               {{"a.prm", "--set", "=3"}, "Entry=value"},
               {{"--set", "A/B=", "3", "a.prm"}, "two parameter files"},
               {{"a.prm", "--output"}, "--output needs a value"},
               {{"a.prm", "--output="}, "--output needs a value"},
               {{"a.prm", "--output", ""}, "--output needs a value"},
               {{"a.prm", "--output=x", "--output=y"}, "twice"},
               {{"a.prm", "--check=yes"}, "takes no value"},
               {{"a.prm", "--help=1"}, "takes no value"},
               {{"a.prm", "--resume", "--overwrite"}, "exclude each other"},
               {{"--case-id"}, "no parameter file"},
               {{"a.prm", "--case-id=al"}, "Allowed: problem, full"},
               {{"a.prm", "--case-id", "--case-id"}, "twice"},
               {{"a.prm", "--case-id", "--check"}, "--case-id only prints"},
               {{"a.prm", "--resume", "--case-id"}, "--case-id only prints"},
               {{"--parameters", "xml"}, "unknown 'xml'"},
               {{"--parameters=jsno"}, "did you mean 'json'?"},
               {{"--parameters="}, "unknown ''"},
               {{"--parameters", "--parameters"}, "twice"},
               {{"--example", "a", "--example", "b"}, "twice"},
               {{"--cite=bibtex"}, "takes no value"}};
    for (const auto &[arguments, part] : mistakes)
      try
      {
        parse(arguments);
        ADD_FAILURE() << "accepted; expected: " << part;
      }
      catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
          << error.what() << "\nexpected: " << part;
      }
    EXPECT_THROW(parse_command_line(0, nullptr), InputError);
  }

  TEST(CommandLine, UsageNamesEveryOption)
  {
    for (const std::string option : {"--set",
                                     "--output",
                                     "--check",
                                     "--case-id",
                                     "--resume",
                                     "--overwrite",
                                     "--parameters",
                                     "--example",
                                     "--cite",
                                     "--version",
                                     "--help"})
      EXPECT_NE(usage().find("  " + option), std::string::npos) << option;
  }
} // namespace MixedCracks
