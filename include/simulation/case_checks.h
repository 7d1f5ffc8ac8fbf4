// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_case_checks_h
#define mixed_cracks_simulation_case_checks_h

#include <simulation/body.h>

namespace MixedCracks
{
  // What is refused of a case before its first step, and what kappa = 0 means
  // for solvers.

  /// Throws InputError when the prescribed displacements leave the body free
  /// to move.
  template <int dim>
  void require_held_body(const dealii::Triangulation<dim> &triangulation,
                         const Constraints<dim>           &constraints);

  /// Throws InputError when the linear solver cannot do with kappa = 0.
  template <int dim>
  void require_solver_for_stiffness(const Parameters<dim>     &parameters,
                                    const MaterialDescription &material);

  /// As given, but for what kappa = 0 does to the automatic choice.
  SolverParameters solver_for_stiffness(const SolverParameters    &given,
                                        const MaterialDescription &material);

  /// Evaluate what is given by expressions at t = 0, on the first mesh: loads,
  /// prescribed values, and with @p only_check the initial phase field, to
  /// which a run comes by itself. Throws InputError on all ranks for values
  /// that are not allowed. Collective.
  template <int dim>
  void try_expressions_at_start(const Body<dim> &body, bool only_check);

  /// What to think of when a step failed with kappa = 0; else nothing.
  std::string hint_at_no_stiffness(const MaterialDescription &material);
} // namespace MixedCracks

#endif
