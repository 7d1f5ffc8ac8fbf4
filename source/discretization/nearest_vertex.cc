// SPDX-License-Identifier: GPL-2.0-or-later
// argmin over the vertices of |x_v - x|; of several that are equally near, the
// one that is least in the order of coordinates x, then y, then z, found by one
// reduction per coordinate: the same for any partition of the mesh.

#include <base/log.h>

#include <deal.II/base/mpi.h>

#include <discretization/nearest_vertex.h>

#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  Point<dim>
  nearest_vertex(const Triangulation<dim> &triangulation,
                 const Point<dim>         &point)
  {
    const MPI_Comm communicator = triangulation.get_communicator();
    const double   nothing      = std::numeric_limits<double>::max();
    double         smallest     = nothing;
    Point<dim>     nearest;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          if (const double distance = cell->vertex(v).distance(point);
              distance < smallest)
          {
            smallest = distance;
            nearest  = cell->vertex(v);
          }
    const bool mine = smallest == Utilities::MPI::min(smallest, communicator);
    // of vertices that are equally near, the one with the least coordinates
    std::array<double, dim> found;
    bool                    candidate = mine && smallest < nothing;
    for (unsigned int d = 0; d < dim; ++d)
    {
      found[d] =
        Utilities::MPI::min(candidate ? nearest[d] : nothing, communicator);
      candidate = candidate && nearest[d] == found[d];
    }
    for (unsigned int d = 0; d < dim; ++d)
      nearest[d] = found[d];
    return nearest;
  }



  template <int dim>
  std::string
  in_words(const Point<dim> &point)
  {
    std::string text;
    for (unsigned int d = 0; d < dim; ++d)
      text += format(d == 0 ? "(%.6g" : ", %.6g", point[d]);
    return text + ")";
  }



  template Point<2> nearest_vertex(const Triangulation<2> &, const Point<2> &);
  template Point<3> nearest_vertex(const Triangulation<3> &, const Point<3> &);
  template std::string in_words(const Point<2> &);
  template std::string in_words(const Point<3> &);
} // namespace MixedCracks
