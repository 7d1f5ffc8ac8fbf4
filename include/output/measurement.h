// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_measurement_h
#define mixed_cracks_output_measurement_h

#include <assembly/assembler.h>

#include <discretization/fields.h>
#include <discretization/state.h>

#include <output/run_totals.h>

namespace MixedCracks
{
  /// What the solvers say of a load step.
  struct StepEffort
  {
    double        phase_field_change  = 0.; ///< max(phi^(n-1) - phi^n)
    double        coupling_change     = 0.; ///< last max|phi - phi~|
    unsigned int  newton_iterations   = 0;
    unsigned int  linear_iterations   = 0;
    unsigned int  coupling_iterations = 0;
    unsigned long active_set_size     = 0;
  };

  /// What quantities are evaluated from: a load step that is to be accepted.
  /// Everything is the same on all ranks; evaluating is collective.
  template <int dim>
  struct Measurement
  {
    const Fields<dim> &fields;
    const State       &state;
    /// what integrals over the mesh are multiplied with to get those over the
    /// body: mm in 2-d, 1 in 3-d
    double                 thickness    = 1.;
    unsigned int           step         = 0;
    double                 displacement = 0.;  ///< mm, see BoundaryQuantities
    dealii::Tensor<1, dim> force{};            ///< N, with thickness
    Energies               energies{};         ///< without thickness
    double                 external_work = 0.; ///< since the start, mJ
    StepEffort             effort{};
    RunTotals              totals{}; ///< of all pieces of the run so far
    unsigned int           n_refinements = 0;
    /// of a body with periodic sides, MPa
    dealii::Tensor<2, dim> mean_stress{};
  };
} // namespace MixedCracks

#endif
