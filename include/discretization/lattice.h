// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_lattice_h
#define mixed_cracks_discretization_lattice_h

#include <deal.II/base/tensor.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace MixedCracks
{
  /// What is left of @p vector without its parts along @p orthogonal ones.
  template <int dim>
  dealii::Tensor<1, dim>
  rest_of(dealii::Tensor<1, dim>                     vector,
          const std::vector<dealii::Tensor<1, dim>> &orthogonal);

  /// The volume of the cell of a pattern with these @p periods, holes included:
  /// of the parallelepiped of the periods, in directions across them times the
  /// extent of the coarse mesh; mm^dim.
  template <int dim>
  double
  lattice_cell_volume(const dealii::Triangulation<dim>          &mesh,
                      const std::vector<dealii::Tensor<1, dim>> &periods);
} // namespace MixedCracks

#endif
