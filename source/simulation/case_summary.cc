// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/version.h>

#include <simulation/case_summary.h>
#include <simulation/damage_warning.h>
#include <simulation/recording.h>
#include <simulation/simulation_setup.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    Summary
    case_summary(const Body<dim> &body)
    {
      const Parameters<dim> &parameters = body.parameters;
      Summary                summary;
      summary.version         = MIXED_CRACKS_VERSION;
      summary.revision        = MIXED_CRACKS_REVISION;
      summary.deal_ii_version = DEAL_II_PACKAGE_VERSION;
      summary.coupling        = parameters.coupling.kind;
      summary.pressure_law    = parameters.model.pressure_law;
      summary.formulation     = parameters.model.formulation;
      summary.kinematics      = dim == 2 ? parameters.model.kinematics : "3-d";
      summary.ranks = Utilities::MPI::n_mpi_processes(body.communicator());
      summary.cell_size =
        finest_cell_size(body.triangulation, body.communicator());
      summary.length_scale = body.length_scale();
      summary.residual_stiffness =
        body.material->description().residual_stiffness;
      summary.thickness = parameters.material.thickness;
      summary.dimension = dim;
      return summary;
    }
  } // namespace



  template <int dim>
  Summary
  summarize(const Body<dim>      &body,
            const Preflight<dim> &before_the_run,
            const Recorder<dim>  &recorder,
            const EndOfRun       &end)
  {
    Summary summary             = case_summary(body);
    summary.case_in_words       = before_the_run.case_in_words();
    summary.linear_solver       = end.linear_solver;
    summary.asked               = recorder.asked_quantities();
    summary.cracks              = end.cracks;
    summary.separated           = separates(end.cracks);
    summary.without_equilibrium = end.end == RunEnd::no_equilibrium;
    summary.force_fell  = recorder.last().force_size() < end.fallen_force;
    summary.exit_reason = end.outcome.reason;
    summary.exit_status = end.outcome.exit_status;
    summary.cost        = end.cost;
    summary.memory      = end.memory;
    summary.peak_memory = end.peak_memory;
    summary.warnings    = before_the_run.warnings();
    for (const std::string &warning :
         {recorder.slits().warning(),
          damage_warning(body, recorder.rows(), end.end),
          imbalance_in_words(recorder.rows(), imbalance_rule(body))})
      if (!warning.empty())
        summary.warnings.push_back(warning);
    return summary;
  }



#define INSTANTIATE(dim)                             \
  template Summary summarize(const Body<dim> &,      \
                             const Preflight<dim> &, \
                             const Recorder<dim> &,  \
                             const EndOfRun &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
