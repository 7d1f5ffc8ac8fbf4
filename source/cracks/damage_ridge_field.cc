// SPDX-License-Identifier: GPL-2.0-or-later
// Smoothing and derivatives by means over cells. With the cells K around node
// i and their volumes |K|,
//
//   w_i <- sum_K |K| mean(w at the nodes of K) / sum_K |K|            n times
//   g_i  = sum_K |K| grad w(center of K) / sum_K |K|
//   H_i  = the same of the symmetric gradient of g
//
// At the boundary, and where cells become larger, the center of the cells is at
// x_i + o_i, and what is found there is carried back to the node: less o_i
// times the mean gradient over the same cells. Without that a crack that meets
// the boundary at an angle would be bent.
//
// On cubes one mean is a convolution with (1/4, 1/2, 1/4) in each direction,
// of variance h^2/2, so that n = 0.25 l^2/h^2 of them make the deviation 0.35
// l: a band that is broken two or three nodes wide has a ridge, too. With that
// of the derivatives, a sheet of radius R is moved inwards by 0.45 l^2/R with h
// = l/2, and 0.26 l^2/R with l/4. Plane cracks with symmetric profiles stay.
//
// Only damaged cells take part, which a rank knows without asking: all cells
// around own nodes are its own or ghosts. Values at other nodes come from their
// owners, n + 12 exchanges between neighbours in all.

#include <cracks/damage_ridge_field.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    constexpr double phase_field_of_damage = 0.9;
    // in l
    constexpr double deviation = 0.35;
    // fine cells are smoothed less, rather than for ever
    constexpr unsigned int most_sweeps = 60;

    // entries of the symmetric second derivatives
    constexpr unsigned int hessian_rows[6]    = {0, 1, 2, 0, 0, 1};
    constexpr unsigned int hessian_columns[6] = {0, 1, 2, 1, 2, 2};



    // +1 or -1: which side of the cell a vertex is on
    double
    sign_of_side(const unsigned int vertex, const unsigned int d)
    {
      return (vertex >> d) % 2 == 1 ? 1. : -1.;
    }
  } // namespace



  RidgeField::RidgeField(const Fields<3>             &fields,
                         const LinearAlgebra::Vector &phase_field,
                         const double                 length)
    : length_scale(length)
    , nodes(std::make_shared<const Utilities::MPI::Partitioner>(
        fields.phase_field_dofs.owned,
        fields.phase_field_dofs.relevant,
        fields.communicator()))
    , volumes(nodes->locally_owned_size(), 0.)
    , damage(nodes)
  {
    double smallest = std::numeric_limits<double>::max();
    for (const auto &cell : fields.phase_field.active_cell_iterators())
      if (!cell->is_artificial())
      {
        double least = 1.;
        for (const unsigned int v : cell->vertex_indices())
          least = std::min(least, phase_field(cell->vertex_dof_index(v, 0)));
        if (!(least < phase_field_of_damage))
          continue;
        add_cell(cell);
        for (const unsigned int v : cell->vertex_indices())
          damage.local_element(cells.back().nodes[v]) =
            1. - phase_field(cell->vertex_dof_index(v, 0));
        smallest = std::min(smallest, std::cbrt(cells.back().volume));
      }
    // known already, as the cells around own nodes are: they may be read now
    damage.update_ghost_values();
    smallest = Utilities::MPI::min(smallest, fields.communicator());
    if (smallest < std::numeric_limits<double>::max())
      cell_size = smallest;
    find_offsets();
  }



  // With the map x(xi), linear in each xi_d on [0, 1]: at its center
  //
  //   J_ab = dx_a/dxi_b = 1/4 sum_v (+-)_vb x_va,   grad w = J^-T dw/dxi.
  void
  RidgeField::add_cell(const DoFHandler<3>::active_cell_iterator &cell)
  {
    Cell         added{cell, {}, {}, {}, 0.};
    Tensor<2, 3> jacobian;
    for (const unsigned int v : cell->vertex_indices())
    {
      added.nodes[v] = nodes->global_to_local(cell->vertex_dof_index(v, 0));
      added.center += 0.125 * cell->vertex(v);
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          jacobian[a][b] += 0.25 * sign_of_side(v, b) * cell->vertex(v)[a];
    }
    added.volume      = std::abs(determinant(jacobian));
    added.to_gradient = transpose(invert(jacobian));
    for (const unsigned int node : added.nodes)
      if (node < volumes.size())
        volumes[node] += added.volume;
    cells.push_back(added);
  }



  void
  RidgeField::find_offsets()
  {
    offsets.assign(volumes.size(), Tensor<1, 3>());
    for (const Cell &cell : cells)
      for (unsigned int v = 0; v < 8; ++v)
        if (const unsigned int node = cell.nodes[v]; node < offsets.size())
          offsets[node] += (cell.volume / volumes[node]) *
                           (cell.center - cell.cell->vertex(v));
  }



  template <typename OfCell>
  void
  RidgeField::average(const OfCell &of_cell,
                      Values       &values,
                      const Values *slope) const
  {
    std::vector<double> sums(volumes.size(), 0.);
    for (const Cell &cell : cells)
    {
      const double value = of_cell(cell);
      Tensor<1, 3> rise;
      if (slope != nullptr)
        rise = gradient_in(cell, *slope);
      for (const unsigned int node : cell.nodes)
        if (node < sums.size())
          sums[node] += cell.volume * (value - rise * offsets[node]);
    }
    values.zero_out_ghost_values();
    for (unsigned int node = 0; node < sums.size(); ++node)
      values.local_element(node) =
        volumes[node] > 0. ? sums[node] / volumes[node] : 0.;
    values.update_ghost_values();
  }



  Tensor<1, 3>
  RidgeField::gradient_in(const Cell &cell, const Values &values) const
  {
    Tensor<1, 3> on_unit_cell;
    for (unsigned int v = 0; v < 8; ++v)
      for (unsigned int d = 0; d < 3; ++d)
        on_unit_cell[d] +=
          0.25 * sign_of_side(v, d) * values.local_element(cell.nodes[v]);
    return cell.to_gradient * on_unit_cell;
  }



  void
  RidgeField::differentiate()
  {
    const double in_cells = deviation * length_scale / cell_size;
    const auto   n_sweeps =
      std::min(most_sweeps,
               static_cast<unsigned int>(
                 std::lround(std::ceil(2. * in_cells * in_cells - 1e-6))));
    for (unsigned int sweep = 0; sweep < n_sweeps; ++sweep)
      average(
        [this](const Cell &cell) {
          double sum = 0.;
          for (const unsigned int node : cell.nodes)
            sum += damage.local_element(node);
          return sum / 8.;
        },
        damage,
        &damage);
    for (unsigned int d = 0; d < 3; ++d)
    {
      first[d].reinit(nodes);
      const auto of_cell = [&](const Cell &cell) {
        return gradient_in(cell, damage)[d];
      };
      average(of_cell, first[d]);
      average(of_cell, first[d], &first[d]);
    }
    for (unsigned int k = 0; k < 6; ++k)
    {
      second[k].reinit(nodes);
      const unsigned int i = hessian_rows[k], j = hessian_columns[k];
      average(
        [&](const Cell &cell) {
          return 0.5 * (gradient_in(cell, first[i])[j] +
                        gradient_in(cell, first[j])[i]);
        },
        second[k]);
    }
  }



  Tensor<1, 3>
  RidgeField::gradient(const unsigned int node) const
  {
    Tensor<1, 3> result;
    for (unsigned int d = 0; d < 3; ++d)
      result[d] = first[d].local_element(node);
    return result;
  }



  SymmetricTensor<2, 3>
  RidgeField::hessian(const unsigned int node) const
  {
    SymmetricTensor<2, 3> result;
    for (unsigned int k = 0; k < 6; ++k)
      result[hessian_rows[k]][hessian_columns[k]] =
        second[k].local_element(node);
    return result;
  }
} // namespace MixedCracks
