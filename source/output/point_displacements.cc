// SPDX-License-Identifier: GPL-2.0-or-later
// u(x) = sum_a N_a(xi) u_a in the cell K that contains x, xi = F_K^-1(x) within
// 1e-6 of the unit cell. On sides and vertices, where several cells contain x,
// the mean over all of them: u is the same but on a slit, where it is the mean
// of the faces as far as equally many cells meet from both sides. The number of
// ranks does not matter.
//
// Cells are found once per mesh: the box around K, made larger by a quarter of
// the diameter, decides before F_K is inverted.

#include <base/errors.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <deal.II/matrix_free/fe_point_evaluation.h>

#include <discretization/nearest_vertex.h>

#include <output/point_displacements.h>

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
  PointDisplacements<dim>::PointDisplacements(
    const Fields<dim>                  &fields,
    const std::vector<NamedPoint<dim>> &points)
    : fields(fields)
    , points(points)
  {}



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
          samples.push_back({cell, i, unit});
      }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
      {
        // far outside of a distorted cell
      }
    }
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
      if (cell->is_locally_owned())
        find_in(cell);
    n_cells.assign(points.size(), 0.);
    for (const Sample &sample : samples)
      n_cells[sample.point] += 1.;
    Utilities::MPI::sum(n_cells, fields.communicator(), n_cells);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (n_cells[i] == 0.)
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
          displacement.get_value(0)[d] / n_cells[sample.point];
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
