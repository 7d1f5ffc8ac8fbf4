// SPDX-License-Identifier: GPL-2.0-or-later
// Does with many cases, one after the other, what the program does with one on
// one rank, so that libraries are loaded once (program.py has the other end). A
// line of the input is a directory, the files for standard output and error,
// and the arguments of the program there, parted by tabs; its answer a line
// with the exit status of the program.
#include <deal.II/base/mpi.h>

#include <base/single_process.h>

#include <simulation/case_run.h>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

namespace
{
  using namespace MixedCracks;

  std::vector<std::string>
  words_of(const std::string &line)
  {
    // not split_string_list(), which drops blanks around words
    std::vector<std::string> words(1);
    for (const char c : line)
      if (c == '\t')
        words.emplace_back();
      else
        words.back() += c;
    return words;
  }



  void
  redirect(const int stream, const std::string &path)
  {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0 || dup2(file, stream) < 0)
      throw std::runtime_error("cannot write to " + path);
    close(file);
  }



  int
  run(const std::vector<std::string> &words)
  {
    std::filesystem::current_path(words.at(0));
    redirect(STDOUT_FILENO, words.at(1));
    redirect(STDERR_FILENO, words.at(2));
    std::vector<const char *> arguments(1, "mixed-cracks");
    for (std::size_t i = 3; i < words.size(); ++i)
      arguments.push_back(words[i].c_str());
    const int status = exit_status([&arguments]() {
      return run_case(parse_command_line(static_cast<int>(arguments.size()),
                                         arguments.data()));
    });
    std::cout.flush();
    std::fflush(nullptr);
    return status;
  }
} // namespace

int
main(int argc, char **argv)
{
  prepare_single_process();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const int                                      answers = dup(STDOUT_FILENO);
  for (std::string line; std::getline(std::cin, line);)
    dprintf(answers, "%d\n", run(words_of(line)));
}
