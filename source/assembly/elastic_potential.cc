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
// Anal. 7 (1987)]), and conjugate gradients take some twenty iterations.
//
// Newton's direction for R(u, p) = 0 descends on Pi where A + B^T M^-1 B is
// positive definite: with p the present pressure and p_u the eliminated one,
// A d_u + B^T d_p = -R_u(u, p) and B d_u - M d_p = -R_p give
//
//   (A + B^T M^-1 B) d_u = - dPi/du,     as R_p = M (p_u - p).

#include <assembly/elastic_potential.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace MixedCracks
{
  using namespace dealii;
  using Vector = LinearAlgebra::Vector;

  namespace
  {
    // of Newton's method for p; relative to the potential
    constexpr unsigned int most_steps    = 8;
    constexpr double       smallest_gain = 1e-12;

    // of the conjugate gradients, whose error enters the potential squared
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



  // L(u, p), and dL/dp in the rows of the pressure
  template <int dim>
  double
  ElasticPotential<dim>::evaluate(const Vector &lagged_phase_field,
                                  Vector       &residual)
  {
    double                 sum   = 0.;
    CellDofs<dim>         &cells = assembler.elastic_dofs();
    dealii::Vector<double> local(fields.elastic.get_fe().n_dofs_per_cell());
    std::vector<bool>      is_pressure;
    for (unsigned int i = 0; i < local.size(); ++i)
      is_pressure.push_back(
        fields.elastic.get_fe().system_to_component_index(i).first == dim);
    compliances.clear();
    cells.begin_sum(residual);
    assembler.visit_states(
      state,
      lagged_phase_field,
      ElasticEvaluation::tangents,
      [&](const unsigned int cell, const ElasticKernel<dim> &kernel) {
        sum += kernel.potential();
        kernel.append_compliances(compliances);
        kernel.residual(local);
        for (unsigned int i = 0; i < local.size(); ++i)
          if (!is_pressure[i])
            local(i) = 0.;
        cells.add(cell, local, constraints.elastic_hanging_nodes(), residual);
      });
    cells.end_sum(residual);
    return Utilities::MPI::sum(sum, fields.communicator());
  }



  template <int dim>
  void
  ElasticPotential<dim>::times_mass(const Vector &source, Vector &result)
  {
    const AffineConstraints<double> &hanging =
      constraints.elastic_hanging_nodes();
    CellDofs<dim> &cells = assembler.elastic_dofs();
    Vector         fitting(source);
    hanging.distribute(fitting);
    Vector ghosted = fields.ghosted_vector(fields.elastic_dofs);
    ghosted        = fitting;
    dealii::Vector<double> local(fields.elastic.get_fe().n_dofs_per_cell());
    dealii::Vector<double> image(local.size());
    const unsigned int     n_points = fields.quadrature.size();
    cells.begin_sum(result);
    for (unsigned int cell = 0; cell * n_points < compliances.size(); ++cell)
    {
      cells.read(cell, ghosted, local);
      assembler.kernel().pressure_mass(
        &compliances[std::size_t(cell) * n_points], local, image);
      cells.add(cell, image, hanging, result);
    }
    cells.end_sum(result);
  }



  // Without what hanging nodes add beside the diagonal: it only preconditions.
  template <int dim>
  void
  ElasticPotential<dim>::set_up_diagonal()
  {
    CellDofs<dim> &cells = assembler.elastic_dofs();
    inverse_diagonal     = fields.owned_vector(fields.elastic_dofs);
    dealii::Vector<double> local(fields.elastic.get_fe().n_dofs_per_cell());
    const unsigned int     n_points = fields.quadrature.size();
    cells.begin_sum(inverse_diagonal);
    for (unsigned int cell = 0; cell * n_points < compliances.size(); ++cell)
    {
      assembler.kernel().pressure_mass_diagonal(
        &compliances[std::size_t(cell) * n_points], local);
      cells.add(
        cell, local, constraints.elastic_hanging_nodes(), inverse_diagonal);
    }
    cells.end_sum(inverse_diagonal);
    // rows of displacements and of hanging nodes are 0 in all vectors
    for (double &value : inverse_diagonal)
      value = value == 0. ? 1. : 1. / value;
  }



  // Preconditioned conjugate gradients from 0; z = D^-1 r, search the
  // direction. Written out, since no convergence is no error here: the
  // potential is then a little too small.
  template <int dim>
  void
  ElasticPotential<dim>::solve_with_mass(const Vector &right_hand_side,
                                         Vector       &solution)
  {
    set_up_diagonal();
    solution = 0.;
    Vector       r(right_hand_side), z(r), image(r);
    const double size = r.l2_norm();
    Vector       search(r);
    search        = 0.;
    double before = 1.;
    for (unsigned int i = 0; i < most_iterations; ++i)
    {
      if (!(r.l2_norm() > linear_tolerance * size))
        return;
      z = r;
      z.scale(inverse_diagonal);
      const double now = r * z;
      search.sadd(i == 0 ? 0. : now / before, 1., z);
      before = now;
      times_mass(search, image);
      const double curvature = search * image;
      if (!(curvature > 0.))
        return;
      solution.add(now / curvature, search);
      r.add(-now / curvature, image);
    }
  }



  template <int dim>
  double
  ElasticPotential<dim>::value(const Vector &elastic,
                               const Vector &lagged_phase_field)
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
  ElasticPotential<dim>::present_value(const Vector &lagged_phase_field)
  {
    double sum = 0.;
    assembler.visit_states(state,
                           lagged_phase_field,
                           ElasticEvaluation::points,
                           [&](unsigned int, const ElasticKernel<dim> &kernel) {
                             sum += kernel.potential();
                           });
    return Utilities::MPI::sum(sum, fields.communicator());
  }



  // From the pressure in `state` to the one where L is largest.
  template <int dim>
  double
  ElasticPotential<dim>::eliminate_pressure(const Vector &lagged_phase_field)
  {
    Vector residual = fields.owned_vector(fields.elastic_dofs);
    Vector iterate(residual), step(residual);
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
      constraints.elastic_hanging_nodes().distribute(step);
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
  ElasticPotential<dim>::slope(const Vector &direction,
                               const Vector &lagged_phase_field)
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
