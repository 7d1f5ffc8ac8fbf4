// SPDX-License-Identifier: GPL-2.0-or-later
// Opening and volume of smeared cracks. Along a line with unit normal n through
// a crack, phi goes from 1 to 0 and back to 1; where u is u- before and u+
// behind,
//
//   w = integral of u . grad(phi) dt = -u- . n + u+ . n = [u] . n,   mm,
//
// for any profile of phi, with grad(phi) = phi' n. Over the body it gives the
// volume (M10; Wheeler, Wick and Wollner, Comput. Methods Appl. Mech. Engrg.
// 271 (2014)). The sign of n does not matter. On a line
//
//   w = D sum_i mean(u . grad(phi))(x + t_i n),   t_i = (i + 1/2) D - N D/2,
//
// i = 0 ... N - 1, D = h_min/8, N = 2 ceil(reach/D), and the mean over the
// cells that contain the point: grad(phi) jumps between cells, and a point on a
// side would belong to one or the other by rounding, or to the rank that comes
// first.
//
// Cells, places on the unit cell and numbers of cells per point are found once
// per mesh; an evaluation is two products with shape functions per point.

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/matrix_free/fe_point_evaluation.h>

#include <output/crack_opening.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    constexpr double points_per_cell = 8.;

    // of the unit cell, and of a spacing: what is that near belongs to both
    // neighbours
    constexpr double rounding = 1e-8;
  } // namespace



  template <int dim>
  double
  crack_volume(const Fields<dim> &fields,
               const Vector      &elastic,
               const Vector      &phase_field)
  {
    FEValues<dim>               elastic_values(fields.mapping,
                                 fields.elastic.get_fe(),
                                 fields.quadrature,
                                 update_values | update_JxW_values);
    FEValues<dim>               phase_field_values(fields.mapping,
                                     fields.phase_field.get_fe(),
                                     fields.quadrature,
                                     update_gradients);
    std::vector<Tensor<1, dim>> displacements(fields.quadrature.size());
    std::vector<Tensor<1, dim>> gradients(fields.quadrature.size());
    double                      volume = 0.;
    for (const auto &cell : fields.elastic.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        elastic_values.reinit(cell);
        phase_field_values.reinit(
          typename DoFHandler<dim>::active_cell_iterator(
            &cell->get_triangulation(),
            cell->level(),
            cell->index(),
            &fields.phase_field));
        elastic_values[fields.displacement].get_function_values(elastic,
                                                                displacements);
        phase_field_values.get_function_gradients(phase_field, gradients);
        for (unsigned int q = 0; q < gradients.size(); ++q)
          volume += displacements[q] * gradients[q] * elastic_values.JxW(q);
      }
    return Utilities::MPI::sum(volume, fields.communicator());
  }



  template <int dim>
  CrackOpening<dim>::CrackOpening(const Fields<dim>                   &fields,
                                  const std::vector<OpeningLine<dim>> &lines)
    : fields(fields)
    , measured(lines)
  {
    for (const OpeningLine<dim> &line : measured)
      for (unsigned int i = 0; i < line.n_positions; ++i)
        probes.push_back({line.position(i), line.normal});
  }



  // The line cut by the pairs of planes of the box around the cell (slabs), one
  // after the other: t from max_d min(a_d, b_d) to min_d max(a_d, b_d). The
  // mapping is linear, so that no cell reaches beyond the box of its vertices.
  template <int dim>
  std::pair<unsigned int, unsigned int>
  CrackOpening<dim>::candidates(const Cell &cell, const Probe &probe) const
  {
    const auto [low, high] = cell->bounding_box().get_boundary_points();
    const double tolerance = rounding * cell->diameter();
    double       from      = offset(0) - spacing;
    double       to        = offset(n_points);
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double lower = low[d] - probe.position[d] - tolerance;
      const double upper = high[d] - probe.position[d] + tolerance;
      if (std::abs(probe.normal[d]) < rounding)
      {
        if (lower > 0. || upper < 0.)
          return {0, 0};
        continue;
      }
      const double a = lower / probe.normal[d], b = upper / probe.normal[d];
      from = std::max(from, std::min(a, b));
      to   = std::min(to, std::max(a, b));
    }
    if (from > to)
      return {0, 0};
    const auto number = [&](const double distance) {
      return std::ceil((distance - offset(0)) / spacing - rounding);
    };
    return {static_cast<unsigned int>(std::max(0., number(from))),
            static_cast<unsigned int>(
              std::clamp(number(to) + 1., 0., 1. * n_points))};
  }



  template <int dim>
  void
  CrackOpening<dim>::sample(const Cell &cell, const unsigned int probe)
  {
    const auto [first, last] = candidates(cell, probes[probe]);
    Sample result{cell, probe, {}, {}};
    for (unsigned int i = first; i < last; ++i)
    {
      const Point<dim> point =
        probes[probe].position + offset(i) * probes[probe].normal;
      try
      {
        const Point<dim> unit =
          fields.mapping.transform_real_to_unit_cell(cell, point);
        if (!GeometryInfo<dim>::is_inside_unit_cell(unit, rounding))
          continue;
        result.points.push_back(unit);
        result.numbers.push_back(i);
      }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
      {
        // far outside of a distorted cell
      }
    }
    if (!result.points.empty())
      samples.push_back(std::move(result));
  }



  template <int dim>
  void
  CrackOpening<dim>::count_cells_of_points()
  {
    n_cells.assign(probes.size() * n_points, 0.);
    for (const Sample &sample : samples)
      for (const unsigned int number : sample.numbers)
        n_cells[sample.probe * n_points + number] += 1.;
    Utilities::MPI::sum(n_cells, fields.communicator(), n_cells);
  }



  template <int dim>
  void
  CrackOpening<dim>::reinit(const double reach)
  {
    double      smallest = std::numeric_limits<double>::max();
    const auto &mesh     = fields.elastic.get_triangulation();
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        smallest = std::min(smallest, std::pow(cell->measure(), 1. / dim));
    smallest = Utilities::MPI::min(smallest, fields.communicator());
    spacing  = smallest / points_per_cell;
    n_points = 2 * static_cast<unsigned int>(std::ceil(reach / spacing));

    samples.clear();
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
        for (unsigned int probe = 0; probe < probes.size(); ++probe)
          sample(cell, probe);
    count_cells_of_points();
  }



  template <int dim>
  std::vector<double>
  CrackOpening<dim>::evaluate(const Vector &elastic,
                              const Vector &phase_field) const
  {
    FEPointEvaluation<dim, dim> displacement(
      fields.mapping, fields.elastic.get_fe(), update_values);
    FEPointEvaluation<1, dim> gradient(
      fields.mapping, fields.phase_field.get_fe(), update_gradients);
    std::vector<double> local_elastic(
      fields.elastic.get_fe().n_dofs_per_cell());
    std::vector<double> local_phase_field(
      fields.phase_field.get_fe().n_dofs_per_cell());
    std::vector<double> openings(probes.size(), 0.);
    for (const Sample &sample : samples)
    {
      using DofCell     = typename DoFHandler<dim>::active_cell_iterator;
      const auto &mesh  = sample.cell->get_triangulation();
      const int   level = sample.cell->level(), index = sample.cell->index();
      DofCell(&mesh, level, index, &fields.elastic)
        ->get_dof_values(elastic, local_elastic.begin(), local_elastic.end());
      DofCell(&mesh, level, index, &fields.phase_field)
        ->get_dof_values(
          phase_field, local_phase_field.begin(), local_phase_field.end());
      displacement.reinit(sample.cell, sample.points);
      displacement.evaluate(local_elastic, EvaluationFlags::values);
      gradient.reinit(sample.cell, sample.points);
      gradient.evaluate(local_phase_field, EvaluationFlags::gradients);
      for (unsigned int i = 0; i < sample.points.size(); ++i)
        openings[sample.probe] +=
          displacement.get_value(i) * gradient.get_gradient(i) * spacing /
          n_cells[sample.probe * n_points + sample.numbers[i]];
    }
    Utilities::MPI::sum(openings, fields.communicator(), openings);
    return openings;
  }



  template double
  crack_volume(const Fields<2> &, const Vector &, const Vector &);
  template double
  crack_volume(const Fields<3> &, const Vector &, const Vector &);
  template class CrackOpening<2>;
  template class CrackOpening<3>;
} // namespace MixedCracks
