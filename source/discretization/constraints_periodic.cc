// SPDX-License-Identifier: GPL-2.0-or-later
// Periodic sides together with supports. A node x' = x + L is the image of x,
//
//   u(x') = u(x) + E(t) L,
//
// so that what is prescribed at x' is prescribed at x, less E L; where both
// are, they have to agree. Translations do not change a periodic body: each
// component that nothing prescribes is held at one vertex, whose reaction is 0.

#include <base/errors.h>
#include <base/log.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/function.h>

#include <deal.II/numerics/vector_tools.h>

#include <discretization/constraints.h>
#include <discretization/nearest_vertex.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // of values at images of a node
    constexpr double agreement = 1e-8;

    // Of the coarse mesh, so that it is a vertex of every finer one: the one
    // that is nearest to the corner with the least coordinates.
    template <int dim>
    Point<dim>
    vertex_at_corner(const Triangulation<dim> &mesh)
    {
      std::vector<Point<dim>> vertices;
      for (const auto &cell : mesh.cell_iterators_on_level(0))
        for (const unsigned int v : cell->vertex_indices())
          vertices.push_back(cell->vertex(v));
      const Point<dim> corner =
        BoundingBox<dim>(vertices).get_boundary_points().first;
      const auto is_nearer = [&corner](const auto &a, const auto &b) {
        return a.distance(corner) < b.distance(corner);
      };
      return *std::min_element(vertices.begin(), vertices.end(), is_nearer);
    }
  } // namespace



  template <int dim>
  void
  Constraints<dim>::hold_translations()
  {
    held.clear();
    if (!periodic_sides.any())
      return;
    vertex_held = vertex_at_corner(fields.elastic.get_triangulation());
    for (unsigned int d = 0; d < dim; ++d)
    {
      const auto is_of_it = [d](const auto &entry) {
        return entry.component == d;
      };
      if (std::none_of(prescribed.begin(), prescribed.end(), is_of_it) &&
          std::none_of(points.begin(), points.end(), is_of_it))
        held.push_back(d);
    }
    for (const unsigned int d : held)
      points.push_back({vertex_held,
                        d,
                        std::make_shared<Functions::ZeroFunction<dim>>(
                          fields.elastic.get_fe().n_components()),
                        false});
  }



  template <int dim>
  void
  Constraints<dim>::prescribe_images()
  {
    for (const auto &partner : periodic_sides.partners())
    {
      if (!prescribed_dofs.is_element(partner.slave))
        continue;
      if (!elastic_newton.is_constrained(partner.master))
        elastic_newton.add_line(partner.master);
      prescribed_dofs.add_index(partner.master);
    }
  }



  template <int dim>
  void
  Constraints<dim>::add_values_of_images(
    const double                               time,
    std::map<types::global_dof_index, double> &values) const
  {
    const Tensor<2, dim> strain = periodic_sides.strain_at(time);
    for (const auto &partner : periodic_sides.partners())
    {
      const auto given = values.find(partner.slave);
      if (given == values.end())
        continue;
      const double jump = (strain * partner.period)[partner.component];
      const auto [image, is_new] =
        values.insert({partner.master, given->second - jump});
      const double difference = given->second - image->second;
      const double scale      = std::max(
        {std::abs(given->second), std::abs(image->second), std::abs(jump)});
      if (is_new || std::abs(difference - jump) <= agreement * scale)
        continue;
      throw InputError(
        "Boundary conditions/Displacement: found " +
        std::string(1, "xyz"[partner.component]) + " = " +
        format("%.6g mm at ", given->second) + in_words(partner.position) +
        format(" and %.6g mm at its image ", image->second) +
        in_words(Point<dim>(partner.position - partner.period)) +
        format(
          ", t = %.6g, a difference of %.6g mm; allowed is that of Geometry/Periodic "
          "sides and Boundary conditions/Mean strain, %.6g mm.",
          time,
          difference,
          jump));
    }
  }



  template <int dim>
  void
  Constraints<dim>::add_mean_strain(const double           before,
                                    const double           after,
                                    LinearAlgebra::Vector &elastic) const
  {
    const Tensor<2, dim> change =
      periodic_sides.strain_at(after) - periodic_sides.strain_at(before);
    if (change.norm() == 0.)
      return;
    std::vector<std::function<double(const Point<dim> &)>> components(
      fields.elastic.get_fe().n_components(),
      [](const Point<dim> &) { return 0.; });
    for (unsigned int d = 0; d < dim; ++d)
      components[d] = [change, d](const Point<dim> &point) {
        return change[d] * Tensor<1, dim>(point);
      };
    LinearAlgebra::Vector more(elastic);
    VectorTools::interpolate(fields.mapping,
                             fields.elastic,
                             FunctionFromFunctionObjects<dim>(components),
                             more);
    elastic.add(1., more);
  }



  template <int dim>
  void
  Constraints<dim>::drop_periodic(LinearAlgebra::Vector &reaction) const
  {
    if (!periodic_sides.any())
      return;
    periodic_sides.fold(reaction);
    keep_prescribed(reaction);
  }



  // Each owner of a node that others depend on looks at these.
  template <int dim>
  void
  Constraints<dim>::spread_least(LinearAlgebra::Vector &phase_field) const
  {
    if (!periodic_sides.any())
      return;
    LinearAlgebra::Vector all = fields.ghosted_vector(fields.phase_field_dofs);
    all                       = phase_field;
    std::map<types::global_dof_index, double> least;
    for (const auto dof : fields.phase_field_dofs.relevant)
    {
      const auto *entries = phase_field_hanging.get_constraint_entries(dof);
      if (entries == nullptr || entries->size() != 1)
        continue;
      const auto master = (*entries)[0].first;
      if (!fields.phase_field_dofs.owned.is_element(master))
        continue;
      const double value = least.emplace(master, all(master)).first->second;
      least[master]      = std::min<double>(value, all(dof));
    }
    for (const auto &[dof, value] : least)
      phase_field(dof) = value;
    phase_field.compress(VectorOperation::insert);
  }



#define INSTANTIATE(dim)                                                 \
  template void Constraints<dim>::hold_translations();                   \
  template void Constraints<dim>::prescribe_images();                    \
  template void Constraints<dim>::add_values_of_images(                  \
    double, std::map<types::global_dof_index, double> &) const;          \
  template void Constraints<dim>::add_mean_strain(                       \
    double, double, LinearAlgebra::Vector &) const;                      \
  template void Constraints<dim>::drop_periodic(LinearAlgebra::Vector &) \
    const;                                                               \
  template void Constraints<dim>::spread_least(LinearAlgebra::Vector &) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
