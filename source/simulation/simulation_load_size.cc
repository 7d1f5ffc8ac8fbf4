// SPDX-License-Identifier: GPL-2.0-or-later
// How large loads are, roughly, without a mesh: expressions are evaluated at
// the corners and the middle of the box around the body. Displacements become
// strains by the largest extent of the body, forces at points stresses by the
// smallest section of the box. Body forces are not looked at
// (is_known = false): what stress they make depends on the shape. Nor is an
// expression that has a value at none of these places.

#include <base/errors.h>
#include <base/finite_text.h>
#include <base/log.h>

#include <simulation/simulation_load_size.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

    // Of one component; nothing where it has no value at any of the places. It
    // need not have one outside of its boundary, so that this is no error here;
    // where a value is asked for and there is none, the run names the entry, at
    // t = 0 before the first step (simulation_setup_expressions.cc).
    template <int dim>
    std::optional<double>
    size_at(const Function<dim>           &function,
            const std::vector<Point<dim>> &places,
            const unsigned int             component)
    {
      std::optional<double> largest;
      for (const Point<dim> &place : places)
        try
        {
          largest = std::max(largest.value_or(0.),
                             std::abs(function.value(place, component)));
        }
        catch (const InputError &)
        {}
      return largest;
    }

    // Of cross sections of the box the smallest: mm^(dim - 1).
    template <int dim>
    double
    least_section(const BoundingBox<dim> &body)
    {
      double area = std::numeric_limits<double>::infinity();
      for (unsigned int d = 0; d < dim; ++d)
        area = std::min(area, body.volume() / body.side_length(d));
      return area;
    }

    template <int dim>
    std::optional<double>
    size_of(const unsigned int                   component,
            std::shared_ptr<const Expression>    expression,
            std::shared_ptr<const Rotation<dim>> rotation,
            const std::vector<Point<dim>>       &places,
            const double                         time)
    {
      ExpressionFunction<dim> value(dim);
      value.set(component, std::move(expression), std::move(rotation));
      value.set_time(time);
      return size_at<dim>(value, places, component);
    }
    template <int dim>
    std::optional<double>
    mean_strain_size(const Parameters<dim> &parameters, const double time)
    {
      try
      {
        return parameters.boundary_conditions
          .mean_strain(parameters.model.strain.is_finite())
          .at(time)
          .norm();
      }
      catch (const InputError &)
      {
        return {};
      }
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
    LoadSize                      result;
    result.is_known = given.body_force(dim) == nullptr;
    const auto add  = [&result](double                     &largest,
                               const std::optional<double> size) {
      largest         = std::max(largest, size.value_or(0.));
      result.is_known = result.is_known && size.has_value();
    };
    const auto size_at_points = [&](const PointEntry<dim> &entry) {
      return size_of<dim>(
        entry.component,
        entry.expression,
        nullptr,
        entry.set.empty() ? std::vector<Point<dim>>{entry.point} : places,
        time);
    };
    for (unsigned int d = 0; d < dim; ++d)
      extent = std::max(extent, body.side_length(d));
    for (const auto &entry : given.displacements())
      if (entry.component < dim)
        add(displacement,
            size_of<dim>(
              entry.component, entry.expression, entry.rotation, places, time));
    for (const auto &entry : given.point_displacements())
      add(displacement, size_at_points(entry));
    result.strain = displacement / extent;
    add(result.strain, mean_strain_size(parameters, time));
    for (const auto &[boundary, traction] : given.tractions(dim))
    {
      traction->set_time(time);
      for (unsigned int d = 0; d < dim; ++d)
        add(result.traction, size_at<dim>(*traction, places, d));
    }
    for (const auto &loads : {given.normal_tractions(), given.pressures()})
      for (const auto &[boundary, load] : loads)
      {
        load->set_time(time);
        add(result.traction, size_at<dim>(*load, places, 0));
      }
    const double area = parameters.thickness_factor() * least_section(body);
    for (const auto &entry : given.point_forces())
    {
      double stress = 0.;
      add(stress, size_at_points(entry));
      result.points = std::max(result.points, stress / area);
    }
    if (const auto pressure = parameters.fluid.pressure())
    {
      pressure->set_time(time);
      add(result.fluid, size_at<dim>(*pressure, places, 0));
    }
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
    add(load.points,
        format("forces at points of %.3g MPa on the smallest section",
               load.points));
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
