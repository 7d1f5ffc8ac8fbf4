// SPDX-License-Identifier: GPL-2.0-or-later
// Names of input files. A relative one is looked for in the directory of the
// .prm that sets it; only if it is not there but in the working directory, that
// one is taken. They are made absolute so that parameters.prm, which a run
// writes, means the same files wherever it is read. The first rank decides for
// all, since file systems of nodes may differ.

#include <base/errors.h>
#include <base/text.h>

#include <deal.II/base/mpi.h>

#include <input/parameter_paths.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <filesystem>

namespace MixedCracks
{
  namespace fs = std::filesystem;

  bool
  names_input_file(const ParameterEntry &entry)
  {
    return entry.pattern_description.find("FileName (Type: input)") !=
           std::string::npos;
  }



  std::string
  absolute_path(const std::string &name, const std::string &folder)
  {
    const fs::path  path(name);
    std::error_code error;
    const fs::path  beside = fs::absolute(folder / path, error);
    if (path.is_absolute() || error)
      return name;
    const bool only_here =
      !folder.empty() && !fs::exists(beside, error) && fs::exists(path, error);
    return (only_here ? fs::absolute(path, error) : beside)
      .lexically_normal()
      .string();
  }



  std::vector<ParameterAssignment>
  with_absolute_paths(std::vector<ParameterAssignment> assignments,
                      const MPI_Comm                   comm)
  {
    std::vector<std::string> values;
    for (const ParameterAssignment &assignment : assignments)
      if (names_input_file(*assignment.entry) && !assignment.value.empty())
        values.push_back(absolute_path(assignment.value, assignment.folder));
    if (values.empty())
      return assignments;
    values    = dealii::Utilities::MPI::broadcast(comm, values, 0);
    auto next = values.begin();
    for (ParameterAssignment &assignment : assignments)
      if (names_input_file(*assignment.entry) && !assignment.value.empty())
      {
        // parameters.prm could not hold these
        if (next->find_first_of("#\n\r") != std::string::npos)
          throw InputError(assignment.place + ": " +
                           assignment.entry->full_name() + ": found " +
                           in_quotes(*next) +
                           ": a path cannot hold '#' or a line break.");
        assignment.value = *next++;
      }
    return assignments;
  }
} // namespace MixedCracks
