// SPDX-License-Identifier: GPL-2.0-or-later
// A triangle is cut as its polygon: going around, vertices above the level are
// kept, and where a side passes it comes a vertex at
//
//   x = x_a + t (x_b - x_a),   t = (level - v_a)/(v_b - v_a),
//
// the same one for both triangles at the side. What is left has three or four
// corners.

#include <cracks/sheet_mesh.h>

#include <cmath>
#include <numeric>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // of the cell size: corners of neighbouring cells differ by rounding, those
    // of one cell near a vertex of it by 1e-7 l
    constexpr double one_vertex = 1e-5;
  } // namespace



  PointBoxes::Box
  PointBoxes::box_of(const Point<3> &point) const
  {
    Box box;
    for (unsigned int d = 0; d < 3; ++d)
      box[d] = std::lround(std::floor(point[d] / size));
    return box;
  }



  SheetMesh::SheetMesh(const std::vector<RidgeTriangle> &all,
                       const double                      cell_size,
                       std::vector<double>              &phase_field)
  {
    const double tolerance = one_vertex * cell_size;
    PointBoxes   known(4. * tolerance);
    const auto   vertex_at = [&](const Point<3> &point) {
      unsigned int number = vertices.size();
      known.near(point, [&](const unsigned int other) {
        if (vertices[other].distance(point) < tolerance)
          number = std::min(number, other);
      });
      if (number == vertices.size())
      {
        known.add(point, number);
        vertices.push_back(point);
      }
      return number;
    };
    for (const RidgeTriangle &one : all)
    {
      Triangle triangle{{}, one.boundary};
      for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int vertex = vertex_at(one.corners[i]);
        phase_field.resize(vertices.size(), 1.);
        phase_field[vertex] = std::min(phase_field[vertex], one.phase_field[i]);
        triangle.vertices[i] = vertex;
      }
      add(triangle);
    }
  }



  // but for those without an area
  void
  SheetMesh::add(const Triangle &triangle)
  {
    const auto &[a, b, c] = triangle.vertices;
    if (a != b && b != c && c != a)
      triangles.push_back(triangle);
  }



  SheetMesh
  SheetMesh::above(const std::vector<double> &values, const double level) const
  {
    SheetMesh                    result;
    std::map<Side, unsigned int> on_sides;
    result.vertices        = vertices;
    const auto crossing_of = [&](const unsigned int one,
                                 const unsigned int other) {
      const auto [a, b]        = side_between(one, other);
      const auto [found, new_] = on_sides.try_emplace({a, b}, 0u);
      if (new_)
      {
        const double t = (level - values[a]) / (values[b] - values[a]);
        found->second  = result.vertices.size();
        result.vertices.push_back(vertices[a] +
                                  t * (vertices[b] - vertices[a]));
      }
      return found->second;
    };
    for (const Triangle &triangle : triangles)
    {
      // corners of what is left, and the kind of the side behind each
      std::vector<unsigned int> corners;
      std::vector<int>          kinds;
      for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int a = triangle.vertices[i],
                           b = triangle.vertices[(i + 1) % 3];
        const bool has_a = values[a] > level, has_b = values[b] > level;
        if (has_a)
        {
          corners.push_back(a);
          kinds.push_back(triangle.sides[i]);
        }
        if (has_a != has_b)
        {
          corners.push_back(crossing_of(a, b));
          kinds.push_back(has_a ? cut_side : triangle.sides[i]);
        }
      }
      if (corners.size() == 3)
        result.add({{{corners[0], corners[1], corners[2]}},
                    {{kinds[0], kinds[1], kinds[2]}}});
      if (corners.size() == 4)
      {
        constexpr int inside = RidgeTriangle::inside;
        result.add({{{corners[0], corners[1], corners[2]}},
                    {{kinds[0], kinds[1], inside}}});
        result.add({{{corners[0], corners[2], corners[3]}},
                    {{inside, kinds[2], kinds[3]}}});
      }
    }
    return result;
  }



  SheetMesh
  SheetMesh::only(const std::vector<unsigned int> &numbers) const
  {
    SheetMesh result;
    result.vertices = vertices;
    for (const unsigned int t : numbers)
      result.triangles.push_back(triangles[t]);
    return result;
  }



  std::map<SheetMesh::Side, std::vector<SheetMesh::SideOf>>
  SheetMesh::sides() const
  {
    std::map<Side, std::vector<SideOf>> result;
    for (unsigned int t = 0; t < triangles.size(); ++t)
      for (unsigned int i = 0; i < 3; ++i)
        result[side_between(triangles[t].vertices[i],
                            triangles[t].vertices[(i + 1) % 3])]
          .push_back({t, i});
    return result;
  }



  std::vector<SheetMesh::SideOf>
  SheetMesh::open_sides() const
  {
    std::vector<SideOf> result;
    for (const auto &[side, of] : sides())
      if (of.size() == 1)
        result.push_back(of.front());
    return result;
  }



  std::vector<std::vector<unsigned int>>
  SheetMesh::parts(const double distance) const
  {
    std::vector<unsigned int> label(vertices.size());
    std::iota(label.begin(), label.end(), 0u);
    const auto root = [&label](unsigned int vertex) {
      while (label[vertex] != vertex)
        vertex = label[vertex] = label[label[vertex]];
      return vertex;
    };
    const auto join = [&](const unsigned int a, const unsigned int b) {
      const unsigned int one = root(a), other = root(b);
      label[std::max(one, other)] = std::min(one, other);
    };
    PointBoxes        boxes(distance);
    std::vector<bool> is_used(vertices.size(), false);
    for (const Triangle &triangle : triangles)
      for (const unsigned int vertex : triangle.vertices)
      {
        join(vertex, triangle.vertices[0]);
        if (is_used[vertex])
          continue;
        is_used[vertex] = true;
        boxes.near(vertices[vertex], [&](const unsigned int other) {
          if (vertices[vertex].distance(vertices[other]) < distance)
            join(vertex, other);
        });
        boxes.add(vertices[vertex], vertex);
      }
    std::map<unsigned int, std::vector<unsigned int>> by_label;
    for (unsigned int t = 0; t < triangles.size(); ++t)
      by_label[root(triangles[t].vertices[0])].push_back(t);
    std::vector<std::vector<unsigned int>> result;
    for (const auto &[number, members] : by_label)
      result.push_back(members);
    return result;
  }



  Tensor<1, 3>
  SheetMesh::area_vector(const Triangle &triangle) const
  {
    const auto &[a, b, c] = triangle.vertices;
    return 0.5 * cross_product_3d(vertices[b] - vertices[a],
                                  vertices[c] - vertices[a]);
  }



  double
  SheetMesh::length(const SideOf &side) const
  {
    const auto [a, b] = ends(side);
    return a.distance(b);
  }
} // namespace MixedCracks
