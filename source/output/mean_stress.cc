// SPDX-License-Identifier: GPL-2.0-or-later
// With the nodal forces r^K of a cell, which are conjugate to its nodal
// displacements, and u = H X, affine and hence in the space of the cell,
//
//   integral over K of P_ij = sum over its nodes k of r^K_(k,i) X_(k,j),
//
// with the stress that balances the loads, of whichever formulation, and the
// quadrature of the equations: V <P> : dH is the work of a mean strain dH to
// the accuracy of the solver, where nothing else does work.

#include <deal.II/base/mpi.h>

#include <deal.II/fe/fe_values.h>

#include <output/mean_stress.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  Tensor<2, dim>
  integral_of_stress(const Fields<dim> &fields,
                     Assembler<dim>    &assembler,
                     const State       &state)
  {
    const FiniteElement<dim> &element = fields.elastic.get_fe();
    const FiniteElement<dim> &scalar  = element.base_element(0);
    FEValues<dim>             nodes(fields.mapping,
                        scalar,
                        scalar.get_unit_support_points(),
                        update_quadrature_points);
    Tensor<2, dim>            sum;
    dealii::Vector<double>    forces(element.n_dofs_per_cell());
    // the assembler goes through the owned cells in this order
    auto cell = fields.elastic.get_triangulation().begin_active();
    assembler.visit_states(
      state.elastic,
      state.lagged_phase_field,
      ElasticEvaluation::stresses,
      [&](const unsigned int, const ElasticKernel<dim> &kernel) {
        while (!cell->is_locally_owned())
          ++cell;
        nodes.reinit(cell);
        kernel.residual(forces);
        for (unsigned int k = 0; k < scalar.n_dofs_per_cell(); ++k)
          for (unsigned int i = 0; i < dim; ++i)
          {
            const double force =
              forces[element.component_to_system_index(i, k)];
            for (unsigned int j = 0; j < dim; ++j)
              sum[i][j] += force * nodes.quadrature_point(k)[j];
          }
        ++cell;
      });
    return Utilities::MPI::sum(sum, fields.communicator());
  }



  template Tensor<2, 2>
  integral_of_stress(const Fields<2> &, Assembler<2> &, const State &);
  template Tensor<2, 3>
  integral_of_stress(const Fields<3> &, Assembler<3> &, const State &);
} // namespace MixedCracks
