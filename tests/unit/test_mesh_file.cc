// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/distributed/tria.h>

#include <gtest/gtest.h>

#include "mesh_files.h"

using namespace GeometryTests;



TEST(MeshFile, Gmsh)
{
  const auto geometry = mesh_file(plate);
  geometry->check();
  dealii::Triangulation<2> triangulation;
  geometry->create(triangulation);
  EXPECT_EQ(triangulation.n_active_cells(), 72u);
  EXPECT_EQ(triangulation.begin_active()->material_id(), 7u);
  const auto ids = geometry->boundary_ids();
  ASSERT_EQ(ids.size(), 5u);
  for (const char *side : {"bottom", "right", "top", "left"})
    EXPECT_NEAR(boundary_length(triangulation, ids.at(side)), 20., 1e-12);

  triangulation.refine_global(2);
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() &&
          ids.at("hole").contains(cell->face(f)->boundary_id()))
      {
        EXPECT_NEAR(cell->face(f)->vertex(0).distance({10., 10.}), 4., 1e-12);
      }
}



TEST(MeshFile, Abaqus)
{
  const auto geometry = mesh_file(beam);
  geometry->check();
  dealii::Triangulation<2> triangulation;
  geometry->create(triangulation);
  const auto ids = geometry->boundary_ids();
  EXPECT_NEAR(boundary_length(triangulation, ids.at("left")), 10., 1e-12);
  EXPECT_NEAR(boundary_length(triangulation, ids.at("bottom")), 39., 1e-12);
  EXPECT_NEAR(boundary_length(triangulation, ids.at("notch")), 7., 1e-12);
  EXPECT_EQ(triangulation.begin_active()->material_id(), 3u);
}



TEST(MeshFile, UcdAndGmsh4)
{
  dealii::Triangulation<2> ucd, gmsh4;
  mesh_file({written("# a comment\n4 2 0 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n"
                     "4 0 1 0\n1 5 quad 1 2 3 4\n2 9 line 1 2\n"),
             "9 = bottom",
             ""})
    ->create(ucd);
  EXPECT_EQ(ucd.n_active_cells(), 1u);
  EXPECT_EQ(ucd.begin_active()->material_id(), 5u);
  EXPECT_NEAR(boundary_length(ucd, 9), 1., 1e-12);

  mesh_file({written("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 "
                     "0\n1 0 0 0 1 1 0 1 6 0\n$EndEntities\n$Nodes\n1 4 1 4\n"
                     "2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                     "$EndNodes\n$Elements\n1 1 1 1\n2 1 3 1\n1 1 2 3 4\n"
                     "$EndElements\n"),
             "",
             ""})
    ->create(gmsh4);
  EXPECT_EQ(gmsh4.n_active_cells(), 1u);
  EXPECT_EQ(gmsh4.begin_active()->material_id(), 6u);
}



TEST(MeshFile, Distributed)
{
  dealii::parallel::distributed::Triangulation<2> triangulation(MPI_COMM_WORLD);
  mesh_file(plate)->create(triangulation);
  triangulation.refine_global(2);
  EXPECT_EQ(triangulation.n_global_active_cells(), 72u * 16u);
}
