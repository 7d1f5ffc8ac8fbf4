// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_quad_mesh_h
#define mixed_cracks_problem_geometries_quad_mesh_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <array>
#include <functional>
#include <vector>

namespace MixedCracks
{
  /// Grid lines from the smallest to the largest of the @p fixed coordinates
  /// (any order, double ones allowed): every fixed one is a line, and each
  /// gap between two of them is divided equally into pieces of nearly
  /// @p cell_size. Units: mm.
  std::vector<double> grid_lines(std::vector<double> fixed, double cell_size);

  /// Vertices and quadrilaterals of a mesh being built; mm.
  struct QuadMesh
  {
    std::vector<dealii::Point<2>>    vertices;
    std::vector<dealii::CellData<2>> cells;

    /// Returns the index of the new vertex.
    unsigned int add_vertex(const dealii::Point<2> &position);

    /// Corners counterclockwise.
    void add_quad(const std::array<unsigned int, 4> &corners);

    /// Open a horizontal slit that enters from the left edge and ends at
    /// @p tip: every vertex on it but the tip is doubled, and the cells above
    /// get the new one.
    void open_slit(const dealii::Point<2> &tip);

    /// Move vertices towards the middle of their neighbours as long as this
    /// makes the worst cell better. Vertices on the boundary stay, and those
    /// that @p is_fixed names.
    void smooth(const std::function<bool(const dealii::Point<2> &)> &is_fixed);

    /// Longest by shortest edge of a cell, of the worst cell.
    double aspect_ratio() const;

    /// Hand the mesh to an empty triangulation.
    void create(dealii::Triangulation<2> &triangulation) const;
  };

  /// All quadrilaterals between grid lines @p x and @p y, but for those that
  /// @p is_left_out says by their centre. Vertices that no cell has are
  /// not made.
  template <typename Predicate>
  QuadMesh
  tensor_mesh(const std::vector<double> &x,
              const std::vector<double> &y,
              const Predicate           &is_left_out)
  {
    QuadMesh                  mesh;
    const unsigned int        none = dealii::numbers::invalid_unsigned_int;
    std::vector<unsigned int> index(x.size() * y.size(), none);
    const auto                corner = [&](const std::size_t i,
                            const std::size_t j) -> unsigned int {
      unsigned int &vertex = index[j * x.size() + i];
      if (vertex == none)
        vertex = mesh.add_vertex({x[i], y[j]});
      return vertex;
    };
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
        if (!is_left_out(
              dealii::Point<2>((x[i] + x[i + 1]) / 2., (y[j] + y[j + 1]) / 2.)))
          mesh.add_quad({{corner(i, j),
                          corner(i + 1, j),
                          corner(i + 1, j + 1),
                          corner(i, j + 1)}});
    return mesh;
  }

  /// Without exceptions from the rule.
  QuadMesh tensor_mesh(const std::vector<double> &x,
                       const std::vector<double> &y);
} // namespace MixedCracks

#endif
