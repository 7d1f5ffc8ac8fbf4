// SPDX-License-Identifier: GPL-2.0-or-later
// Parts and instances of Abaqus, continued lines, VTK.
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include "mesh_files.h"

using namespace GeometryTests;
using dealii::Triangulation;

namespace
{
  // A square of unit size with two cells one above the other; S4 of both is at
  // the left, S2 at the right
  const std::string part =
    "*HEADING\n*PART, NAME=Block\n*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 0.5\n"
    "4, 1, 0.5\n5, 0, 1\n6, 1, 1\n*ELEMENT, TYPE=CPS4, ELSET=all\n"
    "1, 1, 2, 4, 3\n2, 3, 4, 6, 5\n*NSET, NSET=base\n1, 2\n"
    "*SURFACE, NAME=right\nall, S2\n*SURFACE, NAME=left\nall, S4\n"
    "*END PART\n*ASSEMBLY, NAME=A\n";

  std::string
  instance(const std::string &name, const std::string &place)
  {
    return "*INSTANCE, NAME=" + name + ", PART=block\n" + place +
           "*END INSTANCE\n";
  }

  const std::string tie = "*TIE, NAME=T\nTwo.left, One.right\n";

  struct Read
  {
    std::string                  problem;
    Triangulation<2>             mesh;
    MixedCracks::NamedBoundaries ids;

    explicit Read(const std::string &text, const std::string &names = "")
    {
      const auto geometry = mesh_file({written(text), names, ""});
      try
      {
        geometry->create(mesh);
        ids = geometry->boundary_ids();
      }
      catch (const InputError &error)
      {
        problem = error.what();
      }
    }
  };

  void
  expect_in(const std::string &part, const std::string &whole)
  {
    EXPECT_NE(whole.find(part), std::string::npos)
      << "'" << part << "' is not in: " << whole;
  }
} // namespace



TEST(MeshFileBodies, OneInstanceMovedAndTurned)
{
  // first (2, 0), then 90 degrees about (2, 0)
  const Read read(part + instance("I", "2, 0, 0\n2, 0, 0, 2, 0, 1, 90\n") +
                    "*NSET, NSET=tip, INSTANCE=I\n5, 6\n*END ASSEMBLY\n",
                  "base = bottom ; I.right = r");
  expect_in("not in the file", read.problem); // one instance: plain names
  const Read again(part + instance("I", "2, 0, 0\n2, 0, 0, 2, 0, 1, 90\n") +
                     "*NSET, NSET=tip, INSTANCE=I\n5, 6\n*END ASSEMBLY\n",
                   "base = bottom ; tip = top");
  ASSERT_EQ(again.problem, "");
  const auto box = dealii::GridTools::compute_bounding_box(again.mesh);
  EXPECT_NEAR(box.get_boundary_points().first[0], 1., 1e-12);
  EXPECT_NEAR(box.get_boundary_points().second[0], 2., 1e-12);
  EXPECT_NEAR(box.get_boundary_points().second[1], 1., 1e-12);
  EXPECT_NEAR(boundary_length(again.mesh, again.ids.at("bottom")), 1., 1e-12);
  for (const auto &face : again.mesh.active_face_iterators())
    if (face->at_boundary() &&
        again.ids.at("top").contains(face->boundary_id()))
    {
      EXPECT_NEAR(face->center()[0], 1., 1e-12);
    }
}



TEST(MeshFileBodies, TwoInstancesTied)
{
  const Read read(part + instance("One", "") + instance("Two", "1, 0, 0\n") +
                    "*END ASSEMBLY\n" + tie,
                  "One.left = l ; Two.right = r ; Two.base = b");
  ASSERT_EQ(read.problem, "");
  EXPECT_EQ(read.mesh.n_active_cells(), 4u);
  EXPECT_EQ(read.mesh.n_vertices(), 9u);
  EXPECT_NEAR(boundary_length(read.mesh, read.ids.at("l")), 1., 1e-12);
  EXPECT_NEAR(boundary_length(read.mesh, read.ids.at("r")), 1., 1e-12);
  EXPECT_NEAR(boundary_length(read.mesh, read.ids.at("b")), 1., 1e-12);
}



// Plates of n x n cells, one on the other: all of the nodes that are tied have
// one z, and many of them one x.
TEST(MeshFileBodies, TenThousandNodesTied)
{
  constexpr unsigned int n    = 100;
  const auto             node = [](unsigned int i, unsigned int j, int k) {
    return std::to_string(1 + i + (n + 1) * (j + (n + 1) * k));
  };
  std::ostringstream text;
  text << "*HEADING\n*PART, NAME=Plate\n*NODE\n";
  for (int k = 0; k < 2; ++k)
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        text << node(i, j, k) << ", " << i << ", " << j << ", " << k << '\n';
  text << "*ELEMENT, TYPE=C3D8, ELSET=all\n";
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
    {
      text << 1 + i + n * j;
      for (int k = 0; k < 2; ++k)
        text << ", " << node(i, j, k) << ", " << node(i + 1, j, k) << ", "
             << node(i + 1, j + 1, k) << ", " << node(i, j + 1, k);
      text << '\n';
    }
  text << "*SURFACE, NAME=low\nall, S1\n*SURFACE, NAME=high\nall, S2\n"
       << "*END PART\n*ASSEMBLY, NAME=A\n";
  for (const char *const place :
       {"One, PART=Plate\n", "Two, PART=Plate\n0,0,1\n"})
    text << "*INSTANCE, NAME=" << place << "*END INSTANCE\n";
  const auto read = [&](const std::string &tied, Triangulation<3> &mesh) {
    const auto geometry =
      mesh_file<3>({written(text.str() + "*END ASSEMBLY\n" + tied), "", ""});
    geometry->create(mesh);
    return geometry->boundary_ids();
  };
  Triangulation<3> mesh;
  const auto       ids = read("*TIE, NAME=T\nTwo.low, One.high\n", mesh);
  EXPECT_EQ(mesh.n_active_cells(), 2 * n * n);
  EXPECT_EQ(mesh.n_vertices(), 3 * (n + 1) * (n + 1));
  unsigned int n_outer = 0, n_low = 0;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
    {
      ++n_outer;
      n_low += ids.at("One.low").contains(face->boundary_id());
    }
  EXPECT_EQ(n_outer, 2 * n * n + 8 * n);
  EXPECT_EQ(n_low, n * n);
}



TEST(MeshFileBodies, RefusedOnes)
{
  const std::string one = part + instance("One", "");
  expect_in("touch at nodes", Read(one + instance("Two", "1, 0, 0\n")).problem);
  expect_in("meets none of the second",
            Read(one + instance("Two", "1, 0.25, 0\n") + tie).problem);
  expect_in("place of an instance",
            Read(part + instance("One", "1, 2, 3, 4\n")).problem);
  expect_in("no length",
            Read(part + instance("One", "0,0,0\n1,1,1,1,1,1,30\n")).problem);
  expect_in("two instances with the name",
            Read(one + instance("one", "5, 0\n")).problem);
  expect_in("does not list",
            Read(part + "*INSTANCE, NAME=x, PART=y\n*END INSTANCE\n").problem);
  expect_in(
    "no *INSTANCE",
    Read("*PART, NAME=a\n*END PART\n*PART, NAME=b\n*END PART\n").problem);
}



TEST(MeshFileBodies, ElementsOnTwoLines)
{
  const Read read("*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n"
                  "*ELEMENT, TYPE=CPS8\n1, 1, 2, 3, 4,\n5, 6, 7, 8\n");
  EXPECT_EQ(read.problem, "");
  EXPECT_EQ(read.mesh.n_active_cells(), 1u);
}



TEST(MeshFileBodies, LegacyVtk)
{
  const std::string points = "\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                             "POINTS 6 float\n0 0 0 1 0 0 2 0 0\n0 1 0 1 1 0 "
                             "2 1 0\n";
  const std::string data   = "CELL_TYPES 3\n9\n8\n3\nCELL_DATA 3\n";
  const std::string ids    = "5 6 4\n";
  const std::string old    = "# vtk DataFile Version 2.0\n" + points +
                          "CELLS 3 13\n4 0 1 4 3\n4 1 2 4 5\n2 0 3\n" + data;
  const std::string recent =
    "# vtk DataFile Version 5.1\n" + points +
    "CELLS 4 10\nOFFSETS vtktypeint64\n0 4 8 10\nCONNECTIVITY vtktypeint64\n"
    "0 1 4 3 1 2 4 5 0 3\n" +
    data;
  for (const std::string &text :
       {old + "SCALARS MaterialID int 1\nLOOKUP_TABLE default\n" + ids,
        old + "FIELD data 1\nmaterial 1 3 int\n" + ids,
        recent + "FIELD data 1\nmaterial 1 3 int\n" + ids})
  {
    const Read read(text, "4 = left");
    ASSERT_EQ(read.problem, "");
    EXPECT_EQ(read.mesh.n_active_cells(), 2u);
    EXPECT_NEAR(dealii::GridTools::volume(read.mesh), 2., 1e-12);
    EXPECT_NEAR(boundary_length(read.mesh, read.ids.at("left")), 1., 1e-12);
    unsigned int sum = 0;
    for (const auto &cell : read.mesh.active_cell_iterators())
      sum += cell->material_id();
    EXPECT_EQ(sum, 11u);
  }
  expect_in(
    "UNSTRUCTURED_GRID",
    Read("# vtk DataFile Version 2.0\nx\nASCII\nDATASET POLYDATA\n").problem);
  expect_in("CELL_TYPES",
            Read("# vtk DataFile Version 2.0\nx\nASCII\n" + points).problem);
}
