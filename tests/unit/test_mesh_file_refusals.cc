// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "mesh_files.h"

using namespace GeometryTests;

namespace
{
  // The message of the InputError that making a mesh of this text throws
  std::string
  message_about(const std::string &text, const std::string &names = "")
  {
    dealii::Triangulation<2> triangulation;
    try
    {
      mesh_file({written(text), names, ""})->create(triangulation);
    }
    catch (const InputError &error)
    {
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message;
    }
    ADD_FAILURE() << "accepted: " << text.substr(0, 200);
    return "";
  }

  std::string
  problem_of_entries(const FileEntries &entries)
  {
    try
    {
      mesh_file(entries)->check();
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }

  void
  expect_in(const std::string &part, const std::string &whole)
  {
    EXPECT_NE(whole.find(part), std::string::npos)
      << "'" << part << "' is not in: " << whole;
  }

  std::string
  gmsh(const std::string &nodes, const std::string &elements)
  {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + nodes +
           "$EndNodes\n$Elements\n" + elements + "$EndElements\n";
  }

  const std::string four_nodes = "4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n";
  const std::string one_quad   = "1\n1 3 2 1 1 1 2 3 4\n";
} // namespace



TEST(MeshFile, UnreadableFilesAreFileErrors)
{
  dealii::Triangulation<2> triangulation;
  for (const std::string path : {"/nonexistent/mesh.msh", "/tmp"})
    try
    {
      mesh_file({path, "", ""})->create(triangulation);
      ADD_FAILURE() << path;
    }
    catch (const FileError &error)
    {
      expect_in("Geometry/Mesh file/File name", error.what());
      expect_in(path, error.what());
    }
}



TEST(MeshFile, BrokenContents)
{
  expect_in("is empty", message_about(""));
  expect_in("is empty", message_about("  \n \n"));
  expect_in("Geometry/Mesh file/File name", message_about(""));
  expect_in("binary",
            message_about(std::string("\x7f"
                                      "ELF\0\1\2\3",
                                      8)));
  expect_in("neither", message_about("once upon a time\n"));
  expect_in("no section $MeshFormat", message_about("$Foo\n"));
  expect_in("triangles",
            message_about(gmsh(four_nodes, "1\n1 2 2 1 1 1 2 3\n")));
  expect_in("three-dimensional",
            message_about(gmsh(four_nodes, "1\n1 4 2 1 1 1 2 3 4\n")));
  expect_in("no quadrilaterals",
            message_about(gmsh(four_nodes, "1\n1 1 2 1 1 1 2\n")));
  expect_in("type 26", message_about(gmsh(four_nodes, "1\n1 26 2 1 1 1 2\n")));
  expect_in("does not list",
            message_about(gmsh(four_nodes, "1\n1 3 2 1 1 1 2 3 99\n")));
  expect_in("says it has",
            message_about(gmsh("4000000000\n1 0 0 0\n", one_quad)));
  expect_in("says it has", message_about(gmsh(four_nodes, "7\n1 3 2 1 1\n")));
  expect_in("broken node",
            message_about(gmsh("1\n1 0 nonsense 0\n", one_quad)));
  expect_in("broken element",
            message_about(gmsh(four_nodes, "1\n1 3 9 1 1 1 2 3 4\n")));
  const std::string whole = gmsh(four_nodes, one_quad);
  expect_in("ends before", message_about(whole.substr(0, whole.size() - 14)));
  expect_in("binary Gmsh",
            message_about("$MeshFormat\n4.1 1 8\n$EndMeshFormat\n"));
  expect_in(
    "not commas",
    message_about(gmsh("4\n1 0 0 0\n2 1,5 0 0\n3 1 1 0\n4 0 1 0\n", one_quad)));
  expect_in("decimal commas",
            message_about("*NODE\n1, 0,25, 0,5, 0,0\n*ELEMENT\n"));
  expect_in("a STEP file", message_about("ISO-10303-21;\nHEADER;\n"));
  expect_in("an STL file", message_about("solid part\nfacet normal 0 0 1\n"));
  expect_in("HDF5", message_about("\x89HDF\r\n\x1a\n"));
  expect_in("XML", message_about("<?xml version=\"1.0\"?>\n<VTKFile>\n"));
  expect_in("script of Gmsh", message_about("// a\nPoint(1) = {0, 0, 0};\n"));
  expect_in("versions", message_about("$MeshFormat\n9 0 8\n$EndMeshFormat\n"));
  expect_in(
    "degenerate",
    message_about(gmsh("4\n1 0 0 0\n2 0 0 0\n3 0 0 0\n4 0 0 0\n", one_quad)));
  expect_in("without *NODE", message_about("*HEADING\nfoo\n"));
  expect_in("triangles",
            message_about("*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n"
                          "*ELEMENT, TYPE=S3\n1, 1, 2, 3\n"));
  expect_in("three-dimensional",
            message_about("*NODE\n1, 0, 0\n*ELEMENT, TYPE=C3D8\n1, 1\n"));
  expect_in("broken element",
            message_about("*NODE\n1, 0, 0\n*ELEMENT\nfoo bar\n"));
  expect_in("does not list",
            message_about("*NODE\n1, 0, 0, 0\n*ELEMENT\n1, 1, 2, 3, 4\n"));
  const std::string abaqus =
    "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n*ELEMENT\n";
  expect_in(
    "element 2, which it does not list",
    message_about(abaqus + "1, 1, 2, 3, 4\n*SURFACE, NAME=SS1\n2, S1\n"));
  expect_in(
    "broken side",
    message_about(abaqus + "1, 1, 2, 3, 4\n*SURFACE, NAME=SS1\n1, S7\n"));
  expect_in("says it has", message_about("400000000 3 0 0 0\n"));
  expect_in("triangles (element 1)",
            message_about("3 1 0 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n"
                          "1 0 tri 1 2 3\n"));
  expect_in("type 'tri6'",
            message_about("3 1 0 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n"
                          "1 0 tri6 1 2 3\n"));
}



TEST(MeshFile, BoundariesThatAreNotThere)
{
  const std::string message =
    message_about(gmsh(four_nodes, one_quad), "12 = top");
  expect_in("Geometry/Mesh file/Boundary names", message);
  expect_in("12 (top)", message);
  expect_in("has the ids 0", message);
}



TEST(MeshFile, WrongEntries)
{
  EXPECT_EQ(problem_of_entries(plate), "");
  const std::string file = plate.file_name; // circles need its boundaries
  expect_in("File name", problem_of_entries({"", "", ""}));
  expect_in("id = name", problem_of_entries({"x", "1 bottom", ""}));
  expect_in("no integer", problem_of_entries({"x", "-1 = bottom", ""}));
  expect_in("two names", problem_of_entries({"x", "1 = a ; 1 = b", ""}));
  expect_in("two boundary ids", problem_of_entries({"x", "1 = a ; 2 = a", ""}));
  expect_in("name : x, y : radius",
            problem_of_entries({file, "1 = a", "a : 3"}));
  expect_in("unknown 'b'", problem_of_entries({file, "1 = a", "b : 0, 0 : 1"}));
  expect_in("needs 2", problem_of_entries({file, "1 = a", "a : 0 : 1"}));
  expect_in("greater than 0",
            problem_of_entries({file, "1 = a", "a : 0, 0 : 0"}));

  FileEntries wrong_circle = plate;
  wrong_circle.circles     = "hole : 10, 10 : 5";
  dealii::Triangulation<2> triangulation;
  try
  {
    mesh_file(wrong_circle)->create(triangulation);
    ADD_FAILURE();
  }
  catch (const InputError &error)
  {
    expect_in("not 5 mm", error.what());
  }
}
