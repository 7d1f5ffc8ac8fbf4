// SPDX-License-Identifier: GPL-2.0-or-later
#include <assembly/assembler.h>

namespace MixedCracks
{
  template <int dim>
  void
  Assembler<dim>::visit_tangents(
    const std::function<void(unsigned int,
                             const CellGeometry<dim> &,
                             const std::vector<ElasticResponse<dim>> &)> &body)
  {
    const std::size_t n = fields.quadrature.size();
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      elastic_kernel.reinit(cells->geometry(cell), (*constants)[cell]);
      elastic_kernel.set_points(&of_matrix[cell * n]);
      body(cell, cells->geometry(cell), elastic_kernel.point_responses());
    }
  }



  template void Assembler<2>::visit_tangents(
    const std::function<void(unsigned int,
                             const CellGeometry<2> &,
                             const std::vector<ElasticResponse<2>> &)> &);
  template void Assembler<3>::visit_tangents(
    const std::function<void(unsigned int,
                             const CellGeometry<3> &,
                             const std::vector<ElasticResponse<3>> &)> &);
} // namespace MixedCracks
