// SPDX-License-Identifier: GPL-2.0-or-later
// What is known of a run before its first step, and refused.
#include <base/errors.h>
#include <base/names.h>

#include <discretization/free_motions.h>

#include <simulation/simulation.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // what `--check` builds in a second
    constexpr double most_cells_to_check_2d = 20000.;
    constexpr double most_cells_to_check_3d = 4000.;



    // How often the cells of the coarse mesh are doubled in length for a check.
    template <int dim>
    unsigned int
    doublings_to_check(const Geometry<dim> &geometry, const double most)
    {
      const double n = geometry.n_coarse_cells().value_or(0.);
      return n <= most ? 0
                       : static_cast<unsigned int>(
                           std::ceil(std::log2(n / most) / (1. * dim)));
    }



    // The estimate of a mesh from one whose coarse cells are larger. Edges are
    // not always divisible; sizes and numbers fill the same volume.
    template <int dim>
    void
    undo_doublings(const unsigned int n_doublings,
                   const double       n_coarse_cells,
                   const double       n_larger_cells,
                   MeshEstimate      &estimate)
    {
      const double correction =
        n_coarse_cells /
        (n_larger_cells * std::pow(2., 1. * dim * n_doublings));
      estimate.n_cells *= correction;
      estimate.n_elastic *= correction;
      estimate.n_phase_field *= correction;
      estimate.finest_size *= std::pow(correction, -1. / dim);
      estimate.finest_level -= n_doublings;
      estimate.is_exact = false;
    }
  } // namespace



  template <int dim>
  std::optional<MeshEstimate>
  make_mesh_to_check(const Parameters<dim> &parameters,
                     const FieldLayout     &layout,
                     Triangulation<dim>    &triangulation)
  {
    const double most =
      dim == 2 ? most_cells_to_check_2d : most_cells_to_check_3d;
    const Geometry<dim> &geometry    = parameters.geometry.chosen();
    const unsigned int   n_doublings = doublings_to_check(geometry, most);
    const auto           larger =
      n_doublings > 0 ? geometry.coarser(std::pow(2., n_doublings)) : nullptr;
    make_coarse_mesh(parameters, larger ? *larger : geometry, triangulation);
    const unsigned int n_global =
      parameters.mesh.global_refinements + n_doublings;
    const auto   regions = refined_regions(parameters, triangulation);
    const double n_built = triangulation.n_global_active_cells();
    MeshEstimate estimate =
      estimate_mesh(triangulation, layout, n_global, regions);
    if (larger)
      undo_doublings<dim>(
        n_doublings, *geometry.n_coarse_cells(), n_built, estimate);
    else if (estimate.n_cells <= most)
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
