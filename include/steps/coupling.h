// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_steps_coupling_h
#define mixed_cracks_steps_coupling_h

#include <deal.II/base/parameter_handler.h>

#include <steps/fixed_point.h>

#include <string>

namespace MixedCracks
{
  /// Which phase field phi~ the degradation g(phi~) is evaluated with, (M9).
  struct CouplingOptions
  {
    enum class Kind
    {
      time_lagged,  ///< phi~ = phi of the last step
      extrapolated, ///< linear in time through the last two, clipped
      iterated      ///< alternate minimisation (staggered) until phi~ = phi
    };
    Kind   kind      = Kind::iterated;
    double tolerance = 1e-3; ///< of max|phi - phi~|
    /// the same in a step in which a crack has run and stands
    double            running_tolerance = 1e-3;
    FixedPointOptions acceleration;
    unsigned int      max_iterations = 2000;
  };

  /// What subsection "Model" says of how the phase field and the elastic
  /// fields meet in a load step.
  struct CouplingParameters
  {
    std::string kind              = "iterated";
    double      tolerance         = 1e-4;
    double      running_tolerance = 0.02;
    double      over_relaxation   = 1.5;
    double      acceleration      = 20.;
    int         anderson_depth    = 5;
    int         max_iterations    = 2000;

    /// Enters the subsection itself; ModelParameters declares the rest of it.
    void add_parameters(dealii::ParameterHandler &prm);

    CouplingOptions options() const;
  };
} // namespace MixedCracks

#endif
