// SPDX-License-Identifier: GPL-2.0-or-later
// Names of input files. A relative one is looked for in the directory of the
// .prm that sets it; only if it is not there but in the working directory, that
// one is taken. They are made absolute so that parameters.prm, which a run
// writes, means the same files wherever it is read. The first rank decides for
// all, since file systems of nodes may differ.

#include <base/errors.h>
#include <base/text.h>
#include <base/time_table.h>

#include <deal.II/base/mpi.h>

#include <input/parameter_paths.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <filesystem>

namespace MixedCracks
{
  namespace fs = std::filesystem;

  namespace
  {
    // Names that are the value, or stand in it: table("load.csv").
    bool
    has_path(const ParameterAssignment &assignment)
    {
      return (names_input_file(*assignment.entry) &&
              !assignment.value.empty()) ||
             !table_calls(assignment.value).empty();
    }



    std::string
    with_absolute_path(const ParameterAssignment &assignment)
    {
      if (names_input_file(*assignment.entry))
        return absolute_path(assignment.value, assignment.folder);
      return replace_tables(assignment.value, [&](const TableCall &call) {
        return "table(\"" + absolute_path(call.path, assignment.folder) + "\")";
      });
    }



    // What the place of a path cannot hold, in parameters.prm or in a list.
    void
    require_possible_path(const ParameterAssignment &assignment,
                          const std::string         &value)
    {
      const auto require_without = [&](const std::string &path,
                                       const std::string &characters,
                                       const std::string &in_words) {
        if (path.find_first_of(characters) != std::string::npos)
          throw InputError(assignment.place + ": " +
                           assignment.entry->full_name() + ": found " +
                           in_quotes(path) + ": a path cannot hold " +
                           in_words + ".");
      };
      if (names_input_file(*assignment.entry))
        require_without(value, "#\n\r", "'#' or a line break");
      else
        for (const TableCall &call : table_calls(value))
          require_without(call.path,
                          "#;:\n\r",
                          "'#', ';', ':' or a line break in table(...)");
    }
  } // namespace



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
      if (has_path(assignment))
        values.push_back(with_absolute_path(assignment));
    if (values.empty())
      return assignments;
    values    = dealii::Utilities::MPI::broadcast(comm, values, 0);
    auto next = values.begin();
    for (ParameterAssignment &assignment : assignments)
      if (has_path(assignment))
      {
        require_possible_path(assignment, *next);
        assignment.value = *next++;
      }
    return assignments;
  }
} // namespace MixedCracks
