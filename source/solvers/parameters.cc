// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>
#include <base/log.h>
#include <base/names.h>

#include <deal.II/base/patterns.h>

#include <solvers/mumps.h>
#include <solvers/parameters.h>

namespace MixedCracks
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    void
    add_linear_parameters(LinearSolverOptions      &linear,
                          NewtonOptions            &newton,
                          dealii::ParameterHandler &prm)
    {
      prm.add_parameter(
        "Ordering",
        linear.ordering,
        "Of the unknowns, for 'direct' with MUMPS: how many "
        "entries the factors have depends on it. 'automatic': AMD in "
        "2-d, METIS in 3-d, where MUMPS chooses if the program was built "
        "without METIS. A MUMPS built without the one asked for takes "
        "another; the log says which.",
        Patterns::Selection(join_names(Mumps::orderings(), "|")));
      prm.add_parameter(
        "Relative tolerance",
        newton.tight_linear_tolerance,
        "Iterative solvers never reduce the residual |b - A x| / "
        "|b| of a linear system by more than this. How much "
        "it does depends on the progress of Newton's method "
        "and on 'Newton tolerance'. Unit: 1.",
        Patterns::Double(1e-14, 0.1));
      prm.add_parameter(
        "Loose relative tolerance",
        newton.loose_linear_tolerance,
        "What iterative solvers start with, and the least accurate "
        "solution it is ever asked for. Unit: 1.",
        Patterns::Double(1e-14, 0.1));
      prm.add_parameter("Largest number of linear iterations",
                        linear.max_iterations,
                        "A linear system that needs more has not been solved, "
                        "and the step is halved. For iterative solvers.",
                        Patterns::Integer(1));
      prm.add_parameter(
        "Tolerated growth of iterations",
        linear.tolerated_growth,
        "Iterative solvers keep a multigrid hierarchy for a new "
        "matrix as long as they need at most 4 and this times "
        "the iterations that they needed for the same reduction "
        "of the residual when it was new. After one had to be "
        "given up, the next matrix has a new one, after a second "
        "time in a row the next three. 0: a new one for each "
        "matrix. Unit: 1.",
        Patterns::Double(0.));
    }
  } // namespace



  void
  SolverParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Linear solver");
    prm.add_parameter(
      "Name",
      name,
      all_linear_solvers().documentation() +
        " 'auto': one of them, by dimension and number of unknowns "
        "(doc/solvers.md); the log says which one and why.",
      Patterns::Selection(all_linear_solvers().selection() + "|auto"));
    add_linear_parameters(linear, newton, prm);
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



  void
  SolverParameters::check() const
  {
    if (newton.loose_linear_tolerance < newton.tight_linear_tolerance)
      throw InputError(
        format("Linear solver/Loose relative tolerance: found %g; allowed are "
               "values from 'Relative tolerance', %g, to 0.1.",
               newton.loose_linear_tolerance,
               newton.tight_linear_tolerance));
  }
} // namespace MixedCracks
