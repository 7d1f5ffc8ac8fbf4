// SPDX-License-Identifier: GPL-2.0-or-later
// Faces of a slit that pass through each other: two vertices at one undeformed
// place, on sides 1 and 2, n the outward normal of side 1,
//
//   depth = - (u_2 - u_1) . n > 0.
//
// Reported is the largest, where it is more than 0.01 of the largest jump |u_2
// - u_1| (less may be the error of discretisation beside a tip) and more than
// 1e-9 |u| (rigid motion, rounding). Small strains: n is that of the undeformed
// slit, and a pair stays a pair however far the faces slide.
//
// The two sides may be on different ranks. All vertices on slits are gathered
// and sorted by coarse face and, as in slit_faces.cc, by f(x) = sum_d (0.6180 +
// 0.2718 d) x_d with |grad f| < 1.6: partners, which are at one place but for
// rounding, are among the few whose f differs by less than that times the
// tolerance, in O(n log n). The tolerance is measured by the coarse face, which
// does not depend on where the origin is. Several cells of a side may share a
// vertex.

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_accessor.h>

#include <output/slit_overlap.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // of the largest jump: what is less may be rounding, or the pressure of
    // one element on the next beside a tip
    constexpr double smallest_depth = 0.01;
    // of the displacement
    constexpr double rounding = 1e-9;
    // of the size of a coarse face: vertices that are nearer are at one place.
    // It bounds the depth of refinement by 19 levels.
    constexpr double same_place = 1e-6;

    template <int dim>
    struct Vertex
    {
      Point<dim>     position;
      Tensor<1, dim> displacement;
      unsigned int   side;
      unsigned int   face;
      double         order; // to find neighbours by
    };



    template <int dim>
    std::vector<Vertex<dim>>
    unpack(const std::vector<std::vector<double>> &from_ranks)
    {
      std::vector<Vertex<dim>> result;
      for (const std::vector<double> &numbers : from_ranks)
        for (std::size_t i = 0; i < numbers.size(); i += 2 * dim + 2)
        {
          Vertex<dim> vertex;
          vertex.order = 0.;
          for (unsigned int d = 0; d < dim; ++d)
          {
            vertex.position[d]     = numbers[i + d];
            vertex.displacement[d] = numbers[i + dim + d];
            vertex.order += vertex.position[d] * (0.6180 + 0.2718 * d);
          }
          vertex.side = static_cast<unsigned int>(numbers[i + 2 * dim]);
          vertex.face = static_cast<unsigned int>(numbers[i + 2 * dim + 1]);
          result.push_back(vertex);
        }
      return result;
    }



    // Call @p body with the two vertices of each pair at one place, that of the
    // first side first.
    template <int dim, typename Body>
    void
    for_each_pair(const std::vector<SlitFace<dim>> &faces,
                  std::vector<Vertex<dim>>         &vertices,
                  const Body                       &body)
    {
      std::sort(
        vertices.begin(), vertices.end(), [](const auto &a, const auto &b) {
          return a.face != b.face ? a.face < b.face : a.order < b.order;
        });
      for (std::size_t i = 0; i < vertices.size(); ++i)
      {
        const Vertex<dim> &one     = vertices[i];
        const auto        &corners = faces[one.face].place.corners;
        const double       tolerance =
          same_place * corners.front().distance(corners.back());
        for (std::size_t j = i + 1;
             j < vertices.size() && vertices[j].face == one.face &&
             vertices[j].order - one.order <= 1.6 * tolerance;
             ++j)
          if (vertices[j].side != one.side &&
              vertices[j].position.distance(one.position) <= tolerance)
            body(one.side == 0 ? one : vertices[j],
                 one.side == 0 ? vertices[j] : one);
      }
    }
  } // namespace



  template <int dim>
  void
  SlitOverlap<dim>::reinit()
  {
    faces = slit_faces(fields.elastic.get_triangulation());
    side_at.clear();
    for (unsigned int i = 0; i < faces.size(); ++i)
      for (unsigned int side = 0; side < 2; ++side)
        side_at[{faces[i].sides[side].cell, faces[i].sides[side].face}] = {
          i, side};
  }



  template <int dim>
  std::vector<double>
  SlitOverlap<dim>::displacements_at_slits(
    const LinearAlgebra::Vector &elastic) const
  {
    std::vector<double> result;
    for (const auto &cell : fields.elastic.active_cell_iterators())
    {
      if (!cell->is_locally_owned() || !cell->at_boundary())
        continue;
      for (const unsigned int f : cell->face_indices())
      {
        // children have the numbering of faces of their parents
        const auto known = side_at.find({cell->id().get_coarse_cell_id(), f});
        if (!cell->face(f)->at_boundary() || known == side_at.end())
          continue;
        for (const unsigned int v : cell->face(f)->vertex_indices())
        {
          const unsigned int vertex =
            GeometryInfo<dim>::face_to_cell_vertices(f, v);
          for (unsigned int d = 0; d < dim; ++d)
            result.push_back(cell->vertex(vertex)[d]);
          for (unsigned int d = 0; d < dim; ++d)
            result.push_back(elastic(cell->vertex_dof_index(vertex, d)));
          result.push_back(known->second.second);
          result.push_back(known->second.first);
        }
      }
    }
    return result;
  }



  template <int dim>
  typename SlitOverlap<dim>::Place
  SlitOverlap<dim>::deepest(const LinearAlgebra::Vector &elastic) const
  {
    Place result;
    if (faces.empty())
      return result;
    const MPI_Comm communicator = fields.communicator();
    auto           vertices     = unpack<dim>(Utilities::MPI::all_gather(
      communicator, displacements_at_slits(elastic)));
    double         largest_jump = 0., largest_displacement = 0.;
    for_each_pair(faces, vertices, [&](const auto &first, const auto &second) {
      const Tensor<1, dim> jump  = second.displacement - first.displacement;
      const double         depth = -(jump * faces[first.face].normal);
      largest_jump               = std::max(largest_jump, jump.norm());
      largest_displacement =
        std::max(largest_displacement, first.displacement.norm());
      if (depth > result.depth)
        result = {depth, first.position};
    });
    // where the body moves as a whole, the jump is a rounding error
    if (!(result.depth > smallest_depth * largest_jump) ||
        !(result.depth > rounding * largest_displacement))
      result = Place();
    return result;
  }



  template class SlitOverlap<2>;
  template class SlitOverlap<3>;
} // namespace MixedCracks
