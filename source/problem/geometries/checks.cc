// SPDX-License-Identifier: GPL-2.0-or-later
// What all geometries ask of their numbers, and numbers as messages print them.
//
// The coarse mesh is limited to a million cells: every rank holds all of it,
// while cells that are refined from it are distributed. A product of extents
// over cell size is compared as a floating-point number before any vector is
// allocated.

#include <base/errors.h>
#include <base/text.h>

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
  add_cell_size(dealii::ParameterHandler &prm, double &cell_size)
  {
    prm.add_parameter("Cell size",
                      cell_size,
                      "Wanted size of the cells of the coarse mesh, before "
                      "refinement; mm.",
                      dealii::Patterns::Double(0.));
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



  unsigned int
  coarser_number(const unsigned int n, const double factor)
  {
    return std::max(1L, std::lround(n / factor));
  }



  std::string
  coarser_numbers(const std::vector<unsigned int> &n, const double factor)
  {
    std::string result;
    for (const unsigned int each : n)
      result += (result.empty() ? "" : ", ") +
                std::to_string(coarser_number(each, factor));
    return result;
  }



  std::vector<unsigned int>
  read_cell_numbers(const std::string &text,
                    const unsigned int dim,
                    const std::string &parameter)
  {
    std::vector<unsigned int> result;
    double                    n_all = 1.;
    for (const double number : parse_numbers(text, parameter))
    {
      require(number >= 1. && number == std::floor(number),
              parameter + ": found " + number_text(number) +
                ", allowed are integers from 1.");
      n_all *= number;
      require(n_all <= 1e6,
              parameter + ": found " + in_quotes(text) +
                ", allowed are at most 1e+06 coarse cells in all (refine with "
                "the subsection Mesh instead).");
      result.push_back(static_cast<unsigned int>(number));
    }
    require(result.size() == dim,
            parameter + ": found " + in_quotes(text) + ", allowed are " +
              std::to_string(dim) + " numbers.");
    return result;
  }



  unsigned int
  read_id(const std::string &text,
          const std::string &kind,
          const std::string &parameter)
  {
    const double number = parse_number(text, parameter);
    require(number >= 0. && number <= 1e9 && number == std::floor(number),
            parameter + ": the " + kind + " id " + in_quotes(text) +
              " is no integer from 0 to 1000000000.");
    return static_cast<unsigned int>(number);
  }
} // namespace MixedCracks
