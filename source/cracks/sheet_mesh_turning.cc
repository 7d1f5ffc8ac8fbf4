// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles of one surface, turned alike by going from neighbour to neighbour.
// A surface with one side only has a line along which they do not agree.

#include <cracks/sheet_mesh.h>

#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  void
  SheetMesh::turn(Triangle &triangle) const
  {
    std::swap(triangle.vertices[1], triangle.vertices[2]);
    std::swap(triangle.sides[0], triangle.sides[2]);
  }



  // They agree when they go through their common side, from vertex a to b, in
  // opposite ways.
  void
  SheetMesh::turn_against(const unsigned int a,
                          const unsigned int b,
                          Triangle          &neighbour) const
  {
    const auto &v = neighbour.vertices;
    for (unsigned int j = 0; j < 3; ++j)
      if (v[j] == a && v[(j + 1) % 3] == b)
        return turn(neighbour);
  }



  // The triangles of each surface that hangs together by sides of two.
  std::vector<std::vector<unsigned int>>
  SheetMesh::turn_neighbours(
    const std::map<Side, std::vector<SideOf>> &by_vertices)
  {
    std::vector<std::vector<unsigned int>> surfaces;
    std::vector<bool>                      is_done(triangles.size(), false);
    for (unsigned int first = 0; first < triangles.size(); ++first)
    {
      if (is_done[first])
        continue;
      surfaces.push_back({first});
      is_done[first] = true;
      for (std::size_t k = 0; k < surfaces.back().size(); ++k)
      {
        const unsigned int t = surfaces.back()[k];
        for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int a = triangles[t].vertices[i],
                             b = triangles[t].vertices[(i + 1) % 3];
          const auto &at_side  = by_vertices.at(side_between(a, b));
          if (at_side.size() != 2)
            continue;
          const unsigned int other = at_side[0].triangle == t
                                       ? at_side[1].triangle
                                       : at_side[0].triangle;
          if (is_done[other])
            continue;
          turn_against(a, b, triangles[other]);
          is_done[other] = true;
          surfaces.back().push_back(other);
        }
      }
    }
    return surfaces;
  }



  void
  SheetMesh::turn_alike()
  {
    for (const auto &surface : turn_neighbours(sides()))
    {
      Tensor<1, 3> sum;
      for (const unsigned int t : surface)
        sum += area_vector(triangles[t]);
      unsigned int largest = 0;
      for (unsigned int d = 1; d < 3; ++d)
        // components that differ by rounding only are equal
        if (std::abs(sum[d]) > (1. + 1e-6) * std::abs(sum[largest]))
          largest = d;
      if (sum[largest] < 0.)
        for (const unsigned int t : surface)
          turn(triangles[t]);
    }
  }
} // namespace MixedCracks
