// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_standard_streams_h
#define mixed_cracks_base_standard_streams_h

#include <string>

namespace MixedCracks
{
  /// Take standard input, output and error where whoever started the program
  /// has closed them: otherwise a file of the run, or of a library, would get
  /// the place of one and all that is said with it. Nothing can be written to
  /// what was taken.
  void occupy_standard_streams();

  /// From now on a pipe that nobody reads any more (tee has gone, head has
  /// enough) is an error of the stream, which then falls silent, and not the
  /// end of the program.
  void survive_closed_pipes();

  /// What went wrong with std::cout so far, for a person; empty when all that
  /// was written has arrived. Flushes it.
  std::string failure_of_output();
} // namespace MixedCracks

#endif
