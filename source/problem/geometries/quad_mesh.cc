// SPDX-License-Identifier: GPL-2.0-or-later
#include <problem/geometries/quad_mesh.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace MixedCracks
{
  std::vector<double>
  grid_lines(std::vector<double> fixed, const double cell_size)
  {
    std::sort(fixed.begin(), fixed.end());
    const double tolerance = 1e-9 * (fixed.back() - fixed.front());

    std::vector<double> lines = {fixed.front()};
    for (const double next : fixed)
    {
      const double begin = lines.back();
      const double gap   = next - begin;
      if (gap <= tolerance)
        continue;
      const double n_pieces = std::max(1., std::round(gap / cell_size));
      for (double piece = 1.; piece < n_pieces; piece += 1.)
        lines.push_back(begin + gap * piece / n_pieces);
      lines.push_back(next);
    }
    return lines;
  }



  unsigned int
  QuadMesh::add_vertex(const dealii::Point<2> &position)
  {
    vertices.push_back(position);
    return static_cast<unsigned int>(vertices.size() - 1);
  }



  void
  QuadMesh::add_quad(const std::array<unsigned int, 4> &corners)
  {
    // deal.II counts the corners of a cell lexicographically
    dealii::CellData<2> cell;
    cell.vertices = {corners[0], corners[1], corners[3], corners[2]};
    cells.push_back(cell);
  }



  void
  QuadMesh::open_slit(const dealii::Point<2> &tip)
  {
    const double                         tolerance = 1e-9 * (1. + tip.norm());
    std::map<unsigned int, unsigned int> above;
    for (unsigned int v = 0, n = vertices.size(); v < n; ++v)
      if (std::abs(vertices[v][1] - tip[1]) < tolerance &&
          vertices[v][0] < tip[0] - tolerance)
        above[v] = add_vertex(dealii::Point<2>(vertices[v]));

    for (dealii::CellData<2> &cell : cells)
    {
      double center_height = 0.;
      for (const unsigned int vertex : cell.vertices)
        center_height += vertices[vertex][1] / 4.;
      if (center_height > tip[1])
        for (unsigned int &vertex : cell.vertices)
          if (const auto doubled = above.find(vertex); doubled != above.end())
            vertex = doubled->second;
    }
  }



  void
  QuadMesh::create(dealii::Triangulation<2> &triangulation) const
  {
    std::vector<dealii::CellData<2>> ordered_cells = cells;
    dealii::GridTools::consistently_order_cells(ordered_cells);
    triangulation.create_triangulation(
      vertices, ordered_cells, dealii::SubCellData());
  }



  QuadMesh
  tensor_mesh(const std::vector<double> &x, const std::vector<double> &y)
  {
    return tensor_mesh(x, y, [](const dealii::Point<2> &) { return false; });
  }
} // namespace MixedCracks
