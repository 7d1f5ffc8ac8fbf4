// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/errors.h>
#include <problem/geometries/checks.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace MixedCracks
{
  std::string
  number_text(const double value)
  {
    std::ostringstream text;
    text << value;
    return text.str();
  }



  std::string
  point_text(const std::vector<double> &coordinates)
  {
    std::string text;
    for (const double coordinate : coordinates)
      text += (text.empty() ? "(" : ", ") + number_text(coordinate);
    return text + ")";
  }



  void
  require(const bool condition, const std::string &message)
  {
    if (!condition)
      throw InputError(message);
  }



  void
  require_positive(const double value, const std::string &parameter)
  {
    require(std::isfinite(value) && value > 0.,
            parameter + " is " + number_text(value) +
              "; it must be greater than 0.");
  }



  void
  require_cell_size(const double               cell_size,
                    const std::vector<double> &extents,
                    const std::string         &parameter)
  {
    constexpr double max_cells = 1e6;
    require_positive(cell_size, parameter);
    const double shortest = *std::min_element(extents.begin(), extents.end());
    require(cell_size <= shortest,
            parameter + " is " + number_text(cell_size) +
              " mm, more than the shortest side of " + number_text(shortest) +
              " mm.");
    double n_cells = 1.;
    for (const double extent : extents)
      n_cells *= extent / cell_size;
    require(n_cells <= max_cells,
            parameter + " is " + number_text(cell_size) + " mm, which makes " +
              number_text(n_cells) + " coarse cells; at most " +
              number_text(max_cells) +
              " are allowed (refine with the subsection Mesh instead).");
  }
} // namespace MixedCracks
