// SPDX-License-Identifier: GPL-2.0-or-later
// statistics.csv. Numbers in the classic locale, at most 10 significant digits,
// counts with 17 (all integers up to 2^53), costs with 4; what is not finite is
// an empty field. Names of columns are quoted where they need it (RFC 4180): a
// field with a comma, a quotation mark or the end of a line stands in quotation
// marks, and those inside are doubled. Numbers never need it.
//
// Each row is flushed: a run that is killed loses at most the row being
// written. A resumed run writes the table anew from its checkpoint, so that a
// row that was cut off, or is of a step computed again, cannot stay.

#include <base/finite_text.h>

#include <deal.II/base/mpi.h>

#include <output/quantities.h>
#include <output/small_file.h>
#include <output/statistics.h>

#include <iomanip>
#include <sstream>

namespace MixedCracks
{
  void
  StatisticsTable::open(const std::string              &file_name,
                        const int                       dim,
                        const std::vector<std::string> &asked,
                        const std::vector<std::string> &point_columns,
                        const std::vector<std::string> &reaction_columns)
  {
    columns.clear();
    std::vector<std::string> names;
    for (const Quantity &quantity : all_quantities())
      if (quantity.has_column(dim, asked))
      {
        columns.push_back(&quantity);
        names.push_back(quantity.column(dim));
      }
    names.insert(names.end(), point_columns.begin(), point_columns.end());
    names.insert(names.end(), reaction_columns.begin(), reaction_columns.end());
    n_point_columns    = point_columns.size();
    n_reaction_columns = reaction_columns.size();
    name               = file_name;
    on_first_rank(communicator, [&]() {
      file.open(name);
      for (std::size_t i = 0; i < names.size(); ++i)
        file << (i > 0 ? "," : "") << csv_field(names[i]);
      if (!(file << '\n' << std::flush))
        throw FileError("Output/Directory: '" + name + "' cannot be written.");
    });
  }



  void
  StatisticsTable::restore(const std::vector<StatisticsRow> &earlier)
  {
    for (const StatisticsRow &row : earlier)
      add(row);
  }



  std::string
  StatisticsTable::line(const StatisticsRow &row) const
  {
    std::ostringstream out;
    out.imbue(csv_locale());
    for (const Quantity *quantity : columns)
    {
      const int digits = quantity->format == Quantity::Format::cost    ? 4
                         : quantity->format == Quantity::Format::count ? 17
                                                                       : 10;
      // what was asked for later only is empty in the rows before
      out << std::setprecision(digits)
          << value_of(*quantity, row, table.front())
          << (quantity == columns.back() ? "" : ",");
    }
    const auto write = [&out](const std::vector<double> &values,
                              const std::size_t          n) {
      out << std::setprecision(10);
      for (std::size_t i = 0; i < n; ++i)
      {
        out << ',';
        if (i < values.size())
          out << values[i];
      }
    };
    write(row.point_displacements, n_point_columns);
    write(row.reactions, n_reaction_columns);
    out << '\n';
    return out.str();
  }



  void
  StatisticsTable::add(const StatisticsRow &row)
  {
    table.push_back(row);
    on_first_rank(communicator, [&]() {
      if (!(file << line(row) << std::flush))
        throw FileError("Output/Directory: '" + name +
                        "' cannot be written any more; is the disk full?");
    });
  }
} // namespace MixedCracks
