// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_errors_h
#define mixed_cracks_base_errors_h

#include <stdexcept>
#include <string>

namespace MixedCracks
{
  /// What the user got wrong: a name, a value, a combination. Its text is one
  /// message for a person: the parameter, what was found, what is allowed.
  /// The program prints it on one rank and leaves with exit status 2.
  class InputError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// A file that cannot be read or written; exit status 4.
  class FileError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// The equations cannot be solved where there is no load step to repeat;
  /// exit status 3. Thrown on all ranks.
  class SolverError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace MixedCracks

#endif
