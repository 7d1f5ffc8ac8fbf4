// SPDX-License-Identifier: GPL-2.0-or-later
// The scaled Jacobian of a cell (Knupp, SIAM J. Sci. Comput. 23 (2001) 193): at
// each corner the edges e_i that leave it span
//
//   J = (e_1 x e_2)_z / (|e_1| |e_2|)            2-d: the sine of the angle
//   J = (e_1 x e_2) . e_3 / (|e_1| |e_2| |e_3|)  3-d;
//
// the smallest J of its corners is that of the cell: 1 in a rectangle or a
// brick, 0 where a corner is flat.

#include <deal.II/base/geometry_info.h>

#include <discretization/mesh_quality.h>

#include <algorithm>

namespace MixedCracks
{
  namespace
  {
    // Vertices are numbered in pairs: bit d of a number is its place along
    // direction d, and the edge in direction d leads to the other one.
    template <int dim, typename Cell>
    double
    scaled_jacobian(const Cell &cell)
    {
      double smallest = 1.;
      for (const unsigned int v : cell->vertex_indices())
      {
        dealii::Tensor<2, dim> edges;
        for (unsigned int d = 0; d < dim; ++d)
        {
          const double sign = (v >> d) % 2 == 0 ? 1. : -1.;
          edges[d] = sign * (cell->vertex(v ^ (1u << d)) - cell->vertex(v));
          edges[d] /= edges[d].norm();
        }
        smallest = std::min(smallest, dealii::determinant(edges));
      }
      return smallest;
    }
  } // namespace



  template <int dim>
  MeshQuality<dim>
  quality_of_coarse_mesh(const dealii::Triangulation<dim> &triangulation)
  {
    MeshQuality<dim> quality;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
    {
      const double here = scaled_jacobian<dim>(cell);
      ++quality.n_cells;
      quality.n_distorted += here < quality.distorted;
      if (here < quality.smallest || quality.n_cells == 1)
      {
        quality.smallest = here;
        quality.place    = cell->center();
      }
    }
    return quality;
  }



  template MeshQuality<2>
  quality_of_coarse_mesh(const dealii::Triangulation<2> &);
  template MeshQuality<3>
  quality_of_coarse_mesh(const dealii::Triangulation<3> &);
} // namespace MixedCracks
