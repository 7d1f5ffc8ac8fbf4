// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/errors.h>
#include <core/text.h>
#include <problem/geometries/checks.h>
#include <problem/mesh_parameters.h>

#include <deal.II/base/patterns.h>

#include <cmath>

namespace MixedCracks
{
  namespace
  {
    constexpr unsigned int max_levels = 12;

    template <int dim>
    dealii::Point<dim>
    parsed_point(const std::string &text, const std::string &parameter)
    {
      const std::vector<double> numbers = parse_numbers(text, parameter);
      if (numbers.size() != dim)
        throw InputError(parameter + ": the corner " + in_quotes(text) +
                         " needs " + std::to_string(dim) + " numbers.");
      dealii::Point<dim> point;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] = numbers[d];
      return point;
    }

    template <int dim>
    std::string
    corner_text(const dealii::Point<dim> &corner)
    {
      return point_text({corner.begin_raw(), corner.end_raw()});
    }

    // a box that refines nothing is a slip of the pen
    template <int dim>
    void
    require_overlap(const RefinedBox<dim>          &box,
                    const dealii::BoundingBox<dim> &extent)
    {
      const auto &[lower, upper] = extent.get_boundary_points();
      for (unsigned int d = 0; d < dim; ++d)
        require(box.lower[d] < upper[d] && box.upper[d] > lower[d],
                "Mesh/Refined boxes: the box from " + corner_text(box.lower) +
                  " to " + corner_text(box.upper) +
                  " lies outside the domain, which is between " +
                  corner_text(lower) + " and " + corner_text(upper) + " mm.");
    }
  } // namespace



  template <int dim>
  void
  MeshParameters<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.enter_subsection("Mesh");
    prm.add_parameter("Global refinements",
                      global_refinements,
                      "How often every cell of the coarse mesh is halved.",
                      Integer(0, max_levels));
    prm.add_parameter("Refined boxes",
                      boxes,
                      "Boxes whose cells are halved further: 'lower corner : "
                      "upper corner : levels ; ...', corners in mm, as in "
                      "'0,10 : 20,22 : 1'.",
                      Anything());
    prm.add_parameter("Adaptation",
                      adaptation,
                      "Refinement during the run. 'none': the mesh stays; "
                      "'predictor corrector': cells that a step damages are "
                      "refined within the step, and the step is corrected. "
                      "The length scale stays, h in its expression is that of "
                      "the mesh at the start.",
                      Selection("none|predictor corrector"));
    prm.add_parameter("Adaptive levels",
                      adaptive_levels,
                      "How many levels adaptation may add to the global "
                      "refinements.",
                      Integer(0, max_levels));
    prm.add_parameter("Phase-field threshold",
                      phase_field_threshold,
                      "Adaptation refines cells where the phase field falls "
                      "below this; dimensionless.",
                      Double(0., 1.));
    prm.add_parameter("Refinement margin",
                      refinement_margin,
                      "Cells within this distance of damaged nodes are refined "
                      "with them, so that a running crack does not meet coarse "
                      "cells at once. Unit: Model/Length scale.",
                      Double(0.));
    prm.leave_subsection();
  }



  template <int dim>
  void
  MeshParameters<dim>::check(
    const std::optional<dealii::BoundingBox<dim>> &extent) const
  {
    for (const RefinedBox<dim> &box : refined_boxes())
      if (extent)
        require_overlap(box, *extent);
    if (adaptation == "none" && adaptive_levels > 0)
      throw InputError("Mesh/Adaptive levels is " +
                       std::to_string(adaptive_levels) +
                       "; it must be 0 when Mesh/Adaptation is 'none'.");
  }



  template <int dim>
  std::vector<RefinedBox<dim>>
  MeshParameters<dim>::refined_boxes() const
  {
    const std::string            parameter = "Mesh/Refined boxes";
    std::vector<RefinedBox<dim>> result;
    for (const std::string &item : split_list(boxes, ';'))
    {
      const std::vector<std::string> parts = split_list(item, ':');
      if (parts.size() != 3)
        throw InputError(parameter + ": " + in_quotes(item) +
                         " is not of the form 'lower corner : upper corner "
                         ": levels'.");
      const double levels = parse_number(parts[2], parameter);
      if (!(levels >= 0. && levels == std::floor(levels) &&
            global_refinements + levels <= max_levels))
        throw InputError(
          parameter + ": the levels " + in_quotes(parts[2]) +
          " must be an integer from 0, and with Mesh/Global refinements of " +
          std::to_string(global_refinements) + " no more than " +
          std::to_string(max_levels) + ".");
      const RefinedBox<dim> box = {parsed_point<dim>(parts[0], parameter),
                                   parsed_point<dim>(parts[1], parameter),
                                   static_cast<unsigned int>(levels)};
      for (unsigned int d = 0; d < dim; ++d)
        if (!(box.lower[d] < box.upper[d]))
          throw InputError(parameter + ": in " + in_quotes(item) +
                           " every coordinate of the upper corner must be "
                           "greater than that of the lower one.");
      result.push_back(box);
    }
    return result;
  }



  template struct RefinedBox<2>;
  template struct MeshParameters<2>;
} // namespace MixedCracks
