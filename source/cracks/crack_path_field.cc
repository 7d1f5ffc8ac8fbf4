// SPDX-License-Identifier: GPL-2.0-or-later
// phi near cracks, twice: as a graph of nodes and as a function. The graph
// joins all four nodes of a cell, diagonals included, so that ways have eight
// directions; a hanging node is joined to the four nodes of the coarse cell on
// whose edge it lies, or a band could end where the cell size changes. Nodes
// are the same when they are nearer than 1e-4 of the smallest cell; hence those
// of the two faces of a slit are one, with the smaller phi.
//
// As a function phi is bilinear,
//
//   x = v_0 + xi a + eta b + xi eta c,   phi likewise,
//
// (xi, eta) by Newton's method: at most 8 iterations, one for a parallelogram
// (c = 0). Outside the damaged cells, where phi >= 0.9 at all nodes, 1 is
// taken.
//
// Places are found by boxes of the median size of cells, nodes by boxes of 4
// tolerances and their 8 neighbours.

#include <base/plane.h>

#include <cracks/crack_path_field.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // The root of the area, half the cross product of the diagonals.
    double
    size_of(const std::array<Point<2>, 4> &v)
    {
      return std::sqrt(0.5 * std::abs(cross(v[3] - v[0], v[2] - v[1])));
    }



    template <typename Value>
    Value
    bilinear(const std::array<Value, 4> &v, const double x, const double y)
    {
      return v[0] + x * (v[1] - v[0]) + y * (v[2] - v[0]) +
             x * y * ((v[3] - v[2]) - (v[1] - v[0]));
    }



    // the place of a point within a cell, by Newton's method; false when it
    // lies outside
    bool
    find_reference_point(const std::array<Point<2>, 4> &v,
                         const Point<2>                &point,
                         double                        &x,
                         double                        &y)
    {
      const Tensor<1, 2> a = v[1] - v[0], b = v[2] - v[0],
                         c = (v[3] - v[2]) - a;
      x = y = 0.5;
      for (unsigned int k = 0; k < 8; ++k)
      {
        const Tensor<1, 2> residual =
          point - v[0] - (x * a + y * b + x * y * c);
        const Tensor<1, 2> dx = a + y * c, dy = b + x * c;
        const double       determinant = cross(dx, dy);
        if (determinant == 0.)
          return false;
        const double step_x = cross(residual, dy) / determinant,
                     step_y = cross(dx, residual) / determinant;
        x += step_x;
        y += step_y;
        if (std::abs(step_x) + std::abs(step_y) < 1e-10)
          break;
      }
      constexpr double margin = 1e-6;
      return x > -margin && x < 1. + margin && y > -margin && y < 1. + margin;
    }



    double
    median(std::vector<double> values)
    {
      if (values.empty())
        return 0.;
      const auto middle = values.begin() + values.size() / 2;
      std::nth_element(values.begin(), middle, values.end());
      return *middle;
    }
  } // namespace



  DamageField::DamageField(const std::vector<DamagedCell> &damaged,
                           const double                    broken)
  {
    std::vector<double> sizes, broken_sizes;
    for (const DamagedCell &cell : damaged)
    {
      sizes.push_back(size_of(cell.vertices));
      if (*std::min_element(cell.phase_field.begin(), cell.phase_field.end()) <
          broken)
        broken_sizes.push_back(sizes.back());
    }
    if (damaged.empty())
      return;
    size      = median(broken_sizes);
    box_size  = median(sizes);
    tolerance = 1e-4 * *std::min_element(sizes.begin(), sizes.end());
    for (const DamagedCell &cell : damaged)
      add_cell(cell);
    for (const DamagedCell &cell : damaged)
      link_hanging_nodes(cell);
  }



  void
  DamageField::add_cell(const DamagedCell &cell)
  {
    const unsigned int index = cells.size();
    cells.push_back(cell);
    std::array<Node, 4> nodes;
    Point<2>            lower = cell.vertices[0], upper = lower;
    for (unsigned int v = 0; v < 4; ++v)
    {
      nodes[v]         = node_at(cell.vertices[v]);
      values[nodes[v]] = std::min(values[nodes[v]], cell.phase_field[v]);
      for (unsigned int d = 0; d < 2; ++d)
      {
        lower[d] = std::min(lower[d], cell.vertices[v][d]);
        upper[d] = std::max(upper[d], cell.vertices[v][d]);
      }
    }
    for (unsigned int v = 0; v < 4; ++v)
      for (unsigned int w = 0; w < v; ++w)
        link(nodes[v], nodes[w]);
    const Box first = box_of(lower, box_size), last = box_of(upper, box_size);
    for (long i = first.first; i <= last.first; ++i)
      for (long j = first.second; j <= last.second; ++j)
        cells_in_box[{i, j}].push_back(index);
  }



  // hanging nodes on the edges of a cell, when the finer cells that have them
  // are not among the damaged ones on either side of them
  void
  DamageField::link_hanging_nodes(const DamagedCell &cell)
  {
    constexpr unsigned int edges[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
    for (const auto &edge : edges)
    {
      const Point<2> middle =
        0.5 * (cell.vertices[edge[0]] + cell.vertices[edge[1]]);
      const Node node = find_node(middle);
      if (node == no_node)
        continue;
      for (unsigned int v = 0; v < 4; ++v)
        link(node, node_at(cell.vertices[v]));
    }
  }



  void
  DamageField::link(const Node a, const Node b)
  {
    if (a == b)
      return;
    for (const auto &[from, to] : {std::pair(a, b), std::pair(b, a)})
      if (std::find(neighbours[from].begin(), neighbours[from].end(), to) ==
          neighbours[from].end())
        neighbours[from].push_back(to);
  }



  DamageField::Box
  DamageField::box_of(const Point<2> &point, const double box) const
  {
    return {std::lround(std::floor(point[0] / box)),
            std::lround(std::floor(point[1] / box))};
  }



  DamageField::Node
  DamageField::find_node(const Point<2> &point) const
  {
    const Box home = box_of(point, node_box());
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
      {
        const auto found = nodes_in_box.find({home.first + i, home.second + j});
        if (found == nodes_in_box.end())
          continue;
        for (const Node node : found->second)
          if (points[node].distance(point) < tolerance)
            return node;
      }
    return no_node;
  }



  // The values of a node begin with 1 and become the smallest of its cells'.
  DamageField::Node
  DamageField::node_at(const Point<2> &point)
  {
    Node node = find_node(point);
    if (node != no_node)
      return node;
    node = points.size();
    points.push_back(point);
    values.push_back(1.);
    neighbours.emplace_back();
    nodes_in_box[box_of(point, node_box())].push_back(node);
    return node;
  }



  double
  DamageField::value(const Point<2> &point) const
  {
    const auto found = cells_in_box.find(box_of(point, box_size));
    if (found == cells_in_box.end())
      return 1.;
    for (const unsigned int index : found->second)
    {
      double             x, y;
      const DamagedCell &cell = cells[index];
      if (find_reference_point(cell.vertices, point, x, y))
        return bilinear(cell.phase_field, x, y);
    }
    return 1.;
  }
} // namespace MixedCracks
