// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_run_directory_h
#define mixed_cracks_output_run_directory_h

#include <base/log.h>

#include <output/directory.h>
#include <output/parameters.h>

#include <optional>

namespace MixedCracks
{
  /// The output directory of a run, from the first look at it until its log is
  /// open. An earlier run that is to be replaced or continued is left as it is
  /// until nothing of the input can be refused any more. Throws FileError.
  /// Collective.
  class RunDirectory
  {
  public:
    /// @p effective_parameters: the complete .prm, to be kept with the results.
    RunDirectory(const OutputParameters &parameters,
                 const std::string      &effective,
                 const MPI_Comm          communicator,
                 Log                    &log)
      : directory(parameters.directory)
      , effective_parameters(effective)
      , communicator(communicator)
      , log(log)
    {}

    /// Refuse a directory that must not be written into, and change nothing.
    /// Whether it is free: then there is nothing to lose by opening it. Further
    /// @p names of files: see inspect_output_directory().
    bool inspect(ExistingRun existing, const std::vector<std::string> &names);

    /// Prepare it and open the log there; false when that was done before.
    bool open();

  private:
    const std::string          directory;
    const std::string          effective_parameters;
    const MPI_Comm             communicator;
    Log                       &log;
    std::vector<std::string>   names;
    std::optional<ExistingRun> waiting; // after inspect(), until it is open
  };

  /// What a run writes, relative to the output directory, folders with '/'
  /// behind; files that have a number in their names are recorded when they
  /// are written.
  std::vector<std::string> files_of_run(int                     dim,
                                        const OutputParameters &parameters,
                                        bool with_crack_openings);
} // namespace MixedCracks

#endif
