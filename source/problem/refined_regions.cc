// SPDX-License-Identifier: GPL-2.0-or-later
// Regions that are fine from the start, as lists in the .prm: boxes, discs
// (balls in 3-d), and all that is nearer than a distance to something that the
// geometry has a name for. Levels are added to the global refinements; where
// regions overlap the largest number counts (discretization/refinement.cc).
//
// A box or disc outside of the body is refused: it would refine nothing, and
// the crack it was meant for would run through coarse cells. Without an extent,
// as of a mesh file, this is checked once there is a mesh.

#include <base/coordinates.h>
#include <base/errors.h>
#include <base/names.h>
#include <base/text.h>

#include <deal.II/base/patterns.h>

#include <problem/geometries/checks.h>
#include <problem/refined_regions.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace
  {
    const std::string boxes_entry        = "Mesh/Refined boxes";
    const std::string discs_entry        = "Mesh/Refined discs";
    const std::string surroundings_entry = "Mesh/Refined surroundings";

    template <int dim>
    std::string
    corner_text(const dealii::Point<dim> &corner)
    {
      const auto coordinates = coordinates_of(corner);
      return point_text({coordinates.begin(), coordinates.end()});
    }



    unsigned int
    parsed_levels(const std::string &text, const std::string &parameter)
    {
      const double levels = parse_number(text, parameter);
      if (!(levels >= 0. && levels == std::floor(levels) &&
            levels <= max_refinements))
        throw InputError(parameter + ": the levels " + in_quotes(text) +
                         " must be an integer from 0, and no more than " +
                         std::to_string(max_refinements) + ".");
      return static_cast<unsigned int>(levels);
    }



    double
    parsed_length(const std::string &text,
                  const std::string &what,
                  const std::string &parameter)
    {
      const double length = parse_number(text, parameter);
      require(length > 0.,
              parameter + ": the " + what + " " + in_quotes(text) +
                " must be greater than 0.");
      return length;
    }



    // what refines nothing is a slip of the pen
    template <int dim>
    void
    require_overlap(const dealii::Point<dim>       &lower,
                    const dealii::Point<dim>       &upper,
                    const dealii::BoundingBox<dim> &extent,
                    const std::string              &region)
    {
      const auto &[low, high] = extent.get_boundary_points();
      for (unsigned int d = 0; d < dim; ++d)
        require(lower[d] < high[d] && upper[d] > low[d],
                region + " lies outside the domain, which is between " +
                  corner_text(low) + " and " + corner_text(high) + " mm.");
    }



    template <int dim>
    dealii::Tensor<1, dim>
    diagonal(const double length)
    {
      dealii::Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = length;
      return result;
    }
  } // namespace



  template <int dim>
  void
  RefinedRegions<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Refined boxes",
                      boxes,
                      "Boxes whose cells are halved further: 'lower corner : "
                      "upper corner : levels ; ...', corners in mm, as in "
                      "'0,10 : 20,22 : 1', in 3-d '0,10,0 : 20,22,2 : 1'.",
                      dealii::Patterns::Anything());
    prm.add_parameter("Refined discs",
                      discs,
                      "The same in discs, in 3-d in balls: 'centre : radius : "
                      "levels ; ...', in mm, as in '12,18 : 5 : 1', in 3-d "
                      "'12,18,1 : 5 : 1'.",
                      dealii::Patterns::Anything());
    prm.add_parameter("Refined surroundings",
                      surroundings,
                      "The same around what the geometry has a name for, its "
                      "boundaries and the tip of its notch or slit: 'name : "
                      "distance : levels ; ...', distance in mm, as in 'notch "
                      "tip : 1.5 : 3 ; hole : 1 : 2'.",
                      dealii::Patterns::Anything());
  }



  template <int dim>
  std::vector<RefinedBox<dim>>
  RefinedRegions<dim>::refined_boxes() const
  {
    std::vector<RefinedBox<dim>> result;
    for (const auto &parts :
         read_items(boxes, "lower corner : upper corner : levels", boxes_entry))
    {
      const RefinedBox<dim> box = {read_point<dim>(parts[0], boxes_entry),
                                   read_point<dim>(parts[1], boxes_entry),
                                   parsed_levels(parts[2], boxes_entry)};
      for (unsigned int d = 0; d < dim; ++d)
        require(box.lower[d] < box.upper[d],
                boxes_entry + ": in " +
                  in_quotes(parts[0] + " : " + parts[1] + " : " + parts[2]) +
                  " every coordinate of the upper corner must be greater "
                  "than that of the lower one.");
      result.push_back(box);
    }
    return result;
  }



  template <int dim>
  std::vector<RefinedDisc<dim>>
  RefinedRegions<dim>::refined_discs() const
  {
    std::vector<RefinedDisc<dim>> result;
    for (const auto &parts :
         read_items(discs, "centre : radius : levels", discs_entry))
      result.push_back({read_point<dim>(parts[0], discs_entry),
                        parsed_length(parts[1], "radius", discs_entry),
                        parsed_levels(parts[2], discs_entry)});
    return result;
  }



  template <int dim>
  std::vector<RefinedSurroundings>
  RefinedRegions<dim>::refined_surroundings() const
  {
    std::vector<RefinedSurroundings> result;
    for (const auto &parts : read_items(
           surroundings, "name : distance : levels", surroundings_entry))
      result.push_back({single_spaced(parts[0]),
                        parsed_length(parts[1], "distance", surroundings_entry),
                        parsed_levels(parts[2], surroundings_entry)});
    return result;
  }



  template <int dim>
  void
  RefinedRegions<dim>::check(
    const unsigned int                             global_refinements,
    const std::optional<dealii::BoundingBox<dim>> &extent,
    const std::vector<std::string>                &names) const
  {
    const auto require_levels = [&](const unsigned int levels,
                                    const std::string &parameter) {
      require(global_refinements + levels <= max_refinements,
              parameter + ": the levels " + in_quotes(std::to_string(levels)) +
                ", with Mesh/Global refinements of " +
                std::to_string(global_refinements) + ", must be no more than " +
                std::to_string(max_refinements) + ".");
    };
    for (const RefinedBox<dim> &box : refined_boxes())
    {
      require_levels(box.levels, boxes_entry);
      if (extent)
        require_overlap(box.lower,
                        box.upper,
                        *extent,
                        boxes_entry + ": the box from " +
                          corner_text(box.lower) + " to " +
                          corner_text(box.upper));
    }
    for (const RefinedDisc<dim> &disc : refined_discs())
    {
      require_levels(disc.levels, discs_entry);
      if (extent)
        require_overlap(disc.center - diagonal<dim>(disc.radius),
                        disc.center + diagonal<dim>(disc.radius),
                        *extent,
                        discs_entry + ": the disc around " +
                          corner_text(disc.center));
    }
    for (const RefinedSurroundings &region : refined_surroundings())
    {
      require_levels(region.levels, surroundings_entry);
      require(std::find(names.begin(), names.end(), region.name) != names.end(),
              surroundings_entry + ": " +
                unknown_name_message(region.name, names));
    }
  }



  template struct RefinedBox<2>;
  template struct RefinedBox<3>;
  template struct RefinedDisc<2>;
  template struct RefinedDisc<3>;
  template struct RefinedRegions<2>;
  template struct RefinedRegions<3>;
} // namespace MixedCracks
