// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_scan_h
#define mixed_cracks_problem_geometries_mesh_scan_h

#include <problem/geometries/mesh_contents.h>

#include <string>

namespace MixedCracks
{
  /// What was understood of the text of a mesh file.
  struct MeshScan
  {
    MeshContents contents;
    bool         is_cut = false; ///< there were triangles or the like
  };

  /// Gmsh (.msh, version 2 to 4.1, ASCII; 2 and 4.1 binary), Abaqus (.inp), UCD
  /// (.inp, .ucd) or legacy VTK (.vtk, ASCII), told apart by content. @p bytes:
  /// the whole file; @p dim: the dimension it is read for; @p cut_simplices:
  /// see cut_cells(), else meshes that are not of quadrilaterals or hexahedra
  /// alone are a problem. Cells of the result are quadrilaterals, in 3-d
  /// hexahedra. Throws a MeshProblem.
  MeshScan
  scan_mesh(const std::string &bytes, int dim, bool cut_simplices = false);
} // namespace MixedCracks

#endif
