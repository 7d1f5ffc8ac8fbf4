// SPDX-License-Identifier: GPL-2.0-or-later
// V = |L_1| |L_2 - part along L_1| ..., by Gram and Schmidt; where there are
// fewer periods than dimensions, the axis that is farthest from what they span
// is next, e its part across them, times the extent max e.x - min e.x.

#include <discretization/lattice.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  Tensor<1, dim>
  rest_of(Tensor<1, dim> vector, const std::vector<Tensor<1, dim>> &orthogonal)
  {
    for (const Tensor<1, dim> &each : orthogonal)
      vector -= (vector * each) / each.norm_square() * each;
    return vector;
  }



  namespace
  {
    template <int dim>
    Tensor<1, dim>
    direction_across(const std::vector<Tensor<1, dim>> &orthogonal)
    {
      Tensor<1, dim> across;
      for (unsigned int d = 0; d < dim; ++d)
      {
        Tensor<1, dim> axis;
        axis[d]                   = 1.;
        const Tensor<1, dim> rest = rest_of(axis, orthogonal);
        if (rest.norm() > across.norm() + 1e-12)
          across = rest;
      }
      return across / across.norm();
    }



    template <int dim>
    double
    extent_along(const Tensor<1, dim>     &direction,
                 const Triangulation<dim> &mesh)
    {
      double least = direction * mesh.begin(0)->vertex(0), most = least;
      for (const auto &cell : mesh.cell_iterators_on_level(0))
        for (const unsigned int v : cell->vertex_indices())
        {
          least = std::min(least, direction * cell->vertex(v));
          most  = std::max(most, direction * cell->vertex(v));
        }
      return most - least;
    }
  } // namespace



  template <int dim>
  double
  lattice_cell_volume(const Triangulation<dim>          &mesh,
                      const std::vector<Tensor<1, dim>> &periods)
  {
    std::vector<Tensor<1, dim>> orthogonal;
    double                      volume = 1.;
    for (const Tensor<1, dim> &period : periods)
    {
      orthogonal.push_back(rest_of(period, orthogonal));
      volume *= orthogonal.back().norm();
    }
    while (orthogonal.size() < dim)
    {
      orthogonal.push_back(direction_across(orthogonal));
      volume *= extent_along(orthogonal.back(), mesh);
    }
    return volume;
  }



#define INSTANTIATE(dim)                                                  \
  template Tensor<1, dim> rest_of(Tensor<1, dim>,                         \
                                  const std::vector<Tensor<1, dim>> &);   \
  template double         lattice_cell_volume(const Triangulation<dim> &, \
                                              const std::vector<Tensor<1, dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
