// SPDX-License-Identifier: GPL-2.0-or-later
// Meshes of hexahedra as the texts of mesh files.
#ifndef mixed_cracks_tests_hex_meshes_h
#define mixed_cracks_tests_hex_meshes_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace GeometryTests
{
  // Cells count their corners as Gmsh, Abaqus and UCD do: one face around, then
  // the opposite one.
  struct HexMesh
  {
    struct Cell
    {
      std::array<unsigned int, 8> corners;
      int                         material;
    };

    struct Face
    {
      std::array<unsigned int, 4> corners;
      int                         boundary;
      unsigned int                cell;
      unsigned int                side; // of Abaqus, from 1
    };

    std::vector<dealii::Point<3>> nodes;
    std::vector<Cell>             cells;
    std::vector<Face>             faces;

    std::string gmsh2() const;

    std::string abaqus() const;

    std::string ucd() const;
  };

  // The box from the origin to (n_x, n_y, 1) of unit cubes, moved by @p place.
  // Materials: 7 where x < 1, otherwise 8. Faces: 1 at y = 0, 2 at y = n_y.
  inline HexMesh
  unit_cubes(
    const unsigned int                                               n_x,
    const unsigned int                                               n_y,
    const std::function<dealii::Point<3>(const dealii::Point<3> &)> &place =
      [](const dealii::Point<3> &x) { return x; })
  {
    HexMesh    mesh;
    const auto node = [&](unsigned int i, unsigned int j, unsigned int k) {
      return (k * (n_y + 1) + j) * (n_x + 1) + i;
    };
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int j = 0; j <= n_y; ++j)
        for (unsigned int i = 0; i <= n_x; ++i)
          mesh.nodes.push_back(place({1. * i, 1. * j, 1. * k}));
    for (unsigned int j = 0; j < n_y; ++j)
      for (unsigned int i = 0; i < n_x; ++i)
      {
        const unsigned int number = mesh.cells.size();
        mesh.cells.push_back({{{node(i, j, 0),
                                node(i + 1, j, 0),
                                node(i + 1, j + 1, 0),
                                node(i, j + 1, 0),
                                node(i, j, 1),
                                node(i + 1, j, 1),
                                node(i + 1, j + 1, 1),
                                node(i, j + 1, 1)}},
                              i == 0 ? 7 : 8});
        const auto &c = mesh.cells.back().corners;
        if (j == 0)
          mesh.faces.push_back({{{c[0], c[1], c[5], c[4]}}, 1, number, 3});
        if (j + 1 == n_y)
          mesh.faces.push_back({{{c[2], c[3], c[7], c[6]}}, 2, number, 5});
      }
    return mesh;
  }

  // The same cell, its corners counted from another one: 0 to 3 quarter turns
  // about its third axis, then the three axes cyclically exchanged or not.
  inline void
  turn(HexMesh::Cell &cell, const unsigned int turns, const bool exchange)
  {
    for (unsigned int i = 0; i < turns; ++i)
    {
      std::rotate(cell.corners.begin(),
                  cell.corners.begin() + 1,
                  cell.corners.begin() + 4);
      std::rotate(
        cell.corners.begin() + 4, cell.corners.begin() + 5, cell.corners.end());
    }
    const auto c = cell.corners;
    if (exchange)
      cell.corners = {{c[0], c[4], c[5], c[1], c[3], c[7], c[6], c[2]}};
  }

  // Turned inside out.
  inline void
  mirror(HexMesh::Cell &cell)
  {
    std::swap_ranges(
      cell.corners.begin(), cell.corners.begin() + 4, cell.corners.begin() + 4);
  }

  template <typename Container>
  std::string
  numbers(const Container &nodes, const std::string &separator)
  {
    std::string text;
    for (const unsigned int node : nodes)
      text += separator + std::to_string(node + 1);
    return text;
  }

  inline std::string
  coordinates(const dealii::Point<3> &point, const std::string &separator)
  {
    std::ostringstream text;
    text.precision(16);
    for (unsigned int d = 0; d < 3; ++d)
      text << separator << point[d];
    return text.str();
  }

  inline std::string
  HexMesh::gmsh2() const
  {
    std::ostringstream text;
    text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
         << nodes.size() << '\n';
    for (unsigned int i = 0; i < nodes.size(); ++i)
      text << i + 1 << coordinates(nodes[i], " ") << '\n';
    text << "$EndNodes\n$Elements\n" << faces.size() + cells.size() << '\n';
    unsigned int n = 0;
    for (const Face &face : faces)
      text << ++n << " 3 2 " << face.boundary << ' ' << face.boundary
           << numbers(face.corners, " ") << '\n';
    for (const Cell &cell : cells)
      text << ++n << " 5 2 " << cell.material << ' ' << cell.material
           << numbers(cell.corners, " ") << '\n';
    text << "$EndElements\n";
    return text.str();
  }

  inline std::string
  HexMesh::abaqus() const
  {
    std::ostringstream text;
    text << "*HEADING\n*NODE\n";
    for (unsigned int i = 0; i < nodes.size(); ++i)
      text << i + 1 << coordinates(nodes[i], ", ") << '\n';
    text << "*ELEMENT, TYPE=C3D8R, ELSET=EB7\n";
    for (unsigned int i = 0; i < cells.size(); ++i)
      text << i + 1 << numbers(cells[i].corners, ", ") << '\n';
    for (const int boundary : {1, 2})
    {
      text << "*SURFACE, NAME=SS" << boundary << '\n';
      for (const Face &face : faces)
        if (face.boundary == boundary)
          text << face.cell + 1 << ", S" << face.side << '\n';
    }
    return text.str();
  }

  inline std::string
  HexMesh::ucd() const
  {
    std::ostringstream text;
    text << nodes.size() << ' ' << faces.size() + cells.size() << " 0 0 0\n";
    for (unsigned int i = 0; i < nodes.size(); ++i)
      text << i + 1 << coordinates(nodes[i], " ") << '\n';
    unsigned int n = 0;
    for (const Cell &cell : cells)
      text << ++n << ' ' << cell.material << " hex"
           << numbers(cell.corners, " ") << '\n';
    for (const Face &face : faces)
      text << ++n << ' ' << face.boundary << " quad"
           << numbers(face.corners, " ") << '\n';
    return text.str();
  }
} // namespace GeometryTests

#endif
