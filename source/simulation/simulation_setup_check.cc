// SPDX-License-Identifier: GPL-2.0-or-later
// The mesh that `--check` looks at. A large mesh is not built: its coarse cells
// are made 2^k times as long, its cells are counted on paper from there, k more
// levels deep (discretization/mesh_estimate.cc), and the numbers are corrected
// by the true number of coarse cells,
//
//   c = n_coarse/(n_larger 2^(k dim)),  n -> c n,  h -> h c^(-1/dim),
//
// as edges are rarely divisible by 2^k. What is built has enough cells to try
// expressions and points of the .prm on.

#include <simulation/simulation_setup.h>

#include <cmath>

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
    for (const auto &entries :
         {parameters.boundary_conditions.point_displacements(),
          parameters.boundary_conditions.point_forces()})
      for (const auto &entry :
           placed_points(parameters, entries, triangulation, true))
        points.push_back(entry.point);
    for (const auto &entry :
         parameters.boundary_conditions.point_phase_fields())
      points.push_back(entry.point);
    for (const auto &entry : parameters.point_displacements.points())
      points.push_back(entry.position);
    refine_at_points(triangulation, n_global, regions, points, most);
    return estimate;
  }



#define INSTANTIATE(dim)                                   \
  template std::optional<MeshEstimate> make_mesh_to_check( \
    const Parameters<dim> &, const FieldLayout &, Triangulation<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
