// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_cells_h
#define mixed_cracks_problem_geometries_mesh_cells_h

#include <problem/geometries/mesh_contents.h>

#include <vector>

namespace MixedCracks
{
  /// Make a cell that is inside out one that is not, by another order of its
  /// nodes. Throws a MeshProblem about a cell that is degenerate or twisted,
  /// with its number and the node.
  template <int dim>
  void orient_cell(const MeshContents &contents, MeshContents::Cell &cell);

  /// The faces of a cell, each as indices of its nodes around it.
  template <int dim>
  std::vector<std::vector<unsigned int>>
  faces_of_cell(const MeshContents::Cell &cell);
} // namespace MixedCracks

#endif
