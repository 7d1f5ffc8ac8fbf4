// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_shapes_h
#define mixed_cracks_problem_geometries_mesh_shapes_h

#include <string>
#include <vector>

namespace MixedCracks
{
  namespace MeshScanning
  {
    /// A kind of element, by the names and numbers of the formats. Its corners
    /// come first in each of them; what follows are nodes of second order.
    struct ElementShape
    {
      std::string  name; ///< in the plural, of the elements of first order
      int          dim;
      unsigned int n_corners;
      unsigned int n_nodes;
      int          gmsh_type; ///< of Gmsh's manual, "MSH file format"
      int          vtk_type;  ///< of vtkCellType.h; 0 for none
      std::string  ucd_type;  ///< empty for none

      bool
      is_second_order() const
      {
        return n_nodes > n_corners;
      }

      /// "triangles", "triangles of 6 nodes"
      std::string in_words() const;
    };

    /// Null where there is none of that number or name, or where it has more
    /// nodes than elements of second order.
    const ElementShape *shape_of_gmsh(long int type);
    const ElementShape *shape_of_vtk(long int type);
    const ElementShape *shape_of_ucd(const std::string &type);

    /// The shape of a dimension with so many nodes: they tell the shape.
    const ElementShape *shape_of_nodes(int dim, std::size_t n_nodes);

    /// The faces of a cell of dimension 3, or the sides of one of dimension 2,
    /// as places of corners: around, in the order in which Abaqus counts them.
    const std::vector<std::vector<unsigned int>> &
    sides_of(int dim, std::size_t n_corners);
  } // namespace MeshScanning
} // namespace MixedCracks

#endif
