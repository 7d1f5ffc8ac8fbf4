// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/coordinates.h>
#include <base/errors.h>
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
    const std::string                 parameter = entry_name;
    const std::string                 moment    = " moment about ";
    std::vector<WatchedBoundary<dim>> result;
    std::set<std::string>             columns;
    for (const std::string &given : split_list(text, ';'))
    {
      const std::string    entry = single_spaced(given);
      const std::size_t    at    = entry.find(moment);
      WatchedBoundary<dim> watched;
      watched.name = entry.substr(0, at);
      watched.ids  = boundary_of(watched.name, ids, parameter, []() {
        return std::string(
                 "An entry is 'boundary' or 'boundary moment about ") +
               (dim == 2 ? "0, 0'." : "0, 0, 0'.");
      });
      if (at != std::string::npos)
        watched.about =
          read_point<dim>(entry.substr(at + moment.size()), parameter, entry);
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
