// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/coordinates.h>
#include <base/errors.h>
#include <base/names.h>
#include <base/text.h>

#include <deal.II/base/patterns.h>

#include <output/watched_boundaries_parameters.h>

#include <algorithm>
#include <set>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  std::vector<std::string>
  WatchedBoundary<dim>::column_names() const
  {
    std::string begin = name;
    std::replace(begin.begin(), begin.end(), ' ', '_');
    std::vector<std::string> result;
    const auto add = [&](const std::string &what, const std::string &unit) {
      for (unsigned int d = 0; d < dim; ++d)
        result.push_back(begin + what + "xyz"[d] + unit);
    };
    add("_force_", "_N");
    if (about && dim == 2)
      result.push_back(begin + "_moment_Nmm");
    if (about && dim == 3)
      add("_moment_", "_Nmm");
    add("_displacement_", "_mm");
    return result;
  }



  template <int dim>
  void
  WatchedBoundariesParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter(
      "Watched boundaries",
      text,
      "Boundaries whose force and mean displacement are further columns of "
      "statistics.csv: 'boundary ; ...', as in 'left ; hole ; right moment "
      "about 0, 0', which has the moment, too. Forces are those that supports "
      "and loads on the boundary exert on the body, in the directions of the "
      "axes. Unit: N, N mm, mm.",
      Patterns::Anything());
    prm.leave_subsection();
  }



  template <int dim>
  std::vector<WatchedBoundary<dim>>
  WatchedBoundariesParameters<dim>::boundaries(const NamedBoundaries &ids) const
  {
    const std::string        parameter = entry_name;
    const std::string        moment    = " moment about ";
    std::vector<std::string> names;
    for (const auto &boundary : ids)
      names.push_back(boundary.first);
    std::vector<WatchedBoundary<dim>> result;
    std::set<std::string>             columns;
    for (const std::string &given : split_list(text, ';'))
    {
      const std::string    entry = single_spaced(given);
      const std::size_t    at    = entry.find(moment);
      WatchedBoundary<dim> watched;
      watched.name     = entry.substr(0, at);
      const auto found = ids.find(watched.name);
      if (found == ids.end())
        throw InputError(parameter + ": boundary: " +
                         unknown_name_message(watched.name, names) +
                         " An entry is 'boundary' or 'boundary moment about " +
                         (dim == 2 ? "0, 0'." : "0, 0, 0'."));
      watched.ids = found->second;
      if (at != std::string::npos)
      {
        const std::string         place   = entry.substr(at + moment.size());
        const std::vector<double> numbers = parse_numbers(place, parameter);
        if (numbers.size() != dim)
          throw InputError(parameter + ": found " + in_quotes(entry) +
                           ", allowed is a point of " + std::to_string(dim) +
                           " numbers, as '" + (dim == 2 ? "0, 1" : "0, 1, 2") +
                           "'.");
        watched.about.emplace();
        set_coordinates(numbers, *watched.about);
      }
      // by columns: 'a b' and 'a_b' would have the same
      if (!columns.insert(watched.column_names().front()).second)
        throw InputError(parameter + ": found " + in_quotes(watched.name) +
                         " twice, allowed are different boundaries.");
      result.push_back(watched);
    }
    return result;
  }



  template struct WatchedBoundary<2>;
  template struct WatchedBoundary<3>;
  template struct WatchedBoundariesParameters<2>;
  template struct WatchedBoundariesParameters<3>;
} // namespace MixedCracks
