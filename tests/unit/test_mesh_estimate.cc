// SPDX-License-Identifier: GPL-2.0-or-later
// Cells and dofs of a mesh that is not built.
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <discretization/mesh_estimate.h>
#include <discretization/nearest_vertex.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;
using namespace dealii;

namespace
{
  template <int dim>
  using Mesh = parallel::distributed::Triangulation<dim>;

  template <int dim>
  void
  make_coarse(Mesh<dim> &mesh)
  {
    Point<dim> upper;
    for (unsigned int d = 0; d < dim; ++d)
      upper[d] = 1. + d;
    GridGenerator::subdivided_hyper_rectangle(
      mesh,
      std::vector<unsigned int>(dim, dim == 2 ? 4 : 2),
      Point<dim>(),
      upper,
      true);
  }

  // what is estimated compared with what is there
  template <int dim>
  void
  compare(const FieldLayout            &layout,
          const unsigned int            n_global,
          const RefinementRegions<dim> &regions,
          const double                  tolerance,
          const double                  tolerance_of_dofs)
  {
    Mesh<dim> mesh(MPI_COMM_WORLD);
    make_coarse(mesh);
    const MeshEstimate estimate =
      estimate_mesh(mesh, layout, n_global, regions);
    refine_globally_and_in_regions(mesh, n_global, regions);
    Fields<dim> fields(mesh, layout);
    fields.distribute();
    const auto near =
      [](const double found, const double exact, const double bound) {
        EXPECT_NEAR(found / exact, 1., bound) << found << ' ' << exact;
      };
    near(estimate.n_cells, mesh.n_global_active_cells(), tolerance);
    near(estimate.n_elastic, fields.elastic.n_dofs(), tolerance_of_dofs);
    near(
      estimate.n_phase_field, fields.phase_field.n_dofs(), tolerance_of_dofs);
    EXPECT_EQ(estimate.finest_level + 1, mesh.n_global_levels());
    EXPECT_EQ(estimate.is_exact, tolerance == 0.);
    double size = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned() &&
          cell->level() == static_cast<int>(estimate.finest_level))
        size = std::max(size, std::pow(cell->measure(), 1. / dim));
    size = Utilities::MPI::max(size, MPI_COMM_WORLD);
    EXPECT_NEAR(estimate.finest_size, size, 1e-9 * size);
  }

  template <int dim>
  void
  compare_regions()
  {
    Point<dim> lower, upper, center;
    for (unsigned int d = 0; d < dim; ++d)
    {
      lower[d]  = 0.2;
      upper[d]  = 0.8;
      center[d] = 0.6;
    }
    const RefinementBox<dim>          box{BoundingBox<dim>({lower, upper}),
                                 dim == 2 ? 4u : 2u};
    const RefinementSurroundings<dim> ball{
      {FlatPiece<dim>::point(center)}, 0.3, dim == 2 ? 5u : 3u};
    // hanging nodes are not counted, and in 3-d these meshes of some hundred
    // cells have many: up to 0.4 of all dofs
    const double cells = dim == 2 ? 0.06 : 0.15, dofs = dim == 2 ? 0.06 : 0.45;
    compare<dim>({true, 2}, 1, {{box}, {}}, cells, dofs);
    compare<dim>({false, 1}, 1, {{}, {ball}}, cells, dofs);
    compare<dim>({true, 2}, 0, {{box}, {ball}}, cells, dofs);
  }
} // namespace



TEST(MeshEstimate, IsExactForGlobalRefinement)
{
  for (const bool mixed : {true, false})
  {
    compare<2>({mixed, 2}, 3, {}, 0., 0.);
    compare<2>({mixed, 1}, 0, {}, 0., 0.);
    compare<3>({mixed, 2}, 1, {}, 0., 0.);
    compare<3>({mixed, 1}, 2, {}, 0., 0.);
  }
}



TEST(MeshEstimate, IsNearForRegions)
{
  compare_regions<2>();
  compare_regions<3>();
}



TEST(MeshEstimate, OfMillionsOfCellsTakesNoTime)
{
  Mesh<2> mesh(MPI_COMM_WORLD);
  make_coarse(mesh);
  const RefinementBox<2> box{
    BoundingBox<2>({Point<2>(0.2, 0.2), Point<2>(0.8, 0.8)}), 6};
  const MeshEstimate estimate = estimate_mesh(mesh, {true, 2}, 6, {{box}, {}});
  // 2^12 cells of 1 x 2 / 16 wide and high each: 0.36 / (1/8 * 4^-12)
  EXPECT_NEAR(estimate.n_cells, 0.36 * 8. * std::pow(4., 12.), 0.02 * 4.8e7);
  EXPECT_EQ(mesh.n_global_active_cells(), 16u);
}



TEST(MeshEstimate, PointsFindTheVerticesOfTheWholeMesh)
{
  Mesh<2> mesh(MPI_COMM_WORLD);
  make_coarse(mesh);
  const RefinementSurroundings<2> corner{
    {FlatPiece<2>::point(Point<2>(1., 2.))}, 0.4, 3};
  const Point<2> fine(1. - 3. / 128., 2. - 3. / 64.), coarse(3. / 16., 1. / 8.);
  refine_at_points<2>(mesh, 2, {{}, {corner}}, {fine, coarse}, 16.);
  EXPECT_LT(mesh.n_global_active_cells(), 150u);
  EXPECT_NEAR(nearest_vertex(mesh, fine).distance(fine), 0., 1e-12);
  EXPECT_NEAR(nearest_vertex(mesh, coarse).distance(coarse), 0., 1e-12);
  EXPECT_NEAR(
    nearest_vertex(mesh, Point<2>(77., 78.)).distance(Point<2>(1., 2.)),
    0.,
    1e-12);
}
