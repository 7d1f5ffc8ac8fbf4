// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_steps_step_phase_field_h
#define mixed_cracks_steps_step_phase_field_h

#include <assembly/assembler.h>
#include <assembly/fluid_assembler.h>

#include <base/phase_timer.h>

#include <discretization/constraints.h>
#include <discretization/state.h>

#include <solvers/active_set.h>

namespace MixedCracks
{
  /// Nodes of the phase field that cannot move freely, besides its bounds.
  struct FixedPhaseField
  {
    /// owned nodes that keep the value they have (unbreakable material)
    dealii::IndexSet frozen;
    /// owned nodes with a given value, at the present time
    std::map<dealii::types::global_dof_index, double> prescribed;
  };

  /// The phase field for given displacement and pressure, between 0 and that
  /// of the last step: a variational inequality, solved by an active set.
  template <int dim>
  class PhaseFieldStep
  {
  public:
    /// @p fluid: in the cracks, kept in step with the mesh by ElasticStep;
    /// or null.
    PhaseFieldStep(const Fields<dim>                   &fields,
                   const Constraints<dim>              &constraints,
                   const Material<dim>                 &material,
                   Assembler<dim>                      &assembler,
                   std::shared_ptr<FluidAssembler<dim>> fluid,
                   PhaseTimer                          &timer,
                   StopCheck                            stop = {});

    /// To be called when the mesh changed.
    void reinit();

    /// Solve for trial.phase_field between 0 and @p obstacle; @p driving_force:
    /// 2 psi+ of the elastic fields of @p trial.
    ActiveSetOutcome solve(const LinearAlgebra::Vector &obstacle,
                           const FixedPhaseField       &fixed,
                           const DrivingForce          &driving_force,
                           State                       &trial);

  private:
    void set_bounds(const LinearAlgebra::Vector &obstacle,
                    const FixedPhaseField       &fixed);

    /// Residual and matrix at the trial state.
    void assemble(const State &trial, const DrivingForce &driving_force);

    const Fields<dim>                         &fields;
    const Constraints<dim>                    &constraints;
    Assembler<dim>                            &assembler;
    const std::shared_ptr<FluidAssembler<dim>> fluid;
    PhaseTimer                                &timer;
    const StopCheck                            stop;
    ActiveSetSolver                            solver;
    /// the matrix does not depend on the phase field, so that one active-set
    /// solution is the end
    const bool is_linear;
    /// of the crack density, MPa or 1/mm as the multipliers
    const double concavity;

    LinearAlgebra::SparseMatrix matrix;
    std::vector<bool>           constrained;
    LinearAlgebra::Vector       iterate;
    LinearAlgebra::Vector       residual;
    LinearAlgebra::Vector       lower;
    LinearAlgebra::Vector       upper;
    LinearAlgebra::Vector       mass; // lumped; times G_c where that varies
  };
} // namespace MixedCracks

#endif
