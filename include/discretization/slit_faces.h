// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_slit_faces_h
#define mixed_cracks_discretization_slit_faces_h

#include <base/flat_piece.h>

#include <deal.II/grid/tria.h>

#include <array>
#include <vector>

namespace MixedCracks
{
  /// A piece of a slit: two boundary faces of the coarse mesh at the same
  /// place, of different cells, between nodes that are doubled (but at tips).
  template <int dim>
  struct SlitFace
  {
    struct Side
    {
      dealii::types::coarse_cell_id cell;
      unsigned int                  face; ///< of that cell
    };

    std::array<Side, 2>    sides;
    FlatPiece<dim>         place;  ///< mm
    dealii::Tensor<1, dim> normal; ///< outward of the first side, of length 1
  };

  /// All slits of a mesh, found by the places of its boundary faces; the same
  /// on every rank, which knows the coarse mesh.
  template <int dim>
  std::vector<SlitFace<dim>>
  slit_faces(const dealii::Triangulation<dim> &triangulation);
} // namespace MixedCracks

#endif
