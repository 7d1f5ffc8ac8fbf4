// SPDX-License-Identifier: GPL-2.0-or-later
// Corners of cells: at each of them the edges span
//
//   2-d   m = (e1 x e2)_z           twice the area of the triangle
//   3-d   m = (e1 x e2) . e3        six times the volume of the tetrahedron,
//
// in the order in which they are right-handed in a good cell. All m > 0: the
// cell is good (in 2-d convex; in 3-d the map is regular at the corners). All m
// < 0: it is inside out, which another order of the nodes mends. Mixed: twisted
// or not convex. abs(m) <= 1e-9 diameter^dim: degenerate.
//
// Numbers of nodes: 0 1 2 3 around, in 3-d 4 5 6 7 above them.

#include <problem/geometries/mesh_cells.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  namespace
  {
    // of diameter^dim: a corner whose edges span less is flat
    constexpr double smallest_corner = 1e-9;

    // The edges that leave a corner, in right-handed order where the cell is
    // not inside out
    template <int dim>
    std::vector<dealii::Tensor<1, 3>>
    edges_at(const MeshContents       &contents,
             const MeshContents::Cell &cell,
             const unsigned int        corner)
    {
      const unsigned int        layer = corner / 4, place = corner % 4;
      const unsigned int        next = 4 * layer + (place + 1) % 4;
      const unsigned int        last = 4 * layer + (place + 3) % 4;
      std::vector<unsigned int> ends = {layer == 0 ? next : last,
                                        layer == 0 ? last : next};
      if (dim == 3)
        ends.push_back(4 * (1 - layer) + place);
      std::vector<dealii::Tensor<1, 3>> edges;
      for (const unsigned int end : ends)
        edges.push_back(contents.nodes[cell.nodes[end]].position -
                        contents.nodes[cell.nodes[corner]].position);
      return edges;
    }



    double
    measure_of(const std::vector<dealii::Tensor<1, 3>> &edges)
    {
      const dealii::Tensor<1, 3> normal =
        dealii::cross_product_3d(edges[0], edges[1]);
      return edges.size() == 2 ? normal[2] : normal * edges[2];
    }



    // What a flat corner is
    std::string
    flat_corner(const std::vector<dealii::Tensor<1, 3>> &edges)
    {
      for (const auto &edge : edges)
        if (edge.norm() == 0.)
          return "two corners at one place,";
      if (edges.size() == 2)
        return edges[0] * edges[1] < 0. ? "a corner of 180 degrees"
                                        : "a corner of 0 degrees";
      return "a flat corner";
    }
  } // namespace



  template <int dim>
  void
  orient_cell(const MeshContents &contents, MeshContents::Cell &cell)
  {
    const unsigned int n        = static_cast<unsigned int>(cell.nodes.size());
    double             diameter = 0.;
    for (const unsigned int a : cell.nodes)
      for (const unsigned int b : cell.nodes)
        diameter = std::max(
          diameter,
          contents.nodes[a].position.distance(contents.nodes[b].position));
    const double      smallest = smallest_corner * std::pow(diameter, dim);
    const std::string sentence = "has degenerate or twisted cells: element " +
                                 std::to_string(cell.number) + " ";
    unsigned int n_positive = 0;
    for (unsigned int corner = 0; corner < n; ++corner)
    {
      const auto   edges   = edges_at<dim>(contents, cell, corner);
      const double measure = measure_of(edges);
      if (!(std::abs(measure) > smallest))
      {
        const long int node = contents.nodes[cell.nodes[corner]].number;
        throw MeshProblem(sentence + "has " + flat_corner(edges) +
                          (node == MeshContents::Node::none
                             ? " in a piece of it"
                             : " at node " + std::to_string(node)));
      }
      n_positive += measure > 0.;
    }
    if (n_positive == n)
      return;
    if (n_positive > 0)
      throw MeshProblem(sentence +
                        "is twisted, or has a corner of more than 180 degrees");
    if (dim == 2)
      std::reverse(cell.nodes.begin(), cell.nodes.end());
    else
      std::swap_ranges(
        cell.nodes.begin(), cell.nodes.begin() + 4, cell.nodes.begin() + 4);
  }



  template <int dim>
  std::vector<std::vector<unsigned int>>
  faces_of_cell(const MeshContents::Cell &cell)
  {
    static const std::vector<std::vector<unsigned int>> places =
      dim == 2
        ? std::vector<std::vector<unsigned int>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}}
        : std::vector<std::vector<unsigned int>>{{0, 1, 2, 3},
                                                 {4, 5, 6, 7},
                                                 {0, 1, 5, 4},
                                                 {1, 2, 6, 5},
                                                 {2, 3, 7, 6},
                                                 {3, 0, 4, 7}};
    std::vector<std::vector<unsigned int>> faces;
    for (const std::vector<unsigned int> &face : places)
    {
      faces.emplace_back();
      for (const unsigned int place : face)
        faces.back().push_back(cell.nodes[place]);
    }
    return faces;
  }



  template void orient_cell<2>(const MeshContents &, MeshContents::Cell &);
  template void orient_cell<3>(const MeshContents &, MeshContents::Cell &);
  template std::vector<std::vector<unsigned int>>
  faces_of_cell<2>(const MeshContents::Cell &);
  template std::vector<std::vector<unsigned int>>
  faces_of_cell<3>(const MeshContents::Cell &);
} // namespace MixedCracks
