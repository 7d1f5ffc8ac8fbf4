// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_scan_h
#define mixed_cracks_problem_geometries_mesh_scan_h

#include <string>

namespace MixedCracks
{
  /// A first look at the text of a mesh file: which format it is, and whether
  /// deal.II's readers, which trust what they read, can be let at it.
  struct MeshScan
  {
    enum Format
    {
      unknown,
      gmsh,   ///< .msh, version 2 to 4.1, ASCII
      abaqus, ///< .inp with *NODE and *ELEMENT
      ucd     ///< AVS UCD, .inp or .ucd
    };

    Format format = unknown;
    /// Why the file cannot be used, as the end of a sentence that begins
    /// "the file"; empty when it can.
    std::string problem;
  };

  /// @p text: the whole file; @p dim: the dimension it is read for.
  MeshScan scan_mesh(const std::string &text, int dim);
} // namespace MixedCracks

#endif
