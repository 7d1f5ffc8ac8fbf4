// SPDX-License-Identifier: GPL-2.0-or-later
// Slits are found by their places, and are seen to close.
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/tria_description.h>

#include <gtest/gtest.h>

#include <output/slit_overlap.h>

#include "geometries.h"

using namespace GeometryTests;

namespace
{
  // the half above y = 0.5 moved by @p shift, but for what is behind the tip
  LinearAlgebra::Vector
  moved(const Fields<2> &fields, const dealii::Tensor<1, 2> &shift)
  {
    LinearAlgebra::Vector owned = fields.owned_vector(fields.elastic_dofs);
    for (const auto &cell : fields.elastic.active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int v : cell->vertex_indices())
          for (unsigned int d = 0; d < 2; ++d)
          {
            const auto dof = cell->vertex_dof_index(v, d);
            if (fields.elastic_dofs.owned.is_element(dof))
              owned(dof) = cell->center()[1] > 0.5 && cell->vertex(v)[0] < 0.49
                             ? shift[d]
                             : 0.;
          }
    owned.compress(dealii::VectorOperation::insert);
    LinearAlgebra::Vector result = fields.ghosted_vector(fields.elastic_dofs);
    result                       = owned;
    return result;
  }

  // two squares beside each other, @p gap apart, with a slit between them at x
  void
  make_two_squares(const dealii::Point<2>                          &at,
                   const double                                     gap,
                   dealii::parallel::distributed::Triangulation<2> &mesh)
  {
    std::vector<dealii::Point<2>>    vertices;
    std::vector<dealii::CellData<2>> cells(2);
    for (const double x : {-1., -0.5 * gap, 0.5 * gap, 1.})
      for (const double y : {0., 1.})
        vertices.push_back(at + dealii::Point<2>(x, y));
    cells[0].vertices = {0, 2, 1, 3};
    cells[1].vertices = {4, 6, 5, 7};
    mesh.create_triangulation(vertices, cells, {});
  }

  // the right one of them moved by that, and both turned as one body
  double
  depth_between_squares(const dealii::Point<2> &at,
                        const double            gap,
                        const double            shift,
                        const double            turn,
                        const unsigned int      n_refinements)
  {
    dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
    make_two_squares(at, gap, mesh);
    mesh.refine_global(n_refinements);
    Fields<2> fields(mesh, {false, 1});
    fields.distribute();
    SlitOverlap<2> overlap(fields);
    overlap.reinit();
    LinearAlgebra::Vector owned = fields.owned_vector(fields.elastic_dofs);
    for (const auto &cell : fields.elastic.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
        {
          const dealii::Tensor<1, 2> place = cell->vertex(v) - at;
          const double u[] = {(cell->center()[0] > at[0] ? shift : 0.) -
                                turn * place[1],
                              turn * place[0]};
          for (unsigned int d = 0; d < 2; ++d)
            if (const auto dof = cell->vertex_dof_index(v, d);
                fields.elastic_dofs.owned.is_element(dof))
              owned(dof) = u[d];
        }
    owned.compress(dealii::VectorOperation::insert);
    LinearAlgebra::Vector elastic = fields.ghosted_vector(fields.elastic_dofs);
    elastic                       = owned;
    return overlap.deepest(elastic).depth;
  }
} // namespace



TEST(SlitOverlap, SlitsAreFoundOnTheCoarseMesh)
{
  for (const bool with_slit : {true, false})
  {
    dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
    const auto                                      body = with_slit
                                                             ? geometry("slit square", {{"Cell size", "0.125"}})
                                                             : geometry("rectangle", {{"Cell size", "0.125"}});
    body->create(mesh);
    mesh.refine_global(1);
    const auto faces = slit_faces(mesh);
    EXPECT_EQ(faces.size(), with_slit ? 4u : 0u);
    for (const auto &face : faces)
    {
      EXPECT_NEAR(face.place.corners[0][1], 0.5, 1e-12);
      EXPECT_NEAR(std::abs(face.normal[1]), 1., 1e-12);
    }
  }
}



TEST(SlitOverlap, OnlyFacesThatPassThroughEachOtherCount)
{
  dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
  geometry("slit square", {{"Cell size", "0.125"}})->create(mesh);
  mesh.refine_global(1);
  Fields<2> fields(mesh, {false, 1});
  fields.distribute();
  SlitOverlap<2> overlap(fields);
  overlap.reinit();

  const auto depth = [&](const double x, const double y) {
    return overlap.deepest(moved(fields, dealii::Point<2>(x, y)));
  };
  EXPECT_NEAR(depth(0., -0.01).depth, 0.01, 1e-15);
  EXPECT_NEAR(depth(0., -0.01).position[1], 0.5, 1e-12);
  EXPECT_NEAR(depth(0.02, -0.01).depth, 0.01, 1e-15);
  EXPECT_EQ(depth(0., 0.01).depth, 0.);
  EXPECT_EQ(depth(0.02, 0.).depth, 0.);
  EXPECT_EQ(depth(0.02, -1e-5).depth, 0.); // rounding of a sliding slit
}



// Wherever they are: two of these slits lie between boxes of 64e-9.
TEST(SlitOverlap, PartnersMayDifferByRounding)
{
  for (unsigned int i = 0; i < 16; ++i)
    EXPECT_NEAR(depth_between_squares(
                  {i * 8e-9, 0.}, 4e-12, /*shift=*/-0.01, /*turn=*/0., 2),
                0.01,
                1e-12)
      << i;
}



// Vertices beside each other are no partners, however far the origin is.
TEST(SlitOverlap, TheOriginMayBeAnywhere)
{
  EXPECT_EQ(depth_between_squares({3e4, 2e4}, 0., 0., 0.1, 5), 0.);
  EXPECT_NEAR(depth_between_squares({3e4, 2e4}, 0., -0.01, 0.1, 5), 0.01, 1e-8);
}
