// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/finite_text.h>
#include <base/version.h>

#include <simulation/simulation.h>
#include <simulation/simulation_plausibility.h>

#include <cmath>
#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // bytes that whole runs were seen to need, factors or hierarchy of the
    // (u, p) matrix included (doc/performance.md); in 3-d the number of
    // entries of factors grows with the power 4/3 of that of the dofs
    template <int dim>
    double
    bytes_of_solution(const std::string &solver, const double n_dofs)
    {
      if (solver == "block AMG")
        return (dim == 2 ? 2500. : 9000.) * n_dofs;
      return dim == 2 ? 3500. * n_dofs : 450. * std::pow(n_dofs, 4. / 3.);
    }

    std::string
    locking_in_words(const MaterialRange &given, const bool mixed)
    {
      std::string text =
        given.ratio.varies()
          ? printed("lambda/mu = %.4g to %.4g, nu = %.5f to %.5f",
                    printable(given.ratio.smallest),
                    printable(given.ratio.largest),
                    given.nu.smallest,
                    given.nu.largest)
          : printed("lambda/mu = %.4g, nu = %.5f",
                    printable(given.ratio.largest),
                    given.nu.largest);
      if (given.ratio.largest < 50.)
        return text + ": compressible enough for either formulation";
      return text + (mixed ? ": nearly incompressible, handled by the mixed "
                             "formulation"
                           : ": nearly incompressible; the displacement "
                             "formulation locks");
    }
  } // namespace



  template <int dim>
  double
  Simulation<dim>::cell_size_at_cracks() const
  {
    const MeshEstimate mesh    = mesh_counts();
    const int          present = mesh.finest_level;
    const int          finest  = parameters.mesh.adaptation == "none"
                                   ? present
                                   : parameters.mesh.finest_adaptive_level();
    return mesh.finest_size * std::pow(0.5, std::max(0, finest - present));
  }



  template <int dim>
  void
  Simulation<dim>::log_header()
  {
    const ModelParameters     &model     = parameters.model;
    const MaterialDescription &constants = material->description();
    case_in_words =
      parameters.geometry.name_of_chosen() + ", " + model.formulation + ", " +
      (dim == 2 ? model.kinematics : "3-d") + ", " + model.crack_density +
      ", split " + model.energy_split + ", " + model.pressure_law +
      ", coupling " + parameters.coupling.kind;
    log.line(std::string("mixed-cracks ") + MIXED_CRACKS_VERSION +
             ", revision " + MIXED_CRACKS_REVISION + ", deal.II " +
             DEAL_II_PACKAGE_VERSION);
    log.line("case: " + case_in_words);
    const MeshEstimate mesh = mesh_counts();
    // a count that is not exact has three digits
    const char *const format =
      mesh.is_exact
        ? "ranks: %u; cells: %.0f; dofs: %.0f (u, p: %.0f; phi: %.0f)"
        : "ranks: %u; cells: about %.3g; dofs: about %.3g (u, p: %.3g; phi: "
          "%.3g)";
    log.line(printed(format,
                     Utilities::MPI::n_mpi_processes(communicator),
                     mesh.n_cells,
                     mesh.n_elastic + mesh.n_phase_field,
                     mesh.n_elastic,
                     mesh.n_phase_field));
    log.line(printed("finest cells h = %.4g mm; length scale l = %.4g mm, "
                     "l/h = %.3g; kappa = %.3g",
                     cell_size_at_cracks(),
                     constants.length_scale,
                     printable(constants.length_scale / cell_size_at_cracks()),
                     constants.residual_stiffness));
    log.line("load steps: " + parameters.load.steps().in_words());
    if (material_field->varies())
      log.line(in_words(material_range));
    log.line(locking_in_words(material_range, model.mixed()));
    const std::string solver =
      choose_linear_solver(solver_parameters().name,
                           dim,
                           static_cast<types::global_dof_index>(mesh.n_elastic))
        .name;
    log.line(printed("memory: about %.2g GB with the linear solver '%s', all "
                     "ranks together",
                     1e-9 * bytes_of_solution<dim>(
                              solver, mesh.n_elastic + mesh.n_phase_field),
                     solver.c_str()));
    log.line(printed("checkpoint: about %.3g MB on this mesh and 0.3 kB for "
                     "each load step; twice that on the disk, as the one "
                     "before is kept",
                     1e-6 * static_cast<double>(checkpoint_size(
                              fields,
                              static_cast<std::uint64_t>(mesh.n_cells),
                              triangulation.n_cells(0)))));
  }



  template <int dim>
  void
  Simulation<dim>::collect_warnings()
  {
    const MaterialDescription &constants = material->description();
    const double resolution = constants.length_scale / cell_size_at_cracks();
    if (resolution < 2. * (1. - 1e-6))
      warnings.push_back(printed(
        "l/h = %.3g: the length scale is resolved by fewer than two cells; "
        "the effective toughness is too large",
        resolution));
    const double stiffest_ratio = material_range.ratio.largest;
    if (!parameters.model.mixed() && stiffest_ratio > 50.)
      warnings.push_back(
        printed("lambda/mu = %.3g with the displacement formulation: expect "
                "locking; Model/Formulation = mixed avoids it",
                printable(stiffest_ratio)));
    if (parameters.coupling.kind != "iterated")
      warnings.push_back(
        "coupling '" + parameters.coupling.kind +
        "': a running crack advances about one cell per load step, which acts "
        "as a rate effect");
    const std::string kinematics =
      dim == 2 ? parameters.model.kinematics : "3-d";
    if (parameters.model.mixed() && kinematics != "plane stress" &&
        parameters.model.pressure_law != "relaxed bulk" && stiffest_ratio > 50.)
      warnings.push_back("pressure law '" + parameters.model.pressure_law +
                         "' in a nearly incompressible solid (" + kinematics +
                         "): cracks hardly open, see doc/model.md, section 3");
    const std::string too_many_steps = parameters.load.warning();
    if (!too_many_steps.empty())
      warnings.push_back(too_many_steps);
    if (resumed)
      warnings.insert(warnings.end(),
                      resumed->changed_loads.begin(),
                      resumed->changed_loads.end());
    const CaseScales scales = case_scales(parameters,
                                          coarse_extent(triangulation),
                                          material_range,
                                          constants.length_scale,
                                          cell_size_at_cracks());
    log.line(in_words(scales.strength));
    const std::string remark = remark_about(scales);
    if (!remark.empty())
      log.line(remark);
    for (const std::string &warning : warnings_about(scales))
      warnings.push_back(warning);
    for (const std::string &warning : warnings)
      log.line("warning: " + warning);
  }



  template <int dim>
  void
  Simulation<dim>::preflight(const bool only_check)
  {
    make_mesh_and_material(only_check);
    // a run that is resumed has had its start
    if (!resumed)
      try_loads_at_start(parameters, fields, constraints);
    // the run comes to it by itself, on the mesh that it starts with
    if (only_check && not_built)
      try_initial_phase_field(parameters, fields, cell_size);
    else if (only_check)
      initial_phase_field(parameters, fields, constraints);
    log_header();
    log_slits();
    collect_warnings();
    if (only_check)
      log_not_checked();
  }



  template <int dim>
  void
  Simulation<dim>::log_step(const StatisticsRow &row)
  {
    log.line(printed("  t = %.6g s, u = %.6g mm, F = %.6g N, E_el = %.5g, "
                     "E_crack = %.5g, W = %.5g mJ, max dphi = %.3g, cells "
                     "%lu, %.1f s",
                     row.time,
                     row.displacement,
                     row.force_size(),
                     row.elastic_energy,
                     row.crack_energy,
                     row.external_work,
                     row.phase_field_change,
                     row.cells,
                     row.wall_time));
    const double fraction = row.time / parameters.load.end_time;
    if (fraction > 0.)
      log.progress(printed("%3.0f %% of the load, about %.0f s to the end time",
                           100. * fraction,
                           row.wall_time * (1. - fraction) / fraction));
  }



  // The least energy: next to nothing of what a crack as long as l costs.
  template <int dim>
  ImbalanceRule
  Simulation<dim>::imbalance_rule() const
  {
    constexpr double next_to_nothing = 1e-10;
    const double     length          = material->description().length_scale;
    return {parameters.output.energy_imbalance_tolerance,
            parameters.change_where_a_crack_ran(),
            next_to_nothing * material_range.toughness.smallest *
              std::pow(length, dim - 1) * parameters.thickness_factor()};
  }



  template <int dim>
  void
  Simulation<dim>::check_energy_balance()
  {
    const std::vector<StatisticsRow> &rows = statistics.rows();
    if (rows.size() < 2)
      return;
    const ImbalanceRule  rule = imbalance_rule();
    const StatisticsRow &row  = rows.back();
    const StepImbalance  step = imbalance(rows[rows.size() - 2], row);
    if (!rule.is_broken_by(step))
      return;
    const std::string reason =
      parameters.coupling.kind != "iterated"
        ? "the lagged phase field acts as a rate effect"
      : is_set_free(step, row, rule)
        ? "set free by a crack that ran"
        : "the step is too long, or the pressure law has no energy";
    log.line(printed("  energy balance: %.4g mJ of this step, %.1f %% of the "
                     "%s, are neither stored nor in the crack: %s",
                     step.energy,
                     100. * step.energy / step.scale,
                     step.is_of_stored_energy ? "stored energy"
                                              : "external work so far",
                     reason.c_str()));
  }



  template <int dim>
  void
  Simulation<dim>::log_linear_solver()
  {
    const std::string text = elastic_step->linear_solver_in_words();
    if (text != linear_solver_in_words)
      log.line("linear solver: " + text);
    linear_solver_in_words = text;
  }



  template <int dim>
  void
  Simulation<dim>::log_end(const RunOutcome &outcome, const Summary &summary)
  {
    const StatisticsRow &peak =
      statistics
        .rows()[peak_row(statistics.rows(), summary.without_equilibrium)];
    const StatisticsRow &last = statistics.rows().back();
    log.line("");
    log.line("end: " + outcome.reason);
    log.line("crack: " + path_in_words(summary.cracks) +
             ", start: " + summary.cracks.start);
    log.line(printed("peak force %.6g N at %.6g mm; at the end %.3g N (%.1f %% "
                     "of the peak) at %.6g mm",
                     peak.force_size(),
                     peak.displacement,
                     last.force_size(),
                     peak.force_size() > 0.
                       ? 100. * last.force_size() / peak.force_size()
                       : 0.,
                     last.displacement));
    ImbalanceRule     rule        = imbalance_rule();
    const std::string balance     = imbalance_in_words(statistics.rows(), rule);
    rule.change_where_a_crack_ran = std::numeric_limits<double>::infinity();
    const std::string with_cracks = imbalance_in_words(statistics.rows(), rule);
    if (!balance.empty())
      log.line("warning: " + balance);
    else if (!with_cracks.empty())
      log.line(with_cracks + "; all of it set free by cracks that ran");
    log.line(printed("steps %u, rejected %u, factorisations %u, solves %u, "
                     "%.1f s",
                     last.step,
                     summary.rejected_steps,
                     summary.factorizations,
                     summary.solves,
                     summary.wall_time));
    std::string text = "seconds:";
    for (const auto &[name, seconds] : summary.phases)
      text += printed(" %s %.2f;", name.c_str(), seconds);
    log.line(text);
  }



#define INSTANTIATE(dim)                                                   \
  template double        Simulation<dim>::cell_size_at_cracks() const;     \
  template void          Simulation<dim>::log_header();                    \
  template void          Simulation<dim>::collect_warnings();              \
  template void          Simulation<dim>::preflight(bool);                 \
  template void          Simulation<dim>::log_step(const StatisticsRow &); \
  template ImbalanceRule Simulation<dim>::imbalance_rule() const;          \
  template void          Simulation<dim>::check_energy_balance();          \
  template void          Simulation<dim>::log_linear_solver();             \
  template void Simulation<dim>::log_end(const RunOutcome &, const Summary &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
