// SPDX-License-Identifier: GPL-2.0-or-later
// Meshes of hexahedra from files: measures, ids, orientation, curved faces, and
// what is refused.
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <cmath>

#include "hex_meshes.h"
#include "mesh_files.h"

using namespace GeometryTests;
using dealii::Point;
using dealii::Triangulation;

namespace
{
  const std::string names = "1 = bottom ; 2 = top";

  void
  read(const std::string &text,
       Triangulation<3>  &triangulation,
       const std::string &boundary_names = names,
       const std::string &circles        = "")
  {
    const auto geometry =
      mesh_file<3>({written(text), boundary_names, circles});
    geometry->check();
    geometry->create(triangulation);
  }

  double
  area(const Triangulation<3> &triangulation, const unsigned int id)
  {
    double result = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == id)
          result += face->measure();
    return result;
  }

  template <int dim>
  std::string
  message_about(const std::string &text, const std::string &boundaries = "")
  {
    try
    {
      Triangulation<dim> triangulation;
      mesh_file<dim>({written(text), boundaries, ""})->create(triangulation);
    }
    catch (const InputError &error)
    {
      const std::string message = error.what();
      EXPECT_NE(message.find("Geometry/Mesh file/"), std::string::npos)
        << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message;
    }
    ADD_FAILURE() << "accepted: " << text.substr(0, 300);
    return "";
  }

  void
  expect_in(const std::string &part, const std::string &whole)
  {
    EXPECT_NE(whole.find(part), std::string::npos)
      << "'" << part << "' is not in: " << whole;
  }

  // 3 x 2 cubes become parallelepipeds of volume 2; faces of y = const, of the
  // area 1.25
  HexMesh
  sheared()
  {
    return unit_cubes(3, 2, [](const Point<3> &x) {
      return Point<3>(x[0], 2. * x[1] + 0.75 * x[0], x[2]);
    });
  }

  void
  expect_sheared(const Triangulation<3> &triangulation,
                 const bool              with_materials = true)
  {
    EXPECT_EQ(triangulation.n_active_cells(), 6u);
    EXPECT_NEAR(dealii::GridTools::volume(triangulation), 12., 1e-12);
    EXPECT_NEAR(area(triangulation, 1), 3.75, 1e-12);
    EXPECT_NEAR(area(triangulation, 2), 3.75, 1e-12);
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      if (with_materials)
      {
        EXPECT_EQ(cell->material_id(), cell->center()[0] < 1. ? 7u : 8u);
      }
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
        {
          const double height = face->center()[1] - 0.75 * face->center()[0];
          EXPECT_EQ(face->boundary_id(),
                    height < 1e-9 ? 1u : (height > 4. - 1e-9 ? 2u : 0u));
        }
    }
  }

  // around the axis of z: a tube of four cells between radius 1 and 2
  HexMesh
  tube()
  {
    HexMesh mesh;
    for (unsigned int i = 0; i < 4; ++i)
      for (const double r : {1., 2.})
        for (const double z : {0., 1.})
          mesh.nodes.push_back({r * std::cos(i * dealii::numbers::PI_2),
                                r * std::sin(i * dealii::numbers::PI_2),
                                z});
    for (unsigned int i = 0; i < 4; ++i)
    {
      const unsigned int a = 4 * i, b = 4 * ((i + 1) % 4);
      mesh.cells.push_back(
        {{{a, a + 2, b + 2, b, a + 1, a + 3, b + 3, b + 1}}, 7});
      mesh.faces.push_back({{{a, a + 1, b + 1, b}}, 1, i, 6});
      mesh.faces.push_back({{{a + 2, a + 3, b + 3, b + 2}}, 2, i, 4});
    }
    return mesh;
  }
} // namespace



TEST(MeshFile3d, EveryFormatGivesTheSameMesh)
{
  Triangulation<3> gmsh, abaqus, ucd;
  read(sheared().gmsh2(), gmsh);
  expect_sheared(gmsh);
  read(sheared().ucd(), ucd);
  expect_sheared(ucd);
  read(sheared().abaqus(), abaqus);
  expect_sheared(abaqus, false);
  EXPECT_EQ(abaqus.begin_active()->material_id(), 7u);
}



TEST(MeshFile3d, Gmsh4WithPhysicalVolumesAndSurfaces)
{
  Triangulation<3> mesh;
  read("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 1\n"
       "1 0 0 0 1 0 1 1 5 0\n1 0 0 0 1 1 1 1 6 0\n$EndEntities\n"
       "$Nodes\n1 8 1 8\n3 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n"
       "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
       "$EndNodes\n$Elements\n2 2 1 2\n2 1 3 1\n1 1 2 6 5\n"
       "3 1 5 1\n2 1 2 3 4 5 6 7 8\n$EndElements\n",
       mesh,
       "5 = bottom");
  EXPECT_EQ(mesh.n_active_cells(), 1u);
  EXPECT_EQ(mesh.begin_active()->material_id(), 6u);
  EXPECT_NEAR(area(mesh, 5), 1., 1e-12);
  EXPECT_NEAR(area(mesh, 0), 5., 1e-12);
}



TEST(MeshFile3d, CornersMayBeCountedFromAnyOne)
{
  HexMesh      turned = sheared();
  unsigned int i      = 0;
  for (HexMesh::Cell &cell : turned.cells)
  {
    turn(cell, i % 4, i % 2 == 0);
    ++i;
  }
  Triangulation<3> mesh;
  read(turned.gmsh2(), mesh);
  expect_sheared(mesh);
  mesh.refine_global(1);
  EXPECT_NEAR(dealii::GridTools::volume(mesh), 12., 1e-12);
  EXPECT_NEAR(area(mesh, 1), 3.75, 1e-12);
}



TEST(MeshFile3d, CellsInsideOutAreTurned)
{
  HexMesh mirrored = sheared();
  for (HexMesh::Cell &cell : mirrored.cells)
    mirror(cell);
  Triangulation<3> mesh;
  read(mirrored.gmsh2(), mesh);
  expect_sheared(mesh);

  HexMesh mixed = sheared();
  mirror(mixed.cells[1]);
  Triangulation<3> other;
  read(mixed.gmsh2(), other);
  expect_sheared(other);
}



TEST(MeshFile3d, NewNodesLieOnCylindersAndSpheres)
{
  Triangulation<3> mesh;
  read(tube().gmsh2(),
       mesh,
       "1 = inside ; 2 = outside",
       "inside : 0, 0 : 1 ; outside : 0, 0 : 2");
  mesh.refine_global(2);
  for (const auto &cell : mesh.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() != 0)
        for (const unsigned int v : face->vertex_indices())
        {
          const Point<3> x = face->vertex(v);
          EXPECT_NEAR(std::hypot(x[0], x[1]), 1. * face->boundary_id(), 1e-12);
        }

  // the cube in a sphere
  const HexMesh    cube = unit_cubes(1, 1);
  Triangulation<3> ball;
  const double     radius = std::sqrt(0.75);
  read(cube.gmsh2(),
       ball,
       names,
       "bottom : 0.5, 0.5, 0.5 : " + std::to_string(radius));
  ball.refine_global(1);
  for (const auto &cell : ball.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == 1)
        for (const unsigned int v : face->vertex_indices())
        {
          // six digits are in the text
          EXPECT_NEAR(face->vertex(v).distance({0.5, 0.5, 0.5}), radius, 1e-6);
        }
}



TEST(MeshFile3d, Distributed)
{
  dealii::parallel::distributed::Triangulation<3> mesh(MPI_COMM_WORLD);
  mesh_file<3>({written(sheared().gmsh2()), names, ""})->create(mesh);
  mesh.refine_global(1);
  EXPECT_EQ(mesh.n_global_active_cells(), 48u);
  EXPECT_NEAR(dealii::GridTools::volume(mesh), 12., 1e-12);
}



TEST(MeshFile3d, FilesOfTheOtherDimension)
{
  const std::string quadrilateral =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n"
    "3 1 1 0\n4 0 1 0\n$EndNodes\n$Elements\n1\n1 3 2 1 1 1 2 3 4\n"
    "$EndElements\n";
  const std::string abaqus = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n"
                             "4, 0, 1, 0\n*ELEMENT, TYPE=CPE4\n"
                             "1, 1, 2, 3, 4\n";
  const std::string ucd    = "4 1 0 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
                             "1 0 quad 1 2 3 4\n";
  for (const std::string &text : {quadrilateral, abaqus, ucd})
  {
    const std::string message = message_about<3>(text);
    expect_in("Geometry/Dimension is 3", message);
    expect_in("quadrilaterals", message);
  }
  const HexMesh cube = unit_cubes(1, 1);
  for (const std::string &text : {cube.gmsh2(), cube.abaqus(), cube.ucd()})
  {
    const std::string message = message_about<2>(text);
    expect_in("Geometry/Dimension is 2", message);
    expect_in("three-dimensional", message);
  }
}



TEST(MeshFile3d, BrokenContents)
{
  const HexMesh cubes = unit_cubes(2, 1);
  const auto    with  = [&](const auto &change, const std::string &named = "") {
    HexMesh changed = cubes;
    change(changed);
    return message_about<3>(changed.gmsh2(), named);
  };
  expect_in("does not list",
            with([](HexMesh &mesh) { mesh.cells[0].corners[3] = 98; }));
  expect_in("degenerate or twisted",
            with([](HexMesh &mesh) { mesh.nodes[0] = mesh.nodes[1]; }));
  expect_in("degenerate or twisted", with([](HexMesh &mesh) {
              std::swap(mesh.cells[0].corners[6], mesh.cells[0].corners[7]);
            }));
  // x = 1, between the cells
  expect_in("line or face inside the domain",
            with(
              [](HexMesh &mesh) {
                mesh.faces.push_back({{{1, 4, 10, 7}}, 3, 0, 4});
              },
              "3 = between"));
  const auto replaced = [&](const std::string &from, const std::string &to) {
    std::string text = cubes.gmsh2();
    text.replace(text.find(from), from.size(), to);
    return message_about<3>(text);
  };
  expect_in("broken element", replaced(" 5 2 7 7 1", " 5 2 7 7"));
  expect_in("broken element", replaced(" 5 2 7 7", " 4 2 7 7"));
  expect_in("broken element", replaced(" 5 2 7 7", " 12 2 7 7"));
  expect_in("type 92", replaced(" 5 2 7 7", " 92 2 7 7"));
  expect_in("says it has", replaced("$Elements\n6", "$Elements\n7"));

  const std::string abaqus = cubes.abaqus();
  expect_in("tetrahedra",
            message_about<3>("*NODE\n1, 0, 0, 0\n*ELEMENT, TYPE=C3D4\n"
                             "1, 1, 1, 1, 1\n"));
  expect_in("broken side",
            message_about<3>(abaqus + "*SURFACE, NAME=SS3\n1, S7\n"));
  expect_in("broken node",
            message_about<3>("*NODE\n1, 0, 0\n*ELEMENT, TYPE=C3D8\n"));
  expect_in("12 (up)", message_about<3>(abaqus, "12 = up"));
}



TEST(MeshFile3d, WrongEntries)
{
  const auto problem = [](const FileEntries &entries) -> std::string {
    try
    {
      mesh_file<3>(entries)->check();
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  };
  const std::string file = written(tube().gmsh2());
  EXPECT_EQ(problem({file, "1 = a", "a : 0, 0 : 1"}), "");
  EXPECT_EQ(problem({file, "1 = a", "a : 0, 0, 0 : 1"}), "");
  expect_in("2 (cylinder) or 3 (sphere)",
            problem({file, "1 = a", "a : 0 : 1"}));
  Triangulation<3> mesh;
  try
  {
    read(tube().gmsh2(), mesh, "1 = inside", "inside : 0, 0 : 2");
    ADD_FAILURE();
  }
  catch (const InputError &error)
  {
    expect_in("1 mm from the axis, not 2 mm", error.what());
  }
}
