// SPDX-License-Identifier: GPL-2.0-or-later
// All parameters of a run, by subsection, and the checks that need more than
// one of them. They run before there is a mesh; those that need one come with
// it (simulation_setup.cc, case_checks.cc).

#include <base/ranges.h>

#include <simulation/parameters.h>

#include <limits>

namespace MixedCracks
{
  template <int dim>
  void
  Parameters<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    geometry.add_parameters(prm);
    mesh.add_parameters(prm);
    model.add_parameters(prm);
    coupling.add_parameters(prm);
    material.add_parameters(prm);
    geometry.take_thickness_from(material.thickness);
    material.take_strains_from(model.strain);
    boundary_conditions.add_parameters(prm);
    fluid.add_parameters(prm);
    initial_cracks.add_parameters(prm);
    load.add_parameters(prm);
    solver.add_parameters(prm);
    output.add_parameters(prm);
    crack_opening.add_parameters(prm);
    point_displacements.add_parameters(prm);
    watched_boundaries.add_parameters(prm);
    traction_profiles.add_parameters(prm);
    events.add_parameters(prm);
  }



  template <int dim>
  double
  Parameters<dim>::change_where_a_crack_ran() const
  {
    // that of a node which breaks, as for the end of a step (doc/model.md)
    constexpr double broken = 0.9;
    if (coupling.kind != "iterated")
      return std::numeric_limits<double>::infinity();
    const double bound = load.largest_phase_field_change;
    return bound > 0. ? bound : broken;
  }



  template <int dim>
  std::string
  Parameters<dim>::force_boundary() const
  {
    if (!load.force_boundary.empty())
      return load.force_boundary;
    for (const auto &entry : boundary_conditions.displacements())
      if (entry.component < dim)
        return entry.boundary;
    const auto pairs = geometry.periodic_pairs();
    return pairs.empty() ? "" : pairs.front().names[1];
  }



  template <int dim>
  bool
  Parameters<dim>::allows_matrix_free() const
  {
    return model.mixed() && !(model.strain.is_finite() &&
                              !boundary_conditions.pressures().empty());
  }



  template <int dim>
  void
  Parameters<dim>::check_matrix_free() const
  {
    if (solver.name != "matrix-free" || allows_matrix_free())
      return;
    if (!model.mixed())
      throw InputError("Linear solver/Name: found 'matrix-free' with "
                       "Model/Formulation = displacement. Allowed are direct, "
                       "block AMG and auto, or Formulation = mixed.");
    throw InputError(
      "Linear solver/Name: found 'matrix-free' with Model/Strains = finite "
      "and Boundary conditions/Pressure, which follows the boundary and has "
      "a part of the matrix. Allowed are direct, block AMG and auto.");
  }



  template <int dim>
  void
  Parameters<dim>::check() const
  {
    geometry.check();
    mesh.check(geometry.chosen().extent(), geometry.chosen().names());
    model.check(dim);
    material.check();
    const auto boundaries = geometry.chosen().boundary_ids();
    const auto pairs      = geometry.periodic_pairs();
    boundary_conditions.check(
      boundaries,
      [this]() { return geometry.chosen().hint_about_boundaries(); },
      geometry.point_sets().names(),
      !pairs.empty());
    boundary_conditions.check_periodic(pairs, boundaries);
    boundary_conditions.mean_strain(model.strain.is_finite());
    fluid.check();
    if (model.strain.is_finite() && fluid.pressure())
      throw InputError("Fluid/Pressure: found '" + fluid.pressure_text +
                       "' with Model/Strains = finite. Allowed: 0, which is no "
                       "fluid; Boundary conditions/Traction is a dead load.");
    if (dim == 2 && model.strain.is_finite() &&
        model.kinematics == "plane stress" &&
        !boundary_conditions.pressures().empty())
      throw InputError(
        "Boundary conditions/Pressure: found with Model/Strains = finite and "
        "Model/Kinematics = plane stress, where the area it acts on changes "
        "with the thickness. Allowed are plane strain, or the component "
        "'normal' of Boundary conditions/Traction, a dead load.");
    initial_cracks.check();
    load.check();
    solver.check();
    check_matrix_free();
    output.check();
    crack_opening.check();
    point_displacements.check();
    watched_boundaries.boundaries(boundaries);
    traction_profiles.boundaries(boundaries);
    events.check(dim);

    std::vector<std::string> prescribed;
    for (const auto &entry : boundary_conditions.displacements())
      if (entry.component != dim && !contains(prescribed, entry.boundary))
        prescribed.push_back(entry.boundary);
    for (const PeriodicPair &pair : pairs)
      append(prescribed, pair.names);
    const std::string force = force_boundary();
    if (prescribed.empty() && !force.empty())
      throw InputError("Load stepping/Force boundary: found '" + force +
                       "', but displacement is prescribed at points only. "
                       "Allowed is nothing: the force is then the reaction at "
                       "the points that move.");
    if (force.empty())
      return;
    if (!contains(prescribed, force))
      throw InputError("Load stepping/Force boundary: " +
                       unknown_name_message(force, prescribed) +
                       " These are the boundaries with prescribed "
                       "displacement and periodic sides, where there is a "
                       "reaction.");
  }



  template struct Parameters<2>;
  template struct Parameters<3>;
} // namespace MixedCracks
