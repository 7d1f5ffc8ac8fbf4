// SPDX-License-Identifier: GPL-2.0-or-later
// Points by position: the vertices v of the active cells with c(v) != 0. Every
// rank looks at its own cells; what is found is put in order, so that it does
// not depend on how the mesh is distributed. A vertex that several ranks have
// is the same number on each, as all of them compute it from the same coarse
// mesh.

#include <base/collective.h>
#include <base/coordinates.h>
#include <base/errors.h>
#include <base/names.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/patterns.h>

#include <problem/point_sets.h>

#include <algorithm>

namespace MixedCracks
{
  using dealii::Point;
  using dealii::Triangulation;

  namespace
  {
    const std::string point_sets_path = "Geometry/Point sets";

    // of cells whose vertices are looked through for those that a message names
    constexpr double most_cells_for_nearest = 30000.;



    template <int dim>
    void
    order(std::vector<Point<dim>> &points)
    {
      std::sort(points.begin(), points.end(), [](const auto &a, const auto &b) {
        return coordinates_of(a) < coordinates_of(b);
      });
      points.erase(std::unique(points.begin(), points.end()), points.end());
    }



    // Those that @p belongs names; it may throw on one rank alone.
    template <int dim, typename Predicate>
    std::vector<Point<dim>>
    vertices_where(const Triangulation<dim> &triangulation,
                   const Predicate          &belongs)
    {
      const MPI_Comm          communicator = triangulation.get_communicator();
      std::vector<Point<dim>> points;
      together(communicator, [&]() {
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned())
            for (const unsigned int v : cell->vertex_indices())
              if (belongs(cell->vertex(v)))
                points.push_back(cell->vertex(v));
      });
      order(points);
      std::vector<Point<dim>> all;
      for (const auto &part :
           dealii::Utilities::MPI::all_gather(communicator, points))
        all.insert(all.end(), part.begin(), part.end());
      order(all);
      return all;
    }



    template <int dim>
    std::vector<Point<dim>>
    candidates(const Triangulation<dim> &triangulation)
    {
      if (triangulation.n_global_active_cells() <= most_cells_for_nearest)
        return vertices_where(triangulation,
                              [](const Point<dim> &) { return true; });
      std::vector<Point<dim>> points;
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const unsigned int v : cell->vertex_indices())
          points.push_back(cell->vertex(v));
      order(points);
      return points;
    }
  } // namespace



  template <int dim>
  void
  PointSets<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter(
      "Point sets",
      sets,
      "Names for vertices of the mesh by their position, as for supports: 'name "
      ": condition ; ...', as in 'roller : abs(x - 10) < 0.5 && y < 1e-6'. The "
      "condition is an expression in x, y, z (mm; comparisons, && and ||). A "
      "set has all vertices of the present cells where it holds, one at least, "
      "and more when the mesh becomes finer there; hanging nodes follow their "
      "neighbours. Boundary conditions/Displacement at points and Force at "
      "points take the names in the place of a point.",
      dealii::Patterns::Anything());
  }



  template <int dim>
  void
  PointSets<dim>::check() const
  {
    parse_named_conditions<dim>(sets, point_sets_path);
  }



  template <int dim>
  std::vector<std::string>
  PointSets<dim>::names() const
  {
    std::vector<std::string> result;
    for (const auto &set : parse_named_conditions<dim>(sets, point_sets_path))
      result.push_back(set.name);
    return result;
  }



  template <int dim>
  NamedCondition<dim>
  PointSets<dim>::condition_of(const std::string &name) const
  {
    for (const auto &set : parse_named_conditions<dim>(sets, point_sets_path))
      if (set.name == name)
        return set;
    throw InputError(point_sets_path + ": " +
                     unknown_name_message(name, names()));
  }



  template <int dim>
  std::vector<Point<dim>>
  PointSets<dim>::points_of(const std::string        &name,
                            const Triangulation<dim> &triangulation) const
  {
    const NamedCondition<dim>     set    = condition_of(name);
    const std::vector<Point<dim>> points = vertices_where(
      triangulation, [&](const Point<dim> &p) { return set.holds_at(p); });
    if (points.empty())
      throw InputError(point_sets_path + ": found '" + name + " : " +
                       set.condition.text() +
                       "', which holds at no vertex of the mesh. Allowed is "
                       "what holds at one; " +
                       nearest_in_words(set, candidates(triangulation)) + ".");
    return points;
  }



  template <int dim>
  std::vector<Point<dim>>
  PointSets<dim>::points_near(const std::string        &name,
                              const Triangulation<dim> &triangulation) const
  {
    const NamedCondition<dim>     set    = condition_of(name);
    const std::vector<Point<dim>> points = vertices_where(
      triangulation, [&](const Point<dim> &p) { return set.holds_at(p); });
    return points.empty() ? nearest_points(set, candidates(triangulation))
                          : points;
  }



  template class PointSets<2>;
  template class PointSets<3>;
} // namespace MixedCracks
