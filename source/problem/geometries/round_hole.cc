// SPDX-License-Identifier: GPL-2.0-or-later
// A hole that stays round when cells are refined: new nodes on its boundary are
// put on the circle (cylinder) through those that are there, those in the
// cells beside it are interpolated between the hole and the straight other
// sides (transfinite interpolation), so that refined cells do not fold there.

#include <deal.II/grid/manifold_lib.h>

#include <problem/geometries/round_hole.h>

#include <memory>

namespace MixedCracks
{
  namespace
  {
    constexpr dealii::types::manifold_id circle_manifold = 1;
    constexpr dealii::types::manifold_id ring_manifold   = 2;



    // circle in 2-d, cylinder along z in 3-d
    template <int dim>
    std::unique_ptr<dealii::Manifold<dim>>
    round_hole(const dealii::Point<2> &center)
    {
      if constexpr (dim == 2)
        return std::make_unique<dealii::SphericalManifold<2>>(center);
      else
        return std::make_unique<dealii::CylindricalManifold<3>>(
          dealii::Tensor<1, 3>({0., 0., 1.}),
          dealii::Point<3>(center[0], center[1], 0.));
    }



    // of a cell beside the hole; in 3-d its ends in z as well, whose plane
    // holds a piece of the circle
    template <typename Cell>
    void
    set_ring_manifold(const Cell &cell)
    {
      cell->set_manifold_id(ring_manifold);
      if (Cell::AccessorType::dimension == 3)
        for (const unsigned int face : {4, 5})
          cell->face(face)->set_manifold_id(ring_manifold);
    }
  } // namespace



  template <int dim>
  void
  make_round(const dealii::types::boundary_id boundary,
             const dealii::Point<2>          &center,
             dealii::Triangulation<dim>      &triangulation)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            cell->face(f)->boundary_id() == boundary)
        {
          set_ring_manifold(cell);
          // in 3-d with its edges
          cell->face(f)->set_all_manifold_ids(circle_manifold);
        }
    triangulation.set_manifold(circle_manifold, *round_hole<dim>(center));
    dealii::TransfiniteInterpolationManifold<dim> ring;
    ring.initialize(triangulation);
    triangulation.set_manifold(ring_manifold, ring);
  }



  template void make_round(dealii::types::boundary_id,
                           const dealii::Point<2> &,
                           dealii::Triangulation<2> &);
  template void make_round(dealii::types::boundary_id,
                           const dealii::Point<2> &,
                           dealii::Triangulation<3> &);
} // namespace MixedCracks
