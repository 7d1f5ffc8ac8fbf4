// SPDX-License-Identifier: GPL-2.0-or-later
// Kinds of elements up to second order. Corners are counted alike by Gmsh,
// Abaqus, UCD and VTK: around, in prisms and hexahedra around twice, the top of
// a pyramid last. (VTK's prisms are turned inside out, which is mended with
// the other cells that are.)

#include <problem/geometries/mesh_shapes.h>

#include <algorithm>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      const std::vector<ElementShape> shapes = {
        {"points", 0, 1, 1, 15, 1, "pt"},
        {"lines", 1, 2, 2, 1, 3, "line"},
        {"lines", 1, 2, 3, 8, 21, ""},
        {"triangles", 2, 3, 3, 2, 5, "tri"},
        {"triangles", 2, 3, 6, 9, 22, ""},
        {"quadrilaterals", 2, 4, 4, 3, 9, "quad"},
        {"quadrilaterals", 2, 4, 8, 16, 23, ""},
        {"quadrilaterals", 2, 4, 9, 10, 28, ""},
        {"tetrahedra", 3, 4, 4, 4, 10, "tet"},
        {"tetrahedra", 3, 4, 10, 11, 24, ""},
        {"hexahedra", 3, 8, 8, 5, 12, "hex"},
        {"hexahedra", 3, 8, 20, 17, 25, ""},
        {"hexahedra", 3, 8, 27, 12, 29, ""},
        {"prisms", 3, 6, 6, 6, 13, "prism"},
        {"prisms", 3, 6, 15, 18, 26, ""},
        {"prisms", 3, 6, 18, 13, 32, ""},
        {"pyramids", 3, 5, 5, 7, 14, "pyr"},
        {"pyramids", 3, 5, 13, 19, 27, ""},
        {"pyramids", 3, 5, 14, 14, 0, ""}};



      template <typename Condition>
      const ElementShape *
      first_with(const Condition &condition)
      {
        const auto shape =
          std::find_if(shapes.begin(), shapes.end(), condition);
        return shape == shapes.end() ? nullptr : &*shape;
      }
    } // namespace



    std::string
    ElementShape::in_words() const
    {
      return name + (is_second_order()
                       ? " of " + std::to_string(n_nodes) + " nodes"
                       : "");
    }



    const ElementShape *
    shape_of_gmsh(const long int type)
    {
      return first_with(
        [&](const ElementShape &shape) { return shape.gmsh_type == type; });
    }



    const ElementShape *
    shape_of_vtk(const long int type)
    {
      return first_with([&](const ElementShape &shape) {
        return shape.vtk_type > 0 && shape.vtk_type == type;
      });
    }



    const ElementShape *
    shape_of_ucd(const std::string &type)
    {
      return first_with([&](const ElementShape &shape) {
        return !shape.ucd_type.empty() && shape.ucd_type == type;
      });
    }



    const ElementShape *
    shape_of_nodes(const int dim, const std::size_t n_nodes)
    {
      return first_with([&](const ElementShape &shape) {
        return shape.dim == dim && shape.n_nodes == n_nodes;
      });
    }



    const std::vector<std::vector<unsigned int>> &
    sides_of(const int dim, const std::size_t n_corners)
    {
      using Sides                      = std::vector<std::vector<unsigned int>>;
      static const Sides triangle      = {{0, 1}, {1, 2}, {2, 0}};
      static const Sides quadrilateral = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
      static const Sides tetrahedron   = {
          {0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
      static const Sides pyramid = {
        {0, 1, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};
      static const Sides prism = {
        {0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}};
      static const Sides hexahedron = {{0, 1, 2, 3},
                                       {4, 7, 6, 5},
                                       {0, 4, 5, 1},
                                       {1, 5, 6, 2},
                                       {2, 6, 7, 3},
                                       {3, 7, 4, 0}};
      if (dim == 2)
        return n_corners == 3 ? triangle : quadrilateral;
      return n_corners == 4   ? tetrahedron
             : n_corners == 5 ? pyramid
             : n_corners == 6 ? prism
                              : hexahedron;
    }
  } // namespace MeshScanning
} // namespace MixedCracks
