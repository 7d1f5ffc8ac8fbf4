// SPDX-License-Identifier: GPL-2.0-or-later
// With L(u, p) of elastic_kernel_finite.cc, concave in p,
//
//   Pi(u) = max over the discrete p of L(u, p),   dPi/du = dL/du at that p.
//
// The maximum by Newton's method, which takes one step where dL/dp is linear in
// p (all but plane stress, where F_33 depends on p, and p through 0 with a
// split):
//
//   M d = r,   r_k = dL/dp_k = sum_q w_q c M_k,   M_kl = sum_q m_q M_k M_l,
//
// m_q = w_q (-dc/dp), r in mm^2, M in mm^2/MPa, d in MPa; p <- p + d gains
// r.d/2. M is the mass matrix of the continuous linear pressure with a weight
// that varies by orders of magnitude: scaled with its diagonal its condition
// number is bounded all the same (that of the matrix of one cell, 9 in 2-d and
// 27 in 3-d, where the weight is constant in each cell [Wathen, IMA J. Numer.
// Anal. 7 (1987)]), and conjugate gradients take some twenty iterations. Their
// error enters the potential squared; a p that is not quite the one of the
// maximum makes it a little too small.
//
// Newton's direction for R(u, p) = 0 descends on Pi where A + B^T M^-1 B is
// positive definite: with p the present pressure and p_u the eliminated one,
// A d_u + B^T d_p = -R_u(u, p) and B d_u - M d_p = -R_p give
//
//   (A + B^T M^-1 B) d_u = - dPi/du,     as R_p = M (p_u - p).

#include <assembly/elastic_potential.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>

#include <discretization/sparse_matrix.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // of Newton's method for p; relative to the potential
    constexpr unsigned int most_steps    = 8;
    constexpr double       smallest_gain = 1e-12;

    // of the conjugate gradients
    constexpr unsigned int most_iterations  = 200;
    constexpr double       linear_tolerance = 1e-8;
  } // namespace



  template <int dim>
  ElasticPotential<dim>::ElasticPotential(const Fields<dim>      &fields,
                                          const Constraints<dim> &constraints,
                                          Assembler<dim>         &assembler)
    : fields(fields)
    , constraints(constraints)
    , assembler(assembler)
  {}



  template <int dim>
  void
  ElasticPotential<dim>::reinit()
  {
    if (!fields.layout.mixed)
      return;
    Table<2, DoFTools::Coupling> couplings(dim + 1, dim + 1);
    couplings.fill(DoFTools::none);
    couplings(dim, dim) = DoFTools::always;
    make_sparse_matrix(fields.elastic,
                       fields.elastic_dofs,
                       constraints.elastic_periodic(),
                       couplings,
                       mass);
  }



  // L(u, p), and dL/dp in the rows of the pressure
  template <int dim>
  double
  ElasticPotential<dim>::evaluate(
    const LinearAlgebra::Vector &lagged_phase_field,
    LinearAlgebra::Vector       &residual)
  {
    double                           sum = 0., terms = 0.;
    CellDofs<dim>                   &cells = assembler.elastic_dofs();
    const std::vector<unsigned int> &pressures =
      assembler.kernel().pressure_indices();
    std::vector<types::global_dof_index> all, indices(pressures.size());
    dealii::Vector<double> local(fields.elastic.get_fe().n_dofs_per_cell());
    dealii::Vector<double> local_pressures(pressures.size());
    FullMatrix<double>     local_mass(pressures.size());
    all.resize(local.size());
    mass     = 0.;
    residual = 0.;
    assembler.visit_states(
      state,
      lagged_phase_field,
      ElasticEvaluation::tangents,
      [&](const unsigned int cell, const ElasticKernel<dim> &kernel) {
        sum += kernel.potential();
        terms += kernel.potential_terms();
        kernel.residual(local);
        kernel.pressure_mass(local_mass);
        cells.global_indices(cell, all);
        for (unsigned int k = 0; k < pressures.size(); ++k)
        {
          indices[k]         = all[pressures[k]];
          local_pressures[k] = local[pressures[k]];
        }
        constraints.elastic_periodic().distribute_local_to_global(
          local_mass, local_pressures, indices, mass, residual);
      });
    mass.compress(VectorOperation::add);
    residual.compress(VectorOperation::add);
    return sum_up(sum, terms);
  }



  template <int dim>
  void
  ElasticPotential<dim>::solve_with_mass(
    const LinearAlgebra::Vector &right_hand_side,
    LinearAlgebra::Vector       &solution) const
  {
    // rows of displacements are 0, in all vectors too
    LinearAlgebra::Vector inverse_diagonal(right_hand_side);
    for (const auto i : right_hand_side.locally_owned_elements())
    {
      const double value  = mass.el(i, i); // 0 without an entry
      inverse_diagonal(i) = value == 0. ? 1. : 1. / value;
    }
    inverse_diagonal.compress(VectorOperation::insert);
    const DiagonalMatrix<LinearAlgebra::Vector> preconditioner(
      inverse_diagonal);
    // no exception where the tolerance is not met
    IterationNumberControl control(
      most_iterations, linear_tolerance * right_hand_side.l2_norm());
    solution = 0.;
    try
    {
      SolverCG<LinearAlgebra::Vector>(control).solve(
        mass, solution, right_hand_side, preconditioner);
    }
    catch (const SolverControl::NoConvergence &)
    {
      // not finite, on all ranks: nor is the potential
    }
  }



  template <int dim>
  double
  ElasticPotential<dim>::value(const LinearAlgebra::Vector &elastic,
                               const LinearAlgebra::Vector &lagged_phase_field)
  {
    state.reinit(fields.elastic_dofs.owned,
                 fields.elastic_dofs.relevant,
                 fields.communicator());
    state = elastic;
    return fields.layout.mixed ? eliminate_pressure(lagged_phase_field)
                               : present_value(lagged_phase_field);
  }



  template <int dim>
  double
  ElasticPotential<dim>::present_value(
    const LinearAlgebra::Vector &lagged_phase_field)
  {
    double sum = 0., terms = 0.;
    assembler.visit_states(state,
                           lagged_phase_field,
                           ElasticEvaluation::points,
                           [&](unsigned int, const ElasticKernel<dim> &kernel) {
                             sum += kernel.potential();
                             terms += kernel.potential_terms();
                           });
    return sum_up(sum, terms);
  }



  template <int dim>
  double
  ElasticPotential<dim>::sum_up(const double value, const double terms)
  {
    std::vector<double> sums = {value, terms};
    Utilities::MPI::sum(sums, fields.communicator(), sums);
    terms_of_value = sums[1];
    return sums[0];
  }



  // From the pressure in `state` to the one where L is largest.
  template <int dim>
  double
  ElasticPotential<dim>::eliminate_pressure(
    const LinearAlgebra::Vector &lagged_phase_field)
  {
    LinearAlgebra::Vector residual = fields.owned_vector(fields.elastic_dofs);
    LinearAlgebra::Vector iterate(residual), step(residual);
    iterate          = state;
    double potential = 0., first_gain = 0.;
    for (unsigned int i = 0; i < most_steps; ++i)
    {
      const double present = evaluate(lagged_phase_field, residual);
      solve_with_mass(residual, step);
      const double gain = 0.5 * (residual * step);
      potential         = present + gain;
      if (i == 0)
        first_gain = gain;
      constraints.elastic_periodic().distribute(step);
      iterate.add(1., step);
      state = iterate;
      // '<' rather than '>=': what is no number ends here too
      if (!(gain > smallest_gain * std::max(std::abs(potential), first_gain)))
        break;
    }
    return potential;
  }



  // sum over cells of R^K . d^K, with R_p = 0
  template <int dim>
  double
  ElasticPotential<dim>::slope(const LinearAlgebra::Vector &direction,
                               const LinearAlgebra::Vector &lagged_phase_field)
  {
    double                 sum = 0.;
    dealii::Vector<double> residual(fields.elastic.get_fe().n_dofs_per_cell());
    dealii::Vector<double> local(residual.size());
    assembler.visit_states(
      state,
      lagged_phase_field,
      ElasticEvaluation::stresses,
      [&](const unsigned int cell, const ElasticKernel<dim> &kernel) {
        kernel.residual(residual);
        assembler.elastic_dofs().read(cell, direction, local);
        sum += residual * local;
      });
    return Utilities::MPI::sum(sum, fields.communicator());
  }



  template class ElasticPotential<2>;
  template class ElasticPotential<3>;
} // namespace MixedCracks
