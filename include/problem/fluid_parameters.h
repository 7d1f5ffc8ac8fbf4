// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_fluid_parameters_h
#define mixed_cracks_problem_fluid_parameters_h

#include <deal.II/base/function.h>
#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>

namespace MixedCracks
{
  /// Subsection "Fluid": a given pressure in the cracks.
  template <int dim>
  struct FluidParameters
  {
    std::string pressure_text = "0";

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError for an expression that cannot be read.
    void check() const;

    /// p_f in x, y, z, t; MPa. Null where there is no fluid: where the text
    /// is the number 0.
    std::shared_ptr<dealii::Function<dim>> pressure() const;
  };
} // namespace MixedCracks

#endif
