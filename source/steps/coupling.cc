// SPDX-License-Identifier: GPL-2.0-or-later
// Which phase field phi~ the degradation g(phi~) of step n is evaluated with,
// (M9):
//
//   time-lagged   phi~ = phi^(n-1)                               [Mang21]
//   extrapolated  phi~ = phi^(n-2) + (1 + dt_n/dt_(n-1))
//                        (phi^(n-1) - phi^(n-2)),
//                 clipped to 0 <= phi~ <= phi^(n-1)              [HWW15]
//   iterated      alternate minimisation (staggered): repeated with phi~ moved
//                 towards phi until max |phi - phi~| <= tolerance
//
// The first two solve once per step: cheap, with an error that acts like a
// viscosity, as a crack advances by one cell per step however long that is. The
// third finds a state where u is in equilibrium with phi itself: a critical
// point of the energy at that load.

#include <deal.II/base/patterns.h>

#include <steps/coupling.h>

#include <algorithm>
#include <limits>

namespace MixedCracks
{
  namespace Patterns = dealii::Patterns;

  void
  CouplingParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    const double tiny = std::numeric_limits<double>::min();
    prm.enter_subsection("Model");
    prm.add_parameter(
      "Coupling",
      kind,
      "The phase field in the degradation (M9): 'time-lagged': that of the "
      "last step; 'extrapolated': linearly in time, within its bounds; "
      "'iterated': repeated until it no longer changes, which is alternate "
      "minimisation (staggered).",
      Patterns::Selection("time-lagged|extrapolated|iterated"));
    prm.add_parameter("Coupling tolerance",
                      tolerance,
                      "The iterated coupling ends when max|phi - phi~| is "
                      "below this. Unit: 1.",
                      Patterns::Double(tiny, 1.));
    prm.add_parameter(
      "Running crack tolerance",
      running_tolerance,
      "What takes the place of the coupling tolerance in a load step in which "
      "a crack has run, phi having fallen by more than 0.9 somewhere, and "
      "stands: over five iterations, max W - min W <= 5e-5 times the plain "
      "iterations these are worth times W, W being the loads times their "
      "displacements. What is left to change is done by the next step. If it "
      "is the larger of the two, a step also ends as soon as the body is "
      "apart and the run ends with that, see Load stepping. Unit: 1.",
      Patterns::Double(tiny, 1.));
    prm.add_parameter(
      "Over-relaxation",
      over_relaxation,
      "The iterated coupling moves phi~ by this factor times (phi - phi~), "
      "within the bounds; 1: off. Unit: 1.",
      Patterns::Double(tiny, 2.));
    prm.add_parameter(
      "Largest acceleration",
      acceleration,
      "The iterated coupling never moves phi~ by more than this factor times "
      "|phi - phi~|, and by a quarter of it where phi - phi~ grows in one and "
      "the same direction, at the onset of a crack; 1: off. Unit: 1.",
      Patterns::Double(1., 100.));
    prm.add_parameter(
      "Anderson depth",
      anderson_depth,
      "Number of earlier iterations that Anderson's method uses to speed up "
      "the iterated coupling where it converges smoothly; 0: off. Unit: 1.",
      Patterns::Integer(0, 20));
    prm.add_parameter("Largest number of coupling iterations",
                      max_iterations,
                      "A step of the iterated coupling that needs more has "
                      "failed. A running crack advances about one cell per "
                      "iteration.",
                      Patterns::Integer(1));
    prm.leave_subsection();
  }



  CouplingOptions
  CouplingParameters::options() const
  {
    CouplingOptions options;
    options.kind = kind == "time-lagged" ? CouplingOptions::Kind::time_lagged
                   : kind == "extrapolated"
                     ? CouplingOptions::Kind::extrapolated
                     : CouplingOptions::Kind::iterated;
    options.tolerance         = tolerance;
    options.running_tolerance = std::max(running_tolerance, tolerance);
    options.acceleration.over_relaxation      = over_relaxation;
    options.acceleration.largest_acceleration = acceleration;
    options.acceleration.depth                = anderson_depth;
    options.max_iterations                    = max_iterations;
    return options;
  }
} // namespace MixedCracks
