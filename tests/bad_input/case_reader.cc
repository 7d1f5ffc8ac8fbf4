// SPDX-License-Identifier: GPL-2.0-or-later
// Reads cases as the program does for --case-id, many in one process, for
// run_bad_inputs.py. A line of the input is a directory and the arguments of
// the program there, parted by tabs; its answer a line "STATUS TAB MESSAGE",
// with the exit status of the program.
#include <base/errors.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <input/command_line.h>
#include <input/dimension.h>
#include <input/parameter_file.h>

#include <simulation/case_identity.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace
{
  using namespace MixedCracks;

  template <int dim>
  void
  identify(const std::vector<SourceLine> &source, const CommandLine &command)
  {
    Parameters<dim>          parameters;
    dealii::ParameterHandler prm;
    read_case(source, command, parameters, prm);
    case_identity(parameters, prm, "problem");
  }

  std::string
  answer(const std::vector<std::string> &words)
  {
    std::vector<const char *> arguments;
    for (const std::string &word : words)
      arguments.push_back(word.c_str());
    try
    {
      std::filesystem::current_path(words.front());
      const CommandLine command = parse_command_line(
        static_cast<int>(arguments.size()), arguments.data());
      const auto source = read_source(command.file, MPI_COMM_WORLD);
      if (chosen_dimension(source, command.set) == 3)
        identify<3>(source, command);
      else
        identify<2>(source, command);
      return "0\t";
    }
    catch (const InputError &error)
    {
      return std::string("2\t") + error.what();
    }
    catch (const FileError &error)
    {
      return std::string("4\t") + error.what();
    }
    catch (const std::exception &error)
    {
      return std::string("1\tinternal error: ") + error.what();
    }
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (std::string line; std::getline(std::cin, line);)
  {
    // not split_string_list(), which drops blanks around words
    std::vector<std::string> words(1);
    for (const char c : line)
      if (c == '\t')
        words.emplace_back();
      else
        words.back() += c;
    std::string text = answer(words);
    std::replace(text.begin(), text.end(), '\n', '\v'); // still one line
    std::cout << text << std::endl;
  }
}
