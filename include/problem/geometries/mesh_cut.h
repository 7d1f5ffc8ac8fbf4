// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_cut_h
#define mixed_cracks_problem_geometries_mesh_cut_h

#include <problem/geometries/mesh_contents.h>

namespace MixedCracks
{
  /// The first cell of @p contents that is no quadrilateral, in 3-d no
  /// hexahedron; null when there is none.
  const MeshContents::Cell *first_simplex(const MeshContents &contents,
                                          int                 dim);

  /// Cut every cell into one piece for each of its corners: a triangle into
  /// three quadrilaterals, a quadrilateral into four, a tetrahedron into four
  /// hexahedra, a prism into six, a hexahedron into eight. Groups of faces and
  /// of nodes go to the pieces. New nodes have the number
  /// MeshContents::Node::none, pieces that of their cell. Throws a
  /// MeshProblem where that is impossible.
  void cut_cells(MeshContents &contents, int dim);
} // namespace MixedCracks

#endif
