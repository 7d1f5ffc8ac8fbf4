// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_sheet_mesh_h
#define mixed_cracks_cracks_sheet_mesh_h

#include <cracks/damage_ridge.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// A surface of triangles with common vertices; the sheets of all cracks.
  class SheetMesh
  {
  public:
    /// A side that came about where the surface was cut.
    static constexpr int cut_side = -2;

    struct Triangle
    {
      std::array<unsigned int, 3> vertices;
      /// from vertex i to i + 1: see RidgeTriangle::boundary, or cut_side
      std::array<int, 3> sides;
    };

    /// Two vertices, the smaller number first.
    using Side = std::pair<unsigned int, unsigned int>;

    /// What joins triangles at a side.
    struct SideOf
    {
      unsigned int triangle;
      unsigned int number; ///< of the side in it
    };

    SheetMesh() = default;

    /// Corners within a small part of @p cell_size (mm) are one vertex, with
    /// the smaller @p phase_field, which is filled.
    SheetMesh(const std::vector<RidgeTriangle> &triangles,
              double                            cell_size,
              std::vector<double>              &phase_field);

    /// The part in which @p values at the vertices are larger than a @p level,
    /// linear in between. New sides are cut sides. Vertices stay, new ones
    /// come behind them.
    SheetMesh above(const std::vector<double> &values, double level) const;

    /// Some of the triangles, with all vertices.
    SheetMesh only(const std::vector<unsigned int> &numbers) const;

    /// Turn triangles so that neighbours agree; of each surface the largest
    /// component of the mean normal is positive.
    void turn_alike();

    /// The triangles of each part; parts nearer than @p distance, mm, are one.
    std::vector<std::vector<unsigned int>> parts(double distance) const;

    /// Those that belong to one triangle only.
    std::vector<SideOf> open_sides() const;

    /// Normal times area, mm^2.
    dealii::Tensor<1, 3> area_vector(const Triangle &triangle) const;

    /// Of a side, mm.
    double length(const SideOf &side) const;

    std::pair<dealii::Point<3>, dealii::Point<3>>
    ends(const SideOf &side) const
    {
      const Triangle &triangle = triangles[side.triangle];
      return {vertices[triangle.vertices[side.number]],
              vertices[triangle.vertices[(side.number + 1) % 3]]};
    }

    int
    kind(const SideOf &side) const
    {
      return triangles[side.triangle].sides[side.number];
    }

    std::vector<dealii::Point<3>> vertices; ///< mm
    std::vector<Triangle>         triangles;

  private:
    static Side
    side_between(const unsigned int a, const unsigned int b)
    {
      return {std::min(a, b), std::max(a, b)};
    }

    std::map<Side, std::vector<SideOf>> sides() const;
    std::vector<std::vector<unsigned int>>
    turn_neighbours(const std::map<Side, std::vector<SideOf>> &by_vertices);
    void turn(Triangle &triangle) const;
    void
    turn_against(unsigned int a, unsigned int b, Triangle &neighbour) const;
    void add(const Triangle &triangle);
  };

  /// Finds what is near a point, by boxes.
  class PointBoxes
  {
  public:
    explicit PointBoxes(const double size)
      : size(size)
    {}

    void
    add(const dealii::Point<3> &point, const unsigned int number)
    {
      boxes[box_of(point)].push_back(number);
    }

    /// Call @p visit with all numbers of points within the size, and others.
    template <typename Visit>
    void
    near(const dealii::Point<3> &point, const Visit &visit) const
    {
      const Box home = box_of(point);
      for (long i = -1; i <= 1; ++i)
        for (long j = -1; j <= 1; ++j)
          for (long k = -1; k <= 1; ++k)
          {
            const auto box =
              boxes.find({{home[0] + i, home[1] + j, home[2] + k}});
            if (box != boxes.end())
              for (const unsigned int number : box->second)
                visit(number);
          }
    }

  private:
    using Box = std::array<long, 3>;

    Box box_of(const dealii::Point<3> &point) const;

    const double                             size;
    std::map<Box, std::vector<unsigned int>> boxes;
  };
} // namespace MixedCracks

#endif
