// SPDX-License-Identifier: GPL-2.0-or-later
// K x without K. On each cell, by sum factorisation, for the blocks of
// elastic_kernel.cc at a fixed state,
//
//   (K x)_u = sum_q w_q ( C : eps(u) + s p I ) : eps(N),
//   (K x)_p = sum_q w_q ( t tr eps(u) + c p ) M,
//
// C = d sigma/d eps, s = stress_by_pressure, t = constraint_by_trace, c =
// constraint_by_pressure < 0 of the response at the point (ElasticResponse).
// Per cell of 89 unknowns in 3-d that reads 5 numbers at each of 27 points
// where C = a 1 + b I (x) I, 24 elsewhere, in place of 89^2 of the matrix; see
// Kronbichler and Kormann, Comput. Fluids 63 (2012).
//
// Constrained unknowns have the mean of the diagonal in their row, nothing
// else.

#include <assembly/matrix_free_elastic.h>

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_tools.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  MatrixFreeElastic<dim>::MatrixFreeElastic(const Fields<dim>      &fields,
                                            const Constraints<dim> &constraints)
    : fields(fields)
    , constraints(constraints)
  {}



  template <int dim>
  void
  MatrixFreeElastic<dim>::reinit()
  {
    const AffineConstraints<double> &all = constraints.elastic_corrections();
    cells = make_cell_products<dim>(fields.mapping, fields.elastic, all);
    const IndexSet &owned       = fields.elastic_dofs.owned;
    const IndexSet  of_pressure = DoFTools::extract_dofs(
      fields.elastic, fields.elastic.get_fe().component_mask(fields.pressure));
    displacements.clear();
    pressures.clear();
    constrained.clear();
    unsigned int position = 0;
    for (const auto dof : owned)
    {
      (of_pressure.is_element(dof) ? pressures : displacements)
        .push_back(position);
      if (all.is_constrained(dof))
        constrained.push_back(position);
      ++position;
    }
    source_values.resize(owned.n_elements());
    result_values.resize(owned.n_elements());
  }



  template <int dim>
  void
  MatrixFreeElastic<dim>::update(Assembler<dim> &assembler)
  {
    assembler.note_matrix();
    for (unsigned int cell = 0; cell < assembler.n_cells(); ++cell)
      cells->set_tangents(cell, assembler.tangents(cell));
    cells->compress();
    diagonal_entries.resize(fields.elastic_dofs.owned.n_elements());
    cells->diagonal(diagonal_entries.data());
    double sum = 0.;
    for (const unsigned int i : displacements)
      sum += diagonal_entries[i];
    constrained_diagonal =
      Utilities::MPI::sum(sum, fields.communicator()) / fields.elastic.n_dofs();
    for (const unsigned int i : constrained)
      diagonal_entries[i] = constrained_diagonal;
  }



  template <int dim>
  void
  MatrixFreeElastic<dim>::vmult(LinearAlgebra::Vector       &result,
                                const LinearAlgebra::Vector &source) const
  {
    cells->multiply(result.begin(), source.begin());
    for (const unsigned int i : constrained)
      result.begin()[i] = constrained_diagonal * source.begin()[i];
  }



  template <int dim>
  void
  MatrixFreeElastic<dim>::pressure_forces(double       *forces,
                                          const double *values) const
  {
    for (std::size_t k = 0; k < pressures.size(); ++k)
      source_values[pressures[k]] = values[k];
    cells->pressure_forces(result_values.data(), source_values.data());
    for (std::size_t k = 0; k < displacements.size(); ++k)
      forces[k] = result_values[displacements[k]];
  }



  template <int dim>
  void
  MatrixFreeElastic<dim>::diagonal(LinearAlgebra::Vector &result) const
  {
    std::copy(diagonal_entries.begin(), diagonal_entries.end(), result.begin());
  }



  template class MatrixFreeElastic<2>;
  template class MatrixFreeElastic<3>;
} // namespace MixedCracks
