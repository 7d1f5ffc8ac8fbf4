// SPDX-License-Identifier: GPL-2.0-or-later
// Starts the program for case_client, without loading its libraries again:
// this process has them, and each case has a copy of it (fork), which starts
// MPI as the rank that its client is. Ends with its standard input.
//
//   case_server SOCKET
#include "case_socket.h"

#include <deal.II/base/mpi.h>

#include <base/memory.h>
#include <base/single_process.h>

#include <simulation/case_run.h>

#include <csignal>
#include <filesystem>
#include <iostream>

#include <fcntl.h>
#include <poll.h>

namespace
{
  using namespace MixedCracks;

  void
  take_the_place(const CaseSocket::Request &request)
  {
    for (int stream = 0; stream < 3; ++stream)
    {
      dup2(request.streams[stream], stream);
      close(request.streams[stream]);
    }
    clearenv();
    for (const std::string &entry : request.environment)
    {
      const std::size_t equals = entry.find('=');
      setenv(
        entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
    }
    std::filesystem::current_path(request.directory);
  }



  // The same as main() of the program, but for what it does for questions and
  // for streams that are closed.
  int
  run(const CaseSocket::Request &request)
  {
    take_the_place(request);
    std::vector<std::string> words(1, "mixed-cracks");
    words.insert(
      words.end(), request.arguments.begin(), request.arguments.end());
    std::vector<char *> pointers;
    for (std::string &word : words)
      pointers.push_back(word.data());
    int    argc = static_cast<int>(pointers.size());
    char **argv = pointers.data();
    return_large_blocks();
    prepare_single_process();
    const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    try
    {
      return exit_status(
        [&]() { return run_case(parse_command_line(argc, argv)); });
    }
    catch (const std::exception &error)
    {
      std::cerr << "mixed-cracks: internal error: " << error.what()
                << std::endl;
      MPI_Abort(MPI_COMM_WORLD, 1);
      return 1;
    }
  }



  void
  serve(const int connection)
  {
    const CaseSocket::Request request = CaseSocket::receive(connection);
    if (fork() == 0)
    {
      std::signal(SIGCHLD, SIG_DFL);
      // SIGIO ends a rank whose client has been ended, as by mpirun
      fcntl(connection, F_SETOWN, getpid());
      fcntl(connection, F_SETFL, O_ASYNC);
      const int status = run(request);
      std::cout.flush();
      std::cerr.flush();
      const bool is_said =
        write(connection, &status, sizeof(status)) == sizeof(status);
      _exit(is_said ? 0 : 1); // what the server has at exit is its own
    }
    for (const int stream : request.streams)
      close(stream);
  }
} // namespace

int
main(int argc, char **argv)
{
  std::signal(SIGCHLD, SIG_IGN); // nobody waits for those that have ended
  const int   listening = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address   = CaseSocket::address_of(argc > 1 ? argv[1] : "");
  if (bind(listening,
           reinterpret_cast<sockaddr *>(&address),
           sizeof(address)) != 0 ||
      listen(listening, 64) != 0)
  {
    std::perror("case_server");
    return 1;
  }
  std::cout << "ready" << std::endl;
  for (;;)
  {
    pollfd events[2] = {{listening, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}};
    if (poll(events, 2, -1) < 0)
      continue;
    if (events[1].revents != 0)
      return 0;
    const int connection = accept(listening, nullptr, nullptr);
    if (connection >= 0)
      serve(connection);
    close(connection);
  }
}
