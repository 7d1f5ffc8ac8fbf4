// SPDX-License-Identifier: GPL-2.0-or-later
// What is known of a run before its first step, and refused.
#include <core/errors.h>
#include <core/names.h>
#include <core/simulation.h>

#include <discretization/free_motions.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // what `--check` builds in a second
    constexpr double most_cells_to_check_2d = 20000.;
    constexpr double most_cells_to_check_3d = 4000.;
  } // namespace



  template <int dim>
  std::optional<MeshEstimate>
  make_mesh_to_check(const Parameters<dim> &parameters,
                     const FieldLayout     &layout,
                     Triangulation<dim>    &triangulation)
  {
    make_coarse_mesh(parameters, triangulation);
    const double most =
      dim == 2 ? most_cells_to_check_2d : most_cells_to_check_3d;
    const unsigned int n_global = parameters.mesh.global_refinements;
    const auto         regions  = refined_regions(parameters, triangulation);
    const MeshEstimate estimate =
      estimate_mesh(triangulation, layout, n_global, regions);
    if (estimate.n_cells <= most)
    {
      refine_globally_and_in_regions(triangulation, n_global, regions);
      return {};
    }
    std::vector<Point<dim>> points;
    for (const auto &entry :
         parameters.boundary_conditions.point_displacements())
      points.push_back(entry.point);
    for (const auto &entry : parameters.point_displacements.points())
      points.push_back(entry.position);
    refine_at_points(triangulation, n_global, regions, points, most);
    return estimate;
  }



  template <int dim>
  void
  Simulation<dim>::require_held_body() const
  {
    const std::vector<std::string> motions =
      free_rigid_motions(triangulation,
                         constraints.prescribed_components(),
                         constraints.prescribed_points());
    if (!motions.empty())
      throw InputError(
        "Boundary conditions/Displacement, with Displacement at points, leaves "
        "rigid motions free: " +
        join_names(motions, "; ") +
        ". Allowed are conditions that prevent all of them.");
  }



  template <int dim>
  void
  Simulation<dim>::require_solver_for_stiffness() const
  {
    if (material->description().residual_stiffness == 0. &&
        parameters.solver.name == "block AMG")
      throw InputError("Linear solver/Name: found 'block AMG' with "
                       "Model/Residual stiffness = " +
                       parameters.model.residual_stiffness +
                       ", which is 0: broken cells then have no stiffness, and "
                       "multigrid needs some. Allowed are direct, auto, or a "
                       "residual stiffness above 0.");
  }



  template <int dim>
  SolverParameters
  Simulation<dim>::solver_parameters() const
  {
    SolverParameters result = parameters.solver;
    if (material->description().residual_stiffness == 0. &&
        result.name == "auto")
      result.name = "direct";
    return result;
  }



  template <int dim>
  std::string
  Simulation<dim>::hint_at_no_stiffness() const
  {
    if (material->description().residual_stiffness > 0.)
      return "";
    return "; Model/Residual stiffness (kappa) is 0, so that broken cells have "
           "no stiffness and the matrix may be singular: try a small one";
  }



  template <int dim>
  MeshEstimate
  Simulation<dim>::mesh_counts() const
  {
    if (not_built)
      return *not_built;
    MeshEstimate counts;
    counts.n_cells       = triangulation.n_global_active_cells();
    counts.n_elastic     = fields.elastic.n_dofs();
    counts.n_phase_field = fields.phase_field.n_dofs();
    counts.finest_level  = triangulation.n_global_levels() - 1;
    counts.finest_size   = finest_cell_size(triangulation, communicator);
    return counts;
  }



  template <int dim>
  void
  Simulation<dim>::log_not_checked()
  {
    std::vector<std::string> open = {
      "expressions at later times and in all points",
      "whether Output/Directory can be written"};
    if (not_built)
      open.insert(open.begin(),
                  "the mesh itself, which is counted and not built (" +
                    std::string(not_built->is_exact ? ""
                                                    : "but for cells "
                                                      "between fine and "
                                                      "coarse ones; ") +
                    "ranges of a material that varies are those of a coarser "
                    "mesh)");
    if (parameters.mesh.adaptation != "none")
      open.push_back("cells that adaptation adds");
    log.line("not checked: " + join_names(open, "; "));
  }



#define INSTANTIATE(dim)                                                   \
  template std::optional<MeshEstimate> make_mesh_to_check(                 \
    const Parameters<dim> &, const FieldLayout &, Triangulation<dim> &);   \
  template void Simulation<dim>::require_held_body() const;                \
  template void Simulation<dim>::require_solver_for_stiffness() const;     \
  template SolverParameters Simulation<dim>::solver_parameters() const;    \
  template std::string      Simulation<dim>::hint_at_no_stiffness() const; \
  template MeshEstimate     Simulation<dim>::mesh_counts() const;          \
  template void             Simulation<dim>::log_not_checked();
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
