// SPDX-License-Identifier: GPL-2.0-or-later
// How large loads are, roughly, without a mesh: expressions are evaluated at
// the corners and the middle of the box around the body. Displacements become
// strains by the largest extent of the body. Body forces are not looked at
// (is_known = false): what stress they make depends on the shape.

#include <base/errors.h>
#include <base/finite_text.h>
#include <base/log.h>

#include <simulation/simulation_load_size.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::vector<Point<dim>>
    places_in(const BoundingBox<dim> &body)
    {
      std::vector<Point<dim>> result(1, body.center());
      for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
        result.push_back(body.vertex(v));
      return result;
    }

    // of one component; where it has no value, as outside of its boundary,
    // nothing is said
    template <int dim>
    double
    size_at(const Function<dim>           &function,
            const std::vector<Point<dim>> &places,
            const unsigned int             component)
    {
      double largest = 0.;
      for (const Point<dim> &place : places)
        try
        {
          largest =
            std::max(largest, std::abs(function.value(place, component)));
        }
        catch (const InputError &)
        {}
      return largest;
    }

    template <int dim>
    double
    size_of(std::shared_ptr<const Expression> expression,
            const std::vector<Point<dim>>    &places,
            const double                      time)
    {
      ExpressionFunction<dim> value(1);
      value.set(0, std::move(expression));
      value.set_time(time);
      return size_at<dim>(value, places, 0);
    }
  } // namespace



  template <int dim>
  LoadSize
  load_size(const Parameters<dim>  &parameters,
            const BoundingBox<dim> &body,
            const double            time)
  {
    const std::vector<Point<dim>> places = places_in(body);
    const auto                   &given  = parameters.boundary_conditions;
    double                        extent = 0., displacement = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      extent = std::max(extent, body.side_length(d));
    for (const auto &entry : given.displacements())
      if (entry.component < dim)
        displacement =
          std::max(displacement, size_of<dim>(entry.expression, places, time));
    for (const auto &entry : given.point_displacements())
      displacement = std::max(
        displacement, size_of<dim>(entry.expression, {entry.point}, time));

    LoadSize result;
    result.strain = displacement / extent;
    for (const auto &[boundary, traction] : given.tractions(dim))
    {
      traction->set_time(time);
      for (unsigned int d = 0; d < dim; ++d)
        result.traction =
          std::max(result.traction, size_at<dim>(*traction, places, d));
    }
    if (const auto pressure = parameters.fluid.pressure())
    {
      pressure->set_time(time);
      result.fluid = size_at<dim>(*pressure, places, 0);
    }
    result.is_known = given.body_force(dim) == nullptr;
    return result;
  }



  template <int dim>
  BoundingBox<dim>
  coarse_extent(const Triangulation<dim> &triangulation)
  {
    std::vector<Point<dim>> points;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const unsigned int v : cell->vertex_indices())
        points.push_back(cell->vertex(v));
    return BoundingBox<dim>(points);
  }



  std::string
  in_words(const LoadSize &load)
  {
    std::string text;
    const auto  add = [&](const double size, const std::string &what) {
      if (size > 0.)
        text += (text.empty() ? "" : ", ") + what;
    };
    add(load.strain, format("strains of about %.2g", printable(load.strain)));
    add(load.traction, format("tractions of %.3g MPa", load.traction));
    add(load.fluid, format("a fluid pressure of %.3g MPa", load.fluid));
    return text;
  }



#define INSTANTIATE(dim)                                        \
  template LoadSize load_size(                                  \
    const Parameters<dim> &, const BoundingBox<dim> &, double); \
  template BoundingBox<dim> coarse_extent(const Triangulation<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
