// SPDX-License-Identifier: GPL-2.0-or-later
// A process that mpirun starts: hands its place on to one that case_server
// makes of itself, which has all libraries, and waits for the end of it.
//
//   case_client SOCKET ARGUMENT ...
#include "case_socket.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

int
main(int argc, char **argv)
{
  using namespace CaseSocket;
  const int   connection = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address    = address_of(argc > 1 ? argv[1] : "");
  if (connect(connection,
              reinterpret_cast<sockaddr *>(&address),
              sizeof(address)) != 0)
  {
    std::perror("case_client");
    return 1;
  }
  Request request;
  request.directory = std::filesystem::current_path();
  request.arguments.assign(argv + 2, argv + argc);
  for (char **entry = environ; *entry != nullptr; ++entry)
    request.environment.emplace_back(*entry);
  send(connection, request);
  int status = 0;
  if (read(connection, &status, sizeof(status)) != sizeof(status))
  {
    std::fprintf(stderr, "case_client: a signal has ended the process\n");
    return 134;
  }
  return status;
}
