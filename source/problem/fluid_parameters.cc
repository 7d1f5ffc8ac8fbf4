// SPDX-License-Identifier: GPL-2.0-or-later
// A given pressure p_f(x, t) (MPa) in the cracks (M10): its potential
//
//   E_f = - integral of  p_f u . grad(phi^2)  over the body
//
// pushes apart the crack faces, which the phase field smears out. A text that
// is the number 0 means no fluid at all, and no terms to assemble; an
// expression that happens to be 0 is a fluid.

#include <base/expression.h>

#include <deal.II/base/patterns.h>

#include <problem/boundary_conditions.h>
#include <problem/fluid_parameters.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  void
  FluidParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Fluid");
    prm.add_parameter(
      "Pressure",
      pressure_text,
      "Pressure p_f of a fluid in the cracks (M10), an expression in x, y, z, "
      "t, as '1e-3' or '0.5*t'; positive: it opens them. It does the work "
      "p_f u . grad(phi^2) per volume on the crack faces, and acts on no other "
      "boundary. 0: no fluid. Unit: MPa.",
      Patterns::Anything());
    prm.leave_subsection();
  }



  template <int dim>
  std::shared_ptr<Function<dim>>
  FluidParameters<dim>::pressure() const
  {
    const auto expression = std::make_shared<const Expression>(
      pressure_text,
      std::vector<std::string>{"x", "y", "z", "t"},
      "Fluid/Pressure");
    if (Patterns::Double(0., 0.).match(expression->text()))
      return nullptr;
    auto function = std::make_shared<ExpressionFunction<dim>>(1);
    function->set(0, expression);
    return function;
  }



  template <int dim>
  void
  FluidParameters<dim>::check() const
  {
    pressure();
  }



  template struct FluidParameters<2>;
  template struct FluidParameters<3>;
} // namespace MixedCracks
