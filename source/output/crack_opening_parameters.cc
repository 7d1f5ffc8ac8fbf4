// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/coordinates.h>
#include <base/errors.h>
#include <base/text.h>

#include <deal.II/base/patterns.h>

#include <output/crack_opening_parameters.h>

#include <cmath>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const std::string lines_parameter = "Output/Crack opening";
    const double      tiny            = std::numeric_limits<double>::min();
    constexpr double  most_positions  = 10000.;

    template <int dim>
    Point<dim>
    read_point(const std::string &text)
    {
      const std::vector<double> numbers = parse_numbers(text, lines_parameter);
      if (numbers.size() != dim)
        throw InputError(lines_parameter + ": found '" + text +
                         "', allowed is " + std::to_string(dim) +
                         " numbers separated by commas.");
      Point<dim> point;
      set_coordinates(numbers, point);
      return point;
    }

    unsigned int
    read_number_of_positions(const std::string &text)
    {
      const double number = parse_number(text, lines_parameter);
      if (!(number >= 1. && number <= most_positions &&
            number == std::floor(number)))
        throw InputError(lines_parameter + ": found " + in_quotes(text) +
                         " positions, allowed is an integer from 1 to " +
                         std::to_string(static_cast<int>(most_positions)) +
                         ".");
      return static_cast<unsigned int>(number);
    }

    // The third part of four, of any length; otherwise, in the plane, the line
    // turned to the left by 90 degrees. The opening does not depend on its
    // sign.
    template <int dim>
    Tensor<1, dim>
    read_normal(const std::vector<std::string> &parts,
                const Tensor<1, dim>           &along)
    {
      Tensor<1, dim> normal;
      if (parts.size() == 4)
        normal = read_point<dim>(parts[2]);
      else
      {
        normal[0]       = -along[dim - 1];
        normal[dim - 1] = along[0];
      }
      const double size = normal.norm();
      if (!(size > 0.))
        throw InputError(lines_parameter + ": found no normal: it is 0, or "
                                           "the ends of the line are one "
                                           "point. Allowed is a vector with a "
                                           "direction.");
      return normal / size;
    }
  } // namespace



  template <int dim>
  Point<dim>
  OpeningLine<dim>::position(const unsigned int i) const
  {
    if (n_positions == 1)
      return begin;
    return begin + (end - begin) * (1. * i / (n_positions - 1));
  }



  template <int dim>
  void
  CrackOpeningParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter(
      "Crack volume",
      crack_volume,
      "Whether the volume between the faces of all cracks, the integral of u . "
      "grad(phi) times the thickness, is a column of statistics.csv and in "
      "summary.json. Unit of the result: mm^3.",
      Patterns::Bool());
    prm.add_parameter(
      "Crack opening",
      lines_text,
      "Where crack_opening.csv shall tell how wide a crack is open: 'begin : "
      "end : number of positions ; ...', the positions evenly spaced from begin "
      "to end. The opening at one of them is the integral of u . grad(phi) "
      "along the normal through it. In 3-d with a normal, 'begin : end : "
      "normal : number'; in 2-d it is that of the line unless it is given. "
      "Unit: mm.",
      Patterns::Anything());
    prm.add_parameter("Crack opening reach",
                      reach,
                      "How far the integral goes to either side: to where the "
                      "phase field is 1, and not to other cracks. Unit: "
                      "Model/Length scale.",
                      Patterns::Double(tiny));
    prm.leave_subsection();
  }



  template <int dim>
  std::vector<OpeningLine<dim>>
  CrackOpeningParameters<dim>::lines() const
  {
    std::vector<OpeningLine<dim>> result;
    for (const std::string &entry : split_list(lines_text, ';'))
    {
      const std::vector<std::string> parts = split_list(entry, ':');
      if (parts.size() != 4 && (dim == 3 || parts.size() != 3))
        throw InputError(lines_parameter + ": found '" + entry +
                         "', allowed is '" +
                         (dim == 2 ? "begin : end : number of positions"
                                   : "begin : end : normal : number of "
                                     "positions") +
                         "', several separated by ';'.");
      OpeningLine<dim> line;
      line.begin       = read_point<dim>(parts[0]);
      line.end         = read_point<dim>(parts[1]);
      line.normal      = read_normal<dim>(parts, line.end - line.begin);
      line.n_positions = read_number_of_positions(parts.back());
      result.push_back(line);
    }
    return result;
  }



  template <int dim>
  void
  CrackOpeningParameters<dim>::check() const
  {
    lines();
  }



  template struct OpeningLine<2>;
  template struct OpeningLine<3>;
  template struct CrackOpeningParameters<2>;
  template struct CrackOpeningParameters<3>;
} // namespace MixedCracks
