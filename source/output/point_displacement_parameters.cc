// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/coordinates.h>
#include <base/errors.h>
#include <base/text.h>

#include <deal.II/base/patterns.h>

#include <output/point_displacement_parameters.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace MixedCracks
{
  namespace
  {
    // A name is part of a column of a CSV file: nothing that would have to be
    // quoted there, and no digit first.
    bool
    is_name(const std::string &text)
    {
      return std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
             std::all_of(text.begin(), text.end(), [](const unsigned char c) {
               return std::isalnum(c) != 0 || c == ' ' || c == '_' || c == '-';
             });
    }
  } // namespace



  template <int dim>
  std::string
  NamedPoint<dim>::column_name(const unsigned int component) const
  {
    std::string result = name;
    std::replace(result.begin(), result.end(), ' ', '_');
    return result + '_' + "xyz"[component] + "_mm";
  }



  template <int dim>
  void
  PointDisplacementParameters<dim>::add_parameters(
    dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter(
      "Displacement at points",
      text,
      "Points of the undeformed body whose displacement is in statistics.csv: "
      "'name : point ; ...', as in 'right corner : 48, 60', which makes the "
      "columns right_corner_x_mm and right_corner_y_mm. Any point of the body, "
      "not only vertices; where a slit passes, the mean of its two faces. Unit: "
      "mm.",
      dealii::Patterns::Anything());
    prm.leave_subsection();
  }



  template <int dim>
  std::vector<NamedPoint<dim>>
  PointDisplacementParameters<dim>::points() const
  {
    const std::string            parameter = name;
    std::vector<NamedPoint<dim>> result;
    std::set<std::string>        columns;
    for (const auto &parts : read_items(text, "name : point", parameter))
    {
      NamedPoint<dim> point{single_spaced(parts[0]), {}};
      if (!is_name(point.name))
        throw InputError(parameter + ": found the name " +
                         in_quotes(point.name) +
                         ", allowed are a letter and then letters, digits, "
                         "blanks, '_' and '-'.");
      // by columns: 'a b' and 'a_b' would have the same
      if (!columns.insert(point.column_name(0)).second)
        throw InputError(parameter + ": found the name " +
                         in_quotes(point.name) +
                         " twice, allowed are different names.");
      point.position = read_point<dim>(parts[1], parameter);
      result.push_back(point);
    }
    return result;
  }



  template <int dim>
  void
  PointDisplacementParameters<dim>::check() const
  {
    points();
  }



  template struct NamedPoint<2>;
  template struct NamedPoint<3>;
  template struct PointDisplacementParameters<2>;
  template struct PointDisplacementParameters<3>;
} // namespace MixedCracks
