// SPDX-License-Identifier: GPL-2.0-or-later
// What can be wrong with a case as a whole, known with mesh and parameters
// only: rigid motions that the supports leave free, which would make the matrix
// singular; and kappa = 0, with which broken cells have no stiffness: multigrid
// needs some in every cell, so that a direct solver has to do.

#include <base/errors.h>
#include <base/names.h>

#include <discretization/free_motions.h>

#include <simulation/case_checks.h>
#include <simulation/simulation_setup.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  void
  require_held_body(const Triangulation<dim> &triangulation,
                    const Constraints<dim>   &constraints)
  {
    const std::vector<std::string> motions =
      free_rigid_motions(triangulation,
                         constraints.prescribed_components(),
                         constraints.prescribed_points(),
                         constraints.periodic().sides());
    if (!motions.empty())
      throw InputError(
        "Boundary conditions/Displacement, with Displacement at points, leaves "
        "rigid motions free: " +
        join_names(motions, "; ") +
        ". Allowed are conditions that prevent all of them.");
  }



  template <int dim>
  void
  require_solver_for_stiffness(const Parameters<dim>     &parameters,
                               const MaterialDescription &material)
  {
    if (material.residual_stiffness == 0. &&
        (parameters.solver.name == "block AMG" ||
         parameters.solver.name == "matrix-free"))
      throw InputError("Linear solver/Name: found '" + parameters.solver.name +
                       "' with Model/Residual stiffness = " +
                       parameters.model.residual_stiffness +
                       ", which is 0: broken cells then have no stiffness, and "
                       "multigrid needs some. Allowed are direct, auto, or a "
                       "residual stiffness above 0.");
  }



  SolverParameters
  solver_for_stiffness(const SolverParameters    &given,
                       const MaterialDescription &material)
  {
    SolverParameters result = given;
    if (material.residual_stiffness == 0. && result.name == "auto")
      result.name = "direct";
    return result;
  }



  template <int dim>
  void
  try_expressions_at_start(const Body<dim> &body, const bool only_check)
  {
    try_loads_at_start(body.parameters,
                       body.fields,
                       body.constraints,
                       body.not_built.has_value());
    if (only_check && body.not_built)
      try_initial_phase_field(body.parameters, body.fields, body.cell_size);
    else if (only_check)
      initial_phase_field(body.parameters, body.fields, body.constraints);
  }



  std::string
  hint_at_no_stiffness(const MaterialDescription &material)
  {
    if (material.residual_stiffness > 0.)
      return "";
    return "; Model/Residual stiffness (kappa) is 0, so that broken cells have "
           "no stiffness and the matrix may be singular: try a small one";
  }



#define INSTANTIATE(dim)                                                   \
  template void require_held_body(const Triangulation<dim> &,              \
                                  const Constraints<dim> &);               \
  template void require_solver_for_stiffness(const Parameters<dim> &,      \
                                             const MaterialDescription &); \
  template void try_expressions_at_start(const Body<dim> &, bool);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
