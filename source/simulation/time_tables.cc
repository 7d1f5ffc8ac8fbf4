// SPDX-License-Identifier: GPL-2.0-or-later
// The files of table("load.csv"). A table that ends before the run is refused
// rather than continued: whether the last value or the last slope is meant is
// not for the program to guess.

#include <base/errors.h>
#include <base/log.h>
#include <base/time_table.h>

#include <input/parameter_tree.h>

#include <problem/geometries/mesh_reader.h>

#include <simulation/time_tables.h>

namespace MixedCracks
{
  namespace
  {
    // body(entry, call) for every table
    template <typename Body>
    void
    for_each_table(const dealii::ParameterHandler &prm, const Body &body)
    {
      const ParameterTree tree(prm);
      for (const ParameterEntry &entry : tree.entries())
        for (const TableCall &call : table_calls(entry.value))
          body(entry.full_name(), call);
    }
  } // namespace



  void
  read_time_tables(const dealii::ParameterHandler &prm,
                   const MPI_Comm                  communicator)
  {
    for_each_table(prm, [&](const std::string &entry, const TableCall &call) {
      TimeTable         table;
      const std::string problem =
        table.read(read_file_once(call.path, communicator, entry));
      if (!problem.empty())
        throw FileError(entry + ": the table '" + call.path + "' " + problem +
                        ".");
      keep_time_table(call.path, table);
    });
  }



  void
  require_time_tables_until(const double                    end_time,
                            const dealii::ParameterHandler &prm)
  {
    for_each_table(prm, [&](const std::string &entry, const TableCall &call) {
      const double last = kept_time_table(call.path)->last_time();
      if (last < end_time)
        throw InputError(
          entry + ": the table '" + call.path +
          format("' ends at t = %.10g s, found Load stepping/End time = %.10g. "
                 "Allowed are tables that reach the end time.",
                 last,
                 end_time));
    });
  }
} // namespace MixedCracks
