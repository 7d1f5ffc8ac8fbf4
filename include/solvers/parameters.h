// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_parameters_h
#define mixed_cracks_solvers_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <solvers/newton.h>

#include <string>

namespace MixedCracks
{
  /// Subsection "Linear solver" with the tolerances of Newton's method.
  struct SolverParameters
  {
    std::string         name = "direct";
    LinearSolverOptions linear;
    NewtonOptions       newton;

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError for tolerances that contradict each other.
    void check() const;
  };
} // namespace MixedCracks

#endif
