// SPDX-License-Identifier: GPL-2.0-or-later
// Meshes of quadrilaterals as plain lists, made by tools that are put together:
// tensor products of grid lines, slits, smoothing. They become a triangulation
// at the end, whose cells deal.II then turns so that edges have consistent
// directions.

#include <problem/geometries/quad_mesh.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace MixedCracks
{
  // A gap between fixed lines is cut into n = round(gap/size) equal pieces, at
  // least one: they are 1/2 to 3/2 of the wanted size, or less where the gap
  // is.
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



  // Vertices to the left of the tip, at its height, get a twin that the cells
  // above take: two boundaries at one place. The tip stays one vertex.
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



  namespace
  {
    constexpr unsigned int most_sweeps = 10;

    // counterclockwise
    std::array<unsigned int, 4>
    corners_of(const dealii::CellData<2> &cell)
    {
      return {{cell.vertices[0],
               cell.vertices[1],
               cell.vertices[3],
               cell.vertices[2]}};
    }



    // neighbours along the edges; none for vertices on the boundary
    std::vector<std::set<unsigned int>>
    inner_neighbours(const QuadMesh &mesh)
    {
      std::vector<std::set<unsigned int>> neighbours(mesh.vertices.size());
      std::map<std::pair<unsigned int, unsigned int>, unsigned int> n_cells;
      for (const dealii::CellData<2> &cell : mesh.cells)
      {
        const auto corners = corners_of(cell);
        for (unsigned int i = 0; i < 4; ++i)
        {
          const unsigned int a = corners[i], b = corners[(i + 1) % 4];
          neighbours[a].insert(b);
          neighbours[b].insert(a);
          ++n_cells[std::minmax(a, b)];
        }
      }
      for (const auto &[edge, count] : n_cells)
        if (count == 1)
        {
          neighbours[edge.first].clear();
          neighbours[edge.second].clear();
        }
      return neighbours;
    }
  } // namespace



  double
  QuadMesh::aspect_ratio() const
  {
    double worst = 1.;
    for (const dealii::CellData<2> &cell : cells)
    {
      const auto            corners = corners_of(cell);
      std::array<double, 4> edges;
      for (unsigned int i = 0; i < 4; ++i)
        edges[i] =
          vertices[corners[i]].distance(vertices[corners[(i + 1) % 4]]);
      const auto [shortest, longest] =
        std::minmax_element(edges.begin(), edges.end());
      worst = std::max(worst, *longest / *shortest);
    }
    return worst;
  }



  // x_v <- x_v + 1/2 (mean of its neighbours - x_v), for all vertices at once.
  // A sweep that does not make the worst aspect ratio better is not taken.
  void
  QuadMesh::smooth(
    const std::function<bool(const dealii::Point<2> &)> &is_fixed)
  {
    const std::vector<std::set<unsigned int>> neighbours =
      inner_neighbours(*this);
    for (unsigned int sweep = 0; sweep < most_sweeps; ++sweep)
    {
      QuadMesh smoother = *this;
      for (unsigned int v = 0; v < vertices.size(); ++v)
      {
        if (neighbours[v].empty() || is_fixed(vertices[v]))
          continue;
        dealii::Point<2> middle;
        for (const unsigned int neighbour : neighbours[v])
          middle += vertices[neighbour] / (1. * neighbours[v].size());
        smoother.vertices[v] = vertices[v] + 0.5 * (middle - vertices[v]);
      }
      if (!(smoother.aspect_ratio() < aspect_ratio()))
        return;
      *this = smoother;
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
