// SPDX-License-Identifier: GPL-2.0-or-later
// u(x) = sum_a N_a(xi) u_a in the cell K that contains x, xi = F_K^-1(x) within
// 1e-6 of the unit cell. On sides and vertices several cells contain x. They
// make fans, cells that are neighbours across a side with x on it:
//
//     \  |  /         one around a vertex within the body;
//    ---x----slit      one around the tip of a slit;
//     /  |  \          two at a vertex on a slit, one at each of its faces
//
// u is the same in all cells of a fan. The result is the mean over the fans, in
// each the mean over its n cells,
//
//   u(x) = sum_K (u_K / n_K) / sum_K (1 / n_K),
//
// so that both faces of a slit count the same, whatever the cells there. A
// rank sums over its own cells; n_K includes those of others, which touch K and
// are ghosts.
//
// Cells are found once per mesh: the box around K, made larger by a quarter of
// the diameter, decides before F_K is inverted.

#include <base/errors.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <deal.II/matrix_free/fe_point_evaluation.h>

#include <discretization/nearest_vertex.h>

#include <output/point_displacements.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // Of the unit cell: what lies so near belongs to both neighbours, and to
    // the body. Coordinates in a .prm are rounded.
    constexpr double tolerance = 1e-6;

    // of the size of a cell: how far a curved side may reach beyond the box
    // around the vertices
    constexpr double bulge = 0.25;
  } // namespace



  template <int dim>
  void
  PointDisplacements<dim>::find_in(const Cell &cell)
  {
    auto box = cell->bounding_box();
    box.extend(bulge * cell->diameter());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (!box.point_inside(points[i].position))
        continue;
      try
      {
        const Point<dim> unit =
          fields.mapping.transform_real_to_unit_cell(cell, points[i].position);
        if (GeometryInfo<dim>::is_inside_unit_cell(unit, tolerance))
          samples.push_back({cell, i, unit, 1.});
      }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
      {
        // far outside of a distorted cell
      }
    }
  }



  // Whether it is a neighbour of the other cell, which may be coarser, across a
  // side with the point on it.
  template <int dim>
  bool
  PointDisplacements<dim>::touches(const Sample &sample, const Sample &other)
  {
    for (const unsigned int f : sample.cell->face_indices())
    {
      const double side = f % 2;
      if (std::abs(sample.unit_cell[f / 2] - side) > tolerance ||
          sample.cell->at_boundary(f))
        continue;
      const auto neighbour = sample.cell->neighbor(f);
      if (neighbour->level() == other.cell->level() &&
          neighbour->index() == other.cell->index())
        return true;
    }
    return false;
  }



  // Cells around one point are few.
  template <int dim>
  void
  PointDisplacements<dim>::count_cells_of_fans()
  {
    std::vector<std::size_t> fan(samples.size());
    std::iota(fan.begin(), fan.end(), std::size_t(0));
    for (std::size_t a = 0; a < samples.size(); ++a)
      for (std::size_t b = 0; b < samples.size(); ++b)
        if (samples[a].point == samples[b].point && fan[a] != fan[b] &&
            touches(samples[a], samples[b]))
        {
          const std::size_t from = fan[a], to = fan[b];
          std::replace(fan.begin(), fan.end(), from, to);
        }
    for (std::size_t a = 0; a < samples.size(); ++a)
      samples[a].n_cells = std::count(fan.begin(), fan.end(), fan[a]);
  }



  template <int dim>
  void
  PointDisplacements<dim>::reinit()
  {
    samples.clear();
    if (points.empty())
      return;
    for (const auto &cell :
         fields.elastic.get_triangulation().active_cell_iterators())
      if (!cell->is_artificial())
        find_in(cell);
    count_cells_of_fans();
    samples.erase(std::remove_if(samples.begin(),
                                 samples.end(),
                                 [](const Sample &sample) {
                                   return !sample.cell->is_locally_owned();
                                 }),
                  samples.end());
    n_fans.assign(points.size(), 0.);
    for (const Sample &sample : samples)
      n_fans[sample.point] += 1. / sample.n_cells;
    Utilities::MPI::sum(n_fans, fields.communicator(), n_fans);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (n_fans[i] == 0.)
      {
        std::ostringstream message;
        message << PointDisplacementParameters<dim>::name << ": found '"
                << points[i].name << " : " << points[i].position
                << "', which lies outside of the mesh. Allowed are points of "
                   "the undeformed body; its nearest vertex is "
                << in_words(nearest_vertex(fields.elastic.get_triangulation(),
                                           points[i].position))
                << ".";
        throw InputError(message.str());
      }
  }



  template <int dim>
  std::vector<double>
  PointDisplacements<dim>::evaluate(const LinearAlgebra::Vector &elastic) const
  {
    std::vector<double> result(dim * points.size(), 0.);
    if (points.empty())
      return result;
    FEPointEvaluation<dim, dim> displacement(
      fields.mapping, fields.elastic.get_fe(), update_values);
    std::vector<double> local(fields.elastic.get_fe().n_dofs_per_cell());
    for (const Sample &sample : samples)
    {
      typename DoFHandler<dim>::active_cell_iterator(
        &sample.cell->get_triangulation(),
        sample.cell->level(),
        sample.cell->index(),
        &fields.elastic)
        ->get_dof_values(elastic, local.begin(), local.end());
      const std::vector<Point<dim>> at = {sample.unit_cell};
      displacement.reinit(sample.cell, at);
      displacement.evaluate(local, EvaluationFlags::values);
      for (unsigned int d = 0; d < dim; ++d)
        result[dim * sample.point + d] +=
          displacement.get_value(0)[d] / sample.n_cells / n_fans[sample.point];
    }
    Utilities::MPI::sum(result, fields.communicator(), result);
    return result;
  }



  template <int dim>
  std::vector<std::string>
  PointDisplacements<dim>::column_names() const
  {
    std::vector<std::string> names;
    for (const NamedPoint<dim> &point : points)
      for (unsigned int d = 0; d < dim; ++d)
        names.push_back(point.column_name(d));
    return names;
  }



  template class PointDisplacements<2>;
  template class PointDisplacements<3>;
} // namespace MixedCracks
