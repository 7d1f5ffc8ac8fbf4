// SPDX-License-Identifier: GPL-2.0-or-later
// K x without K. On each cell, by sum factorisation, for the blocks of
// elastic_kernel.cc at a fixed state,
//
//   (K x)_u = sum_q w_q ( C : eps(u) + s p I ) : eps(N),
//   (K x)_p = sum_q w_q ( t tr eps(u) + c p ) M,
//
// C = d sigma/d eps, s = stress_by_pressure, t = constraint_by_trace, c =
// constraint_by_pressure < 0 of the response at the point (ElasticResponse).
// Per cell of 89 unknowns in 3-d that reads at most 5 numbers at each of 27
// points where C = a 1 + b I (x) I, 24 elsewhere (lane_tangents.h), in place of
// 89^2 of the matrix; see Kronbichler and Kormann, Comput. Fluids 63 (2012).
//
// Constrained unknowns have the mean of the diagonal in their row, nothing
// else.

#include <assembly/matrix_free_elastic.h>

#include <algorithm>

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
    constrained.clear();
    unsigned int position = 0;
    for (const auto dof : fields.elastic_dofs.owned)
    {
      if (all.is_constrained(dof))
        constrained.push_back(position);
      ++position;
    }
  }



  template <int dim>
  void
  MatrixFreeElastic<dim>::update(Assembler<dim> &assembler)
  {
    assembler.note_matrix();
    for (unsigned int cell = 0; cell < assembler.n_cells(); ++cell)
      cells->set_tangents(cell, assembler.tangents(cell));
    cells->reinit(diagonal_entries);
    cells->diagonal(diagonal_entries);
    constrained_diagonal = diagonal_entries.mean_value();
    for (const unsigned int i : constrained)
      diagonal_entries.local_element(i) = constrained_diagonal;
  }



  template <int dim>
  void
  MatrixFreeElastic<dim>::vmult(Vector &result, const Vector &source) const
  {
    vmult(
      result,
      source,
      [&](const unsigned int first, const unsigned int second) {
        std::fill(result.begin() + first, result.begin() + second, 0.);
      },
      [](const unsigned int, const unsigned int) {});
    for (const unsigned int i : constrained)
      result.local_element(i) = constrained_diagonal * source.local_element(i);
  }



  template <int dim>
  void
  MatrixFreeElastic<dim>::diagonal(Vector &result) const
  {
    result = diagonal_entries;
  }



  template class MatrixFreeElastic<2>;
  template class MatrixFreeElastic<3>;
} // namespace MixedCracks
