// SPDX-License-Identifier: GPL-2.0-or-later
// The phase field of a step for given D = 2 psi+: the third line of (M5),
//
//   find phi in K = { 0 <= phi <= phi^(n-1) } with, for all psi in K,
//   ( g'(phi)/2 D + G_c/l a'(phi), psi - phi )
//      + ( 2 b G_c l grad phi, grad(psi - phi) )  >=  0,
//
// the condition for a minimum of the energy over K. As nodal values of Q1, with
// r the residual of PhaseFieldKernel and m_i = integral of N_i,
//
//   0 < phi_i < phi^(n-1)_i    r_i = 0
//   phi_i = phi^(n-1)_i        r_i <= 0   (held: it would heal)
//   phi_i = 0                  r_i >= 0
//
// to |r_i|/m_i <= 1e-8 G_c/l. Q1 values between the nodes are within the bounds
// if those at the nodes are, hanging nodes included, as their weights are
// positive.
//
// Where g and a are quadratic, r is linear in phi and one active set is the
// end; else Newton's method: linearised at phi_k, solved between the same
// bounds, until an active set stays as it was. With a fluid, (M10) is added to
// r and its matrix.

#include <discretization/sparse_matrix.h>

#include <steps/step_phase_field.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // outer Newton iterations for densities that are not quadratic
    constexpr unsigned int max_newton_iterations = 20;

    // of the phase field's residual over G_c / l and the lumped mass
    constexpr double residual_tolerance = 1e-8;



    // G_c / l (MPa), the scale of G_c gamma, of which the multipliers r_i/m_i
    // are parts. Where G_c varies, r_i is divided by the integral of G_c N_i:
    // then 1 / l.
    template <int dim>
    double
    energy_density(const Material<dim> &material, const bool constants_vary)
    {
      return (constants_vary
                ? 1.
                : material.uniform_constants().critical_energy_release_rate) /
             material.description().length_scale;
    }



    ActiveSetOptions
    options_for(const double energy_density)
    {
      ActiveSetOptions options;
      options.tolerance = residual_tolerance * energy_density;
      return options;
    }
  } // namespace



  template <int dim>
  PhaseFieldStep<dim>::PhaseFieldStep(
    const Fields<dim>                   &fields,
    const Constraints<dim>              &constraints,
    const Material<dim>                 &material,
    Assembler<dim>                      &assembler,
    std::shared_ptr<FluidAssembler<dim>> fluid,
    PhaseTimer                          &timer,
    StopCheck                            stop)
    : fields(fields)
    , constraints(constraints)
    , assembler(assembler)
    , fluid(std::move(fluid))
    , timer(timer)
    , stop(std::move(stop))
    , solver(options_for(energy_density(material, assembler.constants_vary())))
    , is_linear(material.phase_field_is_linear())
    , concavity(energy_density(material, assembler.constants_vary()) *
                material.crack_density().concavity())
  {}



  template <int dim>
  void
  PhaseFieldStep<dim>::reinit()
  {
    PhaseTimer::Scope scope(timer, "setup");
    const DofSets    &dofs    = fields.phase_field_dofs;
    const auto       &hanging = constraints.phase_field_hanging_nodes();
    make_sparse_matrix(fields.phase_field, dofs, hanging, matrix);
    for (LinearAlgebra::Vector *vector :
         {&iterate, &residual, &lower, &upper, &mass})
      vector->reinit(dofs.owned, fields.communicator());
    if (assembler.constants_vary())
      assembler.lumped_release_rate(hanging, mass);
    else
      assembler.lumped_mass(hanging, mass);
    solver.reinit();
    constrained.clear();
    for (const auto dof : dofs.owned)
      constrained.push_back(hanging.is_constrained(dof));
  }



  template <int dim>
  void
  PhaseFieldStep<dim>::set_bounds(const LinearAlgebra::Vector &obstacle,
                                  const FixedPhaseField       &fixed)
  {
    lower = 0.;
    upper = obstacle;
    for (const auto dof : fixed.frozen)
      lower(dof) = upper(dof);
    for (const auto &[dof, value] : fixed.prescribed)
      lower(dof) = upper(dof) = value;
    // setting element by element left them in insert mode
    lower.compress(VectorOperation::insert);
    upper.compress(VectorOperation::insert);
  }



  template <int dim>
  void
  PhaseFieldStep<dim>::assemble(const State        &trial,
                                const DrivingForce &driving_force)
  {
    const auto &hanging = constraints.phase_field_hanging_nodes();
    assembler.phase_field_system(
      trial.phase_field, driving_force, hanging, residual, &matrix);
    if (fluid)
      fluid->add_phase_field_system(trial.time,
                                    trial.elastic,
                                    trial.phase_field,
                                    hanging,
                                    residual,
                                    &matrix);
  }



  template <int dim>
  ActiveSetOutcome
  PhaseFieldStep<dim>::solve(const LinearAlgebra::Vector &obstacle,
                             const FixedPhaseField       &fixed,
                             const DrivingForce          &driving_force,
                             State                       &trial)
  {
    PhaseTimer::Scope scope(timer, "phase field");
    set_bounds(obstacle, fixed);
    iterate                      = trial.phase_field;
    const auto          &hanging = constraints.phase_field_hanging_nodes();
    const BoundedProblem problem{
      matrix, lower, upper, mass, constrained, concavity, stop};
    ActiveSetOutcome total;
    for (unsigned int i = 0; i < max_newton_iterations; ++i)
    {
      assemble(trial, driving_force);
      if (is_to_stop(stop, "assembly of the phase field"))
        break;
      const ActiveSetOutcome outcome = solver.solve(problem, iterate, residual);
      hanging.distribute(iterate);
      trial.phase_field = iterate;

      const unsigned int earlier_iterations = total.iterations;
      const unsigned int earlier_linear     = total.linear_iterations;
      const auto         earlier_changes    = total.n_changes;
      total                                 = outcome;
      total.iterations += earlier_iterations;
      total.linear_iterations += earlier_linear;
      total.n_changes += earlier_changes;
      // an active set that stays as it was found has nothing left to solve
      if (!outcome.converged || is_linear ||
          (i > 0 && outcome.n_changes == 0 && outcome.iterations <= 1))
        return total;
    }
    total.converged = false;
    total.reason    = "no convergence of the phase field within " +
                   std::to_string(max_newton_iterations) + " Newton iterations";
    return total;
  }



  template class PhaseFieldStep<2>;
  template class PhaseFieldStep<3>;
} // namespace MixedCracks
