// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/base/patterns.h>

#include <solvers/parameters.h>

namespace MixedCracks
{
  namespace Patterns = dealii::Patterns;

  void
  SolverParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Linear solver");
    prm.add_parameter("Name",
                      name,
                      "'direct': a sparse direct solver through Trilinos, the "
                      "best one that is there (MUMPS, distributed, before the "
                      "others); the log names it.",
                      Patterns::Selection("direct"));
    prm.add_parameter("Newton tolerance",
                      newton.tolerance,
                      "Newton's method for (u, p) ends when the residual is "
                      "below this times the terms that cancel in it. Unit: 1.",
                      Patterns::Double(1e-14, 1e-2));
    prm.add_parameter("Largest number of Newton iterations",
                      newton.max_iterations,
                      "A step that needs more has failed and is halved.",
                      Patterns::Integer(1));
    prm.leave_subsection();
  }
} // namespace MixedCracks
