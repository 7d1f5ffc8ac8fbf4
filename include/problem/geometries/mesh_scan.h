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
    /// Why the file cannot be used, as the end of a sentence that begins
    /// "the file"; empty when it can.
    std::string  problem;
    MeshContents contents;
  };

  /// Gmsh (.msh, version 2 to 4.1, ASCII), Abaqus (.inp) or UCD (.inp, .ucd),
  /// told apart by content. @p text: the whole file; @p dim: the dimension it
  /// is read for.
  MeshScan scan_mesh(const std::string &text, int dim);
} // namespace MixedCracks

#endif
