// SPDX-License-Identifier: GPL-2.0-or-later
// What --check says, and the log before each run: sizes, costs, and warnings of
// what the numbers cannot mean. Memory of whole runs (N dofs, bytes):
//
//              direct             block AMG     matrix-free
//    2-d       3500 N             2500 N        1800 N
//    3-d       450 N^(4/3)        9000 N        1800 N
// Warnings about the model:
//   l/h < 2         the band is not resolved: a crack of the discrete problem
//                   costs more than G_c per surface
//   lambda/mu > 50  displacement formulation: locking. Mixed: pressure laws but
//                   'relaxed bulk' keep a volume constraint in broken material,
//                   and cracks hardly open (doc/model.md, section 3)
//   not iterated    a running crack advances by about a cell per load step

#include <base/finite_text.h>
#include <base/names.h>
#include <base/version.h>

#include <discretization/mesh_quality.h>
#include <output/in_brackets.h>

#include <simulation/case_checks.h>
#include <simulation/preflight.h>

#include <solvers/linear_solver.h>

#include <cmath>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // lambda/mu from which the displacement formulation locks
    constexpr double nearly_incompressible = 50.;



    // bytes of whole runs, see above (doc/performance.md); in 3-d the entries
    // of factors grow with the power 4/3 of the dofs
    template <int dim>
    double
    bytes_of_solution(const std::string &solver, const double n_dofs)
    {
      if (solver != "direct")
        return (solver == "matrix-free" ? 1800.
                : dim == 2              ? 2500.
                                        : 9000.) *
               n_dofs;
      return dim == 2 ? 3500. * n_dofs : 450. * std::pow(n_dofs, 4. / 3.);
    }



    // In plane stress the thickness gives way. At small strain lambda is
    // reduced by that already (M6), at finite strain it is that of three
    // dimensions.
    bool
    cannot_lock(const ModelParameters &model, const int dim)
    {
      return model.mixed() ||
             (model.strain.is_finite() && model.is_plane_stress(dim));
    }



    std::string
    locking_in_words(const MaterialRange &given,
                     const bool           mixed,
                     const bool           no_locking)
    {
      std::string text =
        given.ratio.varies()
          ? format("lambda/mu = %.4g to %.4g, nu = %.5f to %.5f",
                   printable(given.ratio.smallest),
                   printable(given.ratio.largest),
                   given.nu.smallest,
                   given.nu.largest)
          : format("lambda/mu = %.4g, nu = %.5f",
                   printable(given.ratio.largest),
                   given.nu.largest);
      if (given.ratio.largest < nearly_incompressible)
        return text + ": compressible enough for either formulation";
      return text + (mixed ? ": nearly incompressible, handled by the mixed "
                             "formulation"
                     : no_locking ? ": nearly incompressible; in plane stress "
                                    "nothing locks"
                                  : ": nearly incompressible; the displacement "
                                    "formulation locks");
    }
  } // namespace



  template <int dim>
  void
  Preflight<dim>::report(const std::vector<SlitFace<dim>> &slits,
                         const std::vector<std::string>   &earlier)
  {
    log.line(std::string("mixed-cracks ") + MIXED_CRACKS_VERSION +
             ", revision " + MIXED_CRACKS_REVISION + ", deal.II " +
             DEAL_II_PACKAGE_VERSION);
    log.line("case: " + case_in_words());
    report_sizes();
    report_material_and_costs();
    report_periodic_sides();
    report_slits(slits);
    found = earlier;
    find_warnings();
    for (const std::string &warning : found)
      log.line("warning: " + warning);
  }



  template <int dim>
  std::string
  Preflight<dim>::kinematics() const
  {
    return dim == 2 ? body.parameters.model.kinematics : "3-d";
  }



  template <int dim>
  std::string
  Preflight<dim>::case_in_words() const
  {
    const ModelParameters &model = body.parameters.model;
    return body.parameters.geometry.name_of_chosen() + ", " +
           model.formulation + ", " + kinematics() + ", " +
           (model.strain.is_finite()
              ? "finite strain, " + model.strain.law + ", "
              : "") +
           model.crack_density + ", split " + model.energy_split + ", " +
           model.pressure_law + ", coupling " + body.parameters.coupling.kind;
  }



  template <int dim>
  void
  Preflight<dim>::report_sizes() const
  {
    const MeshEstimate mesh = body.counts();
    // a count that is not exact has three digits
    const char *const sizes =
      mesh.is_exact
        ? "ranks: %u; cells: %.0f; dofs: %.0f (u, p: %.0f; phi: %.0f)"
        : "ranks: %u; cells: about %.3g; dofs: about %.3g (u, p: %.3g; phi: "
          "%.3g)";
    log.line(format(sizes,
                    Utilities::MPI::n_mpi_processes(body.communicator()),
                    mesh.n_cells,
                    mesh.n_elastic + mesh.n_phase_field,
                    mesh.n_elastic,
                    mesh.n_phase_field));
    report_mesh_of_file();
    const double cell_size = body.cell_size_at_cracks();
    log.line(format("finest cells h = %.4g mm; length scale l = %.4g mm, "
                    "l/h = %.3g; kappa = %.3g",
                    cell_size,
                    body.length_scale(),
                    printable(body.length_scale() / cell_size),
                    body.material->description().residual_stiffness));
  }



  // Built-in meshes are known to be good
  template <int dim>
  void
  Preflight<dim>::report_mesh_of_file() const
  {
    const GeometryParameters<dim> &geometry = body.parameters.geometry;
    if (geometry.name_of_chosen() != "mesh file")
      return;
    const MeshQuality<dim> quality = quality_of_coarse_mesh(body.triangulation);
    const std::string      remarks = geometry.chosen().about_mesh();
    log.line(format("mesh of the file: %u cells; smallest scaled Jacobian "
                    "%.3g, at %s; %u cells below %g%s",
                    quality.n_cells,
                    quality.smallest,
                    in_brackets(quality.place).c_str(),
                    quality.n_distorted,
                    quality.distorted,
                    remarks.empty() ? "" : ("; " + remarks).c_str()));
  }



  template <int dim>
  void
  Preflight<dim>::report_material_and_costs() const
  {
    const Parameters<dim> &parameters = body.parameters;
    const MeshEstimate     mesh       = body.counts();
    log.line("load steps: " + parameters.load.steps().in_words());
    if (body.material_field->varies())
      log.line(in_words(body.material_range));
    log.line(locking_in_words(body.material_range,
                              parameters.model.mixed(),
                              cannot_lock(parameters.model, dim)));
    const std::string solver =
      choose_linear_solver(
        solver_for_stiffness(parameters.solver, body.material->description())
          .name,
        dim,
        static_cast<types::global_dof_index>(mesh.n_elastic),
        parameters.allows_matrix_free())
        .name;
    log.line(format("memory: about %.2g GB with the linear solver '%s', all "
                    "ranks together",
                    1e-9 * bytes_of_solution<dim>(
                             solver, mesh.n_elastic + mesh.n_phase_field),
                    solver.c_str()));
    log.line(format("checkpoint: about %.3g MB on this mesh and 0.3 kB for "
                    "each load step; twice that on the disk, as the one "
                    "before is kept",
                    1e-6 * static_cast<double>(checkpoint_size(
                             body.fields,
                             static_cast<std::uint64_t>(mesh.n_cells),
                             body.triangulation.n_cells(0)))));
  }



  template <int dim>
  void
  Preflight<dim>::report_periodic_sides() const
  {
    const auto pairs = body.parameters.geometry.periodic_pairs();
    for (std::size_t i = 0; i < pairs.size(); ++i)
      log.line("periodic sides: '" + pairs[i].names[0] + "' and '" +
               pairs[i].names[1] + "', " +
               in_brackets(
                 Point<dim>(body.constraints.periodic().sides().periods()[i])) +
               " apart");
    const auto &held = body.constraints.held_components();
    if (held.empty())
      return;
    std::vector<std::string> components;
    for (const unsigned int d : held)
      components.push_back(std::string(1, "xyz"[d]));
    log.line(
      "held at " + in_brackets(body.constraints.held_vertex()) +
      ", as nothing else holds the body: " + join_names(components, " and "));
  }



  template <int dim>
  void
  Preflight<dim>::report_slits(const std::vector<SlitFace<dim>> &slits) const
  {
    // a geometry with slits of its own has said so
    if (slits.empty() || !body.parameters.geometry.chosen().slits().empty())
      return;
    log.line(format("slits: %zu faces of the coarse mesh, from %s to %s, lie "
                    "between doubled nodes; %s",
                    slits.size(),
                    in_brackets(slits.front().place.corners.front()).c_str(),
                    in_brackets(slits.back().place.corners.back()).c_str(),
                    body.parameters.initial_cracks.broken_slits
                      ? "the phase field is 0 there (Initial cracks/Broken "
                        "slits)"
                      : "gaps and no more, Initial cracks/Broken slits is "
                        "false"));
  }



  template <int dim>
  void
  Preflight<dim>::warn_of_model()
  {
    const Parameters<dim> &parameters = body.parameters;
    const ModelParameters &model      = parameters.model;
    const double resolution = body.length_scale() / body.cell_size_at_cracks();
    if (resolution < 2. * (1. - 1e-6))
      found.push_back(format(
        "l/h = %.3g: the length scale is resolved by fewer than two cells; "
        "the effective toughness is too large",
        resolution));
    const double ratio = body.material_range.ratio.largest;
    if (!cannot_lock(model, dim) && ratio > nearly_incompressible)
      found.push_back(
        format("lambda/mu = %.3g with the displacement formulation: expect "
               "locking; Model/Formulation = mixed avoids it",
               printable(ratio)));
    if (parameters.coupling.kind != "iterated")
      found.push_back("coupling '" + parameters.coupling.kind +
                      "': a running crack advances about one cell per load "
                      "step, which acts as a rate effect");
    // those that do not open are laws of small strain
    if (model.mixed() && kinematics() != "plane stress" &&
        !model.strain.is_finite() && model.pressure_law != "relaxed bulk" &&
        ratio > nearly_incompressible)
      found.push_back("pressure law '" + model.pressure_law +
                      "' in a nearly incompressible solid (" + kinematics() +
                      "): cracks hardly open, see doc/model.md, section 3");
  }



  template <int dim>
  bool
  Preflight<dim>::is_even_rubber() const
  {
    const MaterialDescription &material = body.material->description();
    return material.strains == Strains::finite && material.constants;
  }



  // Of rubber that varies with lambda and mu at F = I: the law would have to be
  // evaluated wherever it differs.
  template <int dim>
  ImpliedStrength
  Preflight<dim>::strength() const
  {
    const MaterialDescription &material = body.material->description();
    if (!is_even_rubber())
      return implied_strength(material.crack_density,
                              material.degradation,
                              body.material_range,
                              body.length_scale());
    return implied_strength(material,
                            material.constants->critical_energy_release_rate,
                            body.length_scale());
  }



  template <int dim>
  void
  Preflight<dim>::find_warnings()
  {
    warn_of_model();
    const CaseScales scales = case_scales(body.parameters,
                                          coarse_extent(body.triangulation),
                                          strength(),
                                          body.length_scale(),
                                          body.cell_size_at_cracks());
    log.line(in_words(scales.strength));
    const std::string remark = remark_about(scales);
    if (!remark.empty())
      log.line(remark);
    std::vector<std::string> warnings = warnings_about(scales);
    warnings.push_back(body.parameters.load.warning());
    if (is_even_rubber())
      warnings.push_back(warning_about_decline(body.material->description()));
    if (!body.not_built)
      warnings.push_back(
        warning_about_unbreakable(body.parameters, body.fields));
    for (const std::string &warning : warnings)
      if (!warning.empty())
        found.push_back(warning);
  }



  template <int dim>
  void
  Preflight<dim>::report_not_checked() const
  {
    std::vector<std::string> open = {
      "expressions at later times and in all points",
      "whether Output/Directory can be written"};
    if (body.not_built)
      open.insert(open.begin(),
                  "the mesh itself, which is counted and not built (" +
                    std::string(body.not_built->is_exact ? ""
                                                         : "but for cells "
                                                           "between fine and "
                                                           "coarse ones; ") +
                    "ranges of a material that varies are those of a coarser "
                    "mesh)");
    if (body.parameters.mesh.adaptation != "none")
      open.push_back("cells that adaptation adds");
    log.line("not checked: " + join_names(open, "; "));
  }



  template class Preflight<2>;
  template class Preflight<3>;
} // namespace MixedCracks
