// SPDX-License-Identifier: GPL-2.0-or-later
// A quantity is kept, evaluated from the fields once and stored in the row, or
// derived from rows when it is written. Derived ones are in no checkpoint, so
// that a new one needs no new format. One that was not asked for in an earlier
// piece of a run is NaN in its rows, an empty field of the table.

#include <base/ranges.h>

#include <output/quantities.h>

#include <ostream>

namespace MixedCracks
{
  namespace
  {
    // behind the others, in the table of doc/output.md
    const std::string at_points =
      "| `NAME_x_mm`, `NAME_y_mm` (3-d: `NAME_z_mm`) | only with "
      "`Output/Displacement at points = NAME : point ; ...`: displacement of "
      "these points of the undeformed body, anywhere in it; blanks in a name "
      "become `_`. They are found again on every new mesh; a point outside is "
      "refused. On a slit, where there are two displacements, it is their mean "
      "|\n"
      "| `reaction_1_x_N`, ... | only with `Boundary conditions/Displacement at "
      "points`: reaction of each component that is prescribed there, as it acts "
      "on the body, of the whole body: in 2-d with thickness. The number is "
      "that of the point in the order of the entry, from 1; a point set has its "
      "name, blanks as `_`, and the sum over its points. On a slit, the sum of "
      "both faces |\n";
  } // namespace



  std::string
  Quantity::column(const int dim) const
  {
    const bool is_other = dim == 3 && !name_in_3d.empty();
    return is_other       ? name_in_3d + '_' + unit_in_3d
           : unit.empty() ? name
                          : name + '_' + unit;
  }



  bool
  Quantity::has_column(const int                       dim,
                       const std::vector<std::string> &asked) const
  {
    return (has_2d || dim == 3) && (entry.empty() || contains(asked, entry));
  }



  template <int dim>
  StatisticsRow
  evaluate_quantities(const Measurement<dim>         &step,
                      const std::vector<std::string> &asked)
  {
    StatisticsRow row;
    for (const Quantity &quantity : all_quantities())
      if (quantity.is_kept() && quantity.has_column(dim, asked))
        row[quantity.name] = quantity.evaluate(step);
    return row;
  }



  double
  value_of(const Quantity      &quantity,
           const StatisticsRow &row,
           const StatisticsRow &first)
  {
    return quantity.is_kept() ? row[quantity.name]
                              : quantity.derive(row, first);
  }



  void
  print_quantities(std::ostream &out)
  {
    out << "| column | meaning |\n|---|---|\n";
    for (const Quantity &quantity : all_quantities())
    {
      out << "| `" << quantity.column(2) << '`';
      if (!quantity.has_2d)
        out << " (3-d only)";
      if (quantity.column(3) != quantity.column(2))
        out << " (3-d: `" << quantity.column(3) << "`)";
      out << " | ";
      if (!quantity.entry.empty())
        out << "only with `" << quantity.entry << "`: ";
      out << quantity.sentence << " |\n";
    }
    out << at_points;
  }



  template StatisticsRow evaluate_quantities(const Measurement<2> &,
                                             const std::vector<std::string> &);
  template StatisticsRow evaluate_quantities(const Measurement<3> &,
                                             const std::vector<std::string> &);
} // namespace MixedCracks
