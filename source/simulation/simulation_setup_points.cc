// SPDX-License-Identifier: GPL-2.0-or-later
// Conditions and forces at points, with the vertices of point sets on the mesh.

#include <base/errors.h>

#include <deal.II/distributed/tria.h>

#include <simulation/simulation_setup.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // A value that is not finite is refused by the run that needs it, which may
    // be none: here it is but something else than 0.
    template <int dim>
    bool
    is_not_zero(const Function<dim> &function,
                const Point<dim>    &point,
                const unsigned int   component)
    {
      try
      {
        return function.value(point, component) != 0.;
      }
      catch (const InputError &)
      {
        return true;
      }
    }
  } // namespace



  template <int dim>
  std::vector<PointEntry<dim>>
  placed_points(const Parameters<dim>              &parameters,
                const std::vector<PointEntry<dim>> &entries,
                const Triangulation<dim>           &triangulation,
                const bool                          stands_for_finer)
  {
    const PointSets<dim>        &sets = parameters.geometry.point_sets();
    std::vector<PointEntry<dim>> result;
    for (PointEntry<dim> entry : entries)
    {
      if (entry.set.empty())
        result.push_back(entry);
      else
        for (const Point<dim> &point :
             stands_for_finer ? sets.points_near(entry.set, triangulation)
                              : sets.points_of(entry.set, triangulation))
        {
          entry.point = point;
          result.push_back(entry);
        }
    }
    return result;
  }



  template <int dim>
  std::vector<PrescribedPoint<dim>>
  prescribed_points(const Parameters<dim>    &parameters,
                    const unsigned int        n_components,
                    const Triangulation<dim> &triangulation,
                    const bool                stands_for_finer)
  {
    constexpr unsigned int            n_samples = 16;
    std::vector<PrescribedPoint<dim>> result;
    for (const auto &entry :
         placed_points(parameters,
                       parameters.boundary_conditions.point_displacements(),
                       triangulation,
                       stands_for_finer))
    {
      auto value = std::make_shared<ExpressionFunction<dim>>(n_components);
      value->set(entry.component, entry.expression);
      // the expression in t at the point: seen often enough
      bool moves = false;
      for (unsigned int i = 0; i <= n_samples && !moves; ++i)
      {
        value->set_time(parameters.load.end_time * i / n_samples);
        moves = is_not_zero(*value, entry.point, entry.component);
      }
      result.push_back({entry.point, entry.component, value, moves, entry.set});
    }
    return result;
  }



  // A force on each vertex of a set would grow with every vertex that
  // adaptation adds to it. Those of the first mesh are found on one that is
  // made anew, so that a resumed run, whose mesh is finer, has the same.
  template <int dim>
  std::vector<PointEntry<dim>>
  points_with_forces(const Parameters<dim>    &parameters,
                     const Triangulation<dim> &triangulation,
                     const bool                stands_for_finer)
  {
    const auto forces  = parameters.boundary_conditions.point_forces();
    bool       any_set = false;
    for (const PointEntry<dim> &entry : forces)
      any_set = any_set || !entry.set.empty();
    if (!any_set || stands_for_finer || parameters.mesh.adaptation == "none")
      return placed_points(parameters, forces, triangulation, stands_for_finer);
    parallel::distributed::Triangulation<dim> first(
      triangulation.get_communicator());
    make_mesh(parameters, first);
    return placed_points<dim>(parameters, forces, first);
  }



#define INSTANTIATE(dim)                                                      \
  template std::vector<PointEntry<dim>> placed_points(                        \
    const Parameters<dim> &,                                                  \
    const std::vector<PointEntry<dim>> &,                                     \
    const Triangulation<dim> &,                                               \
    bool);                                                                    \
  template std::vector<PrescribedPoint<dim>> prescribed_points(               \
    const Parameters<dim> &, unsigned int, const Triangulation<dim> &, bool); \
  template std::vector<PointEntry<dim>> points_with_forces(                   \
    const Parameters<dim> &, const Triangulation<dim> &, bool);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
