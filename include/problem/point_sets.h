// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_point_sets_h
#define mixed_cracks_problem_point_sets_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <problem/named_conditions.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// The entry "Geometry/Point sets": vertices of the mesh by their position.
  template <int dim>
  class PointSets
  {
  public:
    /// The caller has entered the subsection "Geometry".
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError when the entry cannot be read.
    void check() const;

    /// The names, in the order of the entry.
    std::vector<std::string> names() const;

    /// The vertices of active cells of all ranks that the set @p name has, in
    /// the order of x, then y, then z, without repetition; mm. The same on
    /// every rank. Throws InputError for an unknown name and, naming the
    /// nearest vertices, for a set without any. Collective.
    std::vector<dealii::Point<dim>>
    points_of(const std::string                &name,
              const dealii::Triangulation<dim> &triangulation) const;

    /// The same on a mesh that stands for a finer one: the nearest vertices
    /// where the set has none. Collective.
    std::vector<dealii::Point<dim>>
    points_near(const std::string                &name,
                const dealii::Triangulation<dim> &triangulation) const;

  private:
    NamedCondition<dim> condition_of(const std::string &name) const;

    std::string sets;
  };
} // namespace MixedCracks

#endif
