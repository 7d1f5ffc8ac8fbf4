// SPDX-License-Identifier: GPL-2.0-or-later
// Who starts the program may have closed a standard stream, or close the pipe
// that reads it. A closed one would give its number, 0 to 2, to the next file
// that is opened, which would then get the log; a closed pipe would kill the
// run by SIGPIPE in the middle of a step.

#include <base/standard_streams.h>

#include <csignal>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

namespace MixedCracks
{
  void
  occupy_standard_streams()
  {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      if (fcntl(stream, F_GETFD) < 0)
        // it gets the smallest number that is free, which is this one
        if (open("/dev/null", O_RDONLY) < 0)
          return;
  }



  void
  survive_closed_pipes()
  {
    std::signal(SIGPIPE, SIG_IGN);
  }



  std::string
  failure_of_output()
  {
    std::cout.flush();
    return std::cout ? ""
                     : "standard output: not all could be written; is the "
                       "disk full?";
  }
} // namespace MixedCracks
