// SPDX-License-Identifier: GPL-2.0-or-later
// Names of boundaries in mesh files of hexahedra, as the files have them.
#include <gtest/gtest.h>

#include "hex_meshes.h"
#include "mesh_files.h"

using namespace GeometryTests;
using dealii::Triangulation;

namespace
{
  // Six unit cubes: 3 in x, 2 in y, 1 in z.
  HexMesh
  cubes()
  {
    return unit_cubes(3, 2);
  }

  std::string
  replaced(std::string text, const std::string &old, const std::string &by)
  {
    const auto at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), by);
  }

  // The area of the boundary @p name, -1 where there is none.
  double
  area(const std::string &text,
       const std::string &name,
       const std::string &names = "")
  {
    const auto       geometry = mesh_file<3>({written(text), names, ""});
    Triangulation<3> mesh;
    geometry->create(mesh);
    const auto ids = geometry->boundary_ids();
    if (ids.count(name) == 0)
      return -1.;
    double result = 0.;
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary() && ids.at(name).contains(face->boundary_id()))
        result += face->measure();
    return result;
  }
} // namespace



TEST(MeshFileNames3d, PhysicalNamesOfGmsh2)
{
  const std::string text = replaced(cubes().gmsh2(),
                                    "$Nodes",
                                    "$PhysicalNames\n3\n2 1 \"the foot\"\n"
                                    "2 2 \"lid\"\n3 7 \"steel\"\n"
                                    "$EndPhysicalNames\n$Nodes");
  EXPECT_NEAR(area(text, "the foot"), 3., 1e-12);
  EXPECT_NEAR(area(text, "lid"), 3., 1e-12);
  EXPECT_EQ(area(text, "steel"), -1.); // of cells
  EXPECT_NEAR(area(text, "roof", "lid = roof"), 3., 1e-12);
  EXPECT_EQ(area(text, "lid", "lid = roof"), -1.);
  EXPECT_NEAR(area(text, "the foot", "2 = roof"), 3., 1e-12);
}



TEST(MeshFileNames3d, PhysicalNamesOfGmsh4)
{
  // one cube; surface 1 below, in two groups, and surface 2 above
  const std::string text =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 4 \"foot\"\n"
    "2 5 \"held\"\n2 6 \"lid\"\n$EndPhysicalNames\n"
    "$Entities\n0 0 2 1\n1 0 0 0 2 3 0 2 4 5 0\n2 0 0 1 2 3 1 1 6 0\n"
    "1 0 0 0 2 3 1 0 2 1 2\n$EndEntities\n$Nodes\n1 8 1 8\n3 1 0 8\n"
    "1\n2\n3\n4\n5\n6\n7\n8\n0 0 0\n2 0 0\n2 3 0\n0 3 0\n0 0 1\n2 0 1\n"
    "2 3 1\n0 3 1\n$EndNodes\n$Elements\n3 3 1 3\n2 1 3 1\n1 1 2 3 4\n"
    "2 2 3 1\n2 5 6 7 8\n3 1 5 1\n3 1 2 3 4 5 6 7 8\n$EndElements\n";
  for (const std::string name : {"foot", "held", "lid"})
    EXPECT_NEAR(area(text, name), 6., 1e-12) << name;
}



TEST(MeshFileNames3d, SurfacesAndSetsOfAbaqus)
{
  // nodes are counted along x, then y, then z: 12 at z = 0 and 12 at z = 1
  const std::string text =
    cubes().abaqus() +
    "*NSET, NSET=Back side, GENERATE\n1, 12, 1\n*NSET, NSET=left\n1, 5, 9, 13, "
    "17, 21\n*NSET, NSET=corner\n1\n*NSET, NSET=edge\n1, 2, 3, 4\n";
  EXPECT_NEAR(area(text, "SS1"), 3., 1e-12);
  EXPECT_NEAR(area(text, "SS2"), 3., 1e-12);
  EXPECT_NEAR(area(text, "Back side"), 6., 1e-12);
  EXPECT_NEAR(area(text, "left"), 2., 1e-12);
  // points and lines have no face
  EXPECT_EQ(area(text, "corner"), -1.);
  EXPECT_EQ(area(text, "edge"), -1.);
  EXPECT_NEAR(area(text, "roof", "SS2 = roof"), 3., 1e-12);
}



// UCD has numbers only: they are named in the .prm.
TEST(MeshFileNames3d, NumbersOfUcd)
{
  const std::string text = cubes().ucd();
  EXPECT_NEAR(area(text, "foot", "1 = foot ; 2 = lid"), 3., 1e-12);
  EXPECT_NEAR(area(text, "lid", "1 = foot ; 2 = lid"), 3., 1e-12);
  EXPECT_NEAR(area(text, "sides", "0 = sides ; 2 = lid"), 16., 1e-12);
  for (const std::string key : {"3", "foot"})
    try
    {
      area(text, "a", key + " = a");
      ADD_FAILURE() << "accepted: " << key;
    }
    catch (const InputError &error)
    {
      const std::string message = error.what();
      EXPECT_NE(message.find("Geometry/Mesh file/"), std::string::npos);
      EXPECT_NE(message.find("0, 1, 2"), std::string::npos) << message;
    }
}
