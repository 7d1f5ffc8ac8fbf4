// SPDX-License-Identifier: GPL-2.0-or-later
// Mesh files as programs write them: groups, sets and surfaces by number and by
// name, byte order marks, inner lines, lines of other dimensions.
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include "mesh_files.h"

using namespace GeometryTests;
using dealii::Triangulation;

namespace
{
  // Two squares of unit size side by side; nodes 1 to 6 are (0,0), (1,0),
  // (2,0), (0,1), (1,1), (2,1).
  const std::string nodes =
    "6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n";

  std::string
  gmsh2(const std::string &elements)
  {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n"
           "1 1 \"left edge\"\n1 4 \"all outer\"\n$EndPhysicalNames\n$Nodes\n" +
           nodes + "$EndNodes\n$Elements\n" + elements + "$EndElements\n";
  }

  const std::string two_cells = "11 3 2 7 1 1 2 5 4\n12 3 2 7 1 2 3 6 5\n";

  // The entities: curve 1 at the left in the groups @p groups_of_left, curve 2
  // between the cells in @p groups_inside, both cells in surface 1
  std::string
  gmsh4(const std::string &groups_of_left,
        const std::string &groups_inside,
        const std::string &groups_of_cells = "1 7",
        const bool         parametric      = false)
  {
    const std::string more = parametric ? " 0.25 0.5\n" : "\n";
    return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n"
           "1 1 \"left edge\"\n2 7 \"steel\"\n$EndPhysicalNames\n"
           "$Entities\n0 2 1 0\n1 0 0 0 0 1 0 " +
           groups_of_left + " 2 4 -1 \n2 1 0 0 1 1 0 " + groups_inside +
           " 0 \n1 0 0 0 2 1 0 " + groups_of_cells +
           " 0 \n$EndEntities\n$Nodes\n1 6 1 6\n2 1 " +
           (parametric ? "1" : "0") + " 6\n1\n2\n3\n4\n5\n6\n0 0 0" + more +
           "1 0 0" + more + "2 0 0" + more + "0 1 0" + more + "1 1 0" + more +
           "2 1 0" + more + "$EndNodes\n$Elements\n3 4 1 4\n1 1 1 1\n1 4 1 \n" +
           "1 2 1 1\n2 2 5 \n2 1 3 2\n3 1 2 5 4 \n4 2 3 6 5 \n$EndElements\n";
  }

  const std::string abaqus =
    "*Heading\n two squares\n*NODE\n1, 0, 0\n2, 1, 0\n3, 2, 0\n4, 0, 1\n5, 1, "
    "1\n6, 2, 1\n";

  void
  read(const std::string &text,
       Triangulation<2>  &triangulation,
       const std::string &names = "")
  {
    mesh_file({written(text), names, ""})->create(triangulation);
    EXPECT_EQ(triangulation.n_active_cells(), 2u);
    EXPECT_NEAR(dealii::GridTools::volume(triangulation), 2., 1e-12);
  }

  // The length of the boundary that is called "it"
  double
  length_of(const std::string &text, const std::string &key)
  {
    const auto       geometry = mesh_file({written(text), key + " = it", ""});
    Triangulation<2> triangulation;
    geometry->create(triangulation);
    return boundary_length(triangulation, geometry->boundary_ids().at("it"));
  }

  std::string
  refusal(const std::string &text, const std::string &names = "")
  {
    Triangulation<2> triangulation;
    try
    {
      mesh_file({written(text), names, ""})->create(triangulation);
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    ADD_FAILURE() << "accepted: " << text;
    return "";
  }

  void
  expect_in(const std::string &part, const std::string &whole)
  {
    EXPECT_NE(whole.find(part), std::string::npos)
      << "'" << part << "' is not in: " << whole;
  }
} // namespace



TEST(MeshFileGroups, ACurveInTwoGroupsHasBothNames)
{
  // all of the outside in group 4, the left edge in group 1 as well
  const std::string text = gmsh2("9\n1 1 2 1 1 1 4\n2 1 2 4 1 1 4\n"
                                 "3 1 2 4 2 1 2\n4 1 2 4 3 2 3\n5 1 2 4 4 3 6\n"
                                 "6 1 2 4 5 6 5\n7 1 2 4 6 5 4\n" +
                                 two_cells);
  EXPECT_NEAR(length_of(text, "1"), 1., 1e-12);
  EXPECT_NEAR(length_of(text, "4"), 6., 1e-12);
  EXPECT_NEAR(length_of(text, "left edge"), 1., 1e-12);
  EXPECT_NEAR(length_of(text, "All Outer"), 6., 1e-12);
  const auto both = mesh_file({written(text), "1 = left ; 4 = outside", ""});
  Triangulation<2> triangulation;
  both->create(triangulation);
  const auto ids = both->boundary_ids();
  EXPECT_NEAR(boundary_length(triangulation, ids.at("left")), 1., 1e-12);
  EXPECT_NEAR(boundary_length(triangulation, ids.at("outside")), 6., 1e-12);
}



TEST(MeshFileGroups, TheSameInGmsh4)
{
  EXPECT_NEAR(length_of(gmsh4("2 1 4", "0"), "1"), 1., 1e-12);
  EXPECT_NEAR(length_of(gmsh4("2 1 4", "0"), "4"), 1., 1e-12);
  EXPECT_NEAR(length_of(gmsh4("1 -1", "0"), "left edge"), 1., 1e-12);
  Triangulation<2> both;
  read(gmsh4("2 1 4", "0"), both, "1 = a ; 4 = b");
}



TEST(MeshFileGroups, ACellInTwoGroupsIsRefused)
{
  const std::string message = refusal(gmsh4("1 1", "0", "2 7 8"));
  expect_in("two physical groups, 7 ('steel') and 8", message);
  expect_in("one material", message);
  expect_in("materials 7 and 8",
            refusal(gmsh2("3\n" + two_cells + "13 3 2 8 1 2 3 6 5\n")));
}



TEST(MeshFileGroups, ParametricCoordinatesAreSkipped)
{
  Triangulation<2> gmsh41, gmsh22;
  read(gmsh4("1 1", "0", "1 7", true), gmsh41, "1 = left");
  EXPECT_EQ(gmsh41.begin_active()->material_id(), 7u);
  std::string text = gmsh2("2\n" + two_cells);
  for (const std::string word : {"$Nodes", "$EndNodes"})
    text.replace(text.find(word),
                 word.size(),
                 word == "$Nodes" ? "$ParametricNodes" : "$EndParametricNodes");
  text.replace(text.find("2 1 0 0"), 7, "2 1 0 0 2 1 0.25 0.5");
  read(text, gmsh22);
}



TEST(MeshFileGroups, InnerLinesMatterOnlyWhenTheyAreNamed)
{
  Triangulation<2> without_group, without_name;
  read(gmsh4("1 1", "0"), without_group, "1 = left");
  read(gmsh4("1 1", "1 2"), without_name, "1 = left");
  expect_in(
    "2 (seam) has a line or face inside the domain, with the nodes 2, 5",
    refusal(gmsh4("1 1", "1 2"), "1 = left ; 2 = seam"));
  expect_in("belongs to no cell, with the nodes 1, 6",
            refusal(gmsh2("3\n1 1 2 3 1 1 6\n" + two_cells), "3 = diagonal"));
}



TEST(MeshFileGroups, ByteOrderMarksAndLineEnds)
{
  const std::string mark = "\xEF\xBB\xBF";
  const std::string gmsh = gmsh2("2\n" + two_cells);
  const std::string inp  = abaqus + "*ELEMENT\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n";
  for (const std::string &text : {gmsh, inp})
  {
    Triangulation<2> marked, windows, old;
    read(mark + text, marked);
    std::string with_returns, only_returns = text;
    for (const char c : text)
      with_returns += c == '\n' ? std::string("\r\n") : std::string(1, c);
    std::replace(only_returns.begin(), only_returns.end(), '\n', '\r');
    read(with_returns, windows);
    read(only_returns, old);
  }
  expect_in("UTF-16", refusal("\xFF\xFE$\1M\1"));
}



TEST(MeshFileGroups, AbaqusLinesBesideTheCellsNameBoundaries)
{
  // as Gmsh writes it: numbers go through all elements
  const std::string text =
    abaqus +
    "******* E L E M E N T S *************\n"
    "*ELEMENT, type=T3D2, ELSET=Line4\n1, 4, 1\n"
    "*ELEMENT, type=T3D2, ELSET=Line9\n2, 2, 5\n"
    "*ELEMENT, type=CPS4, ELSET=Surface1\n3, 1, 2, 5, 4\n4, 2, 3, 6, 5\n"
    "*ELSET,ELSET=left_edge\n1, \n*ELSET,ELSET=steel\n3, 4, \n";
  EXPECT_NEAR(length_of(text, "left_edge"), 1., 1e-12);
  EXPECT_NEAR(length_of(text, "LINE4"), 1., 1e-12);
  expect_in("the ids 0 and the names 'Line4', 'left_edge'",
            refusal(text, "1 = left"));
  expect_in("inside the domain", refusal(text, "Line9 = seam"));
  expect_in("steel", refusal(text, "steel = body"));
}



TEST(MeshFileGroups, AbaqusSurfacesAndSetsOfAPart)
{
  const std::string text =
    "*Heading\n*Part, name=Plate\n*Node\n10, 0, 0\n20, 1, 0\n30, 2, 0\n"
    "40, 0, 1\n50, 1, 1\n60, 2, 1\n*Element, type=CPE4R\n"
    "101, 10, 20, 50, 40\n205, 20, 30, 60, 50\n"
    "*Nset, nset=base, generate\n10, 30, 10\n"
    "*Solid Section, elset=All, material=Rubber-3\n,\n*End Part\n"
    "*Assembly, name=A\n*Instance, name=Plate-1, part=Plate\n*End Instance\n"
    "*Node\n10, 5., 5., 0.\n*Nset, nset=RefPt\n10,\n"
    "*Elset, elset=_Top_S3, internal, instance=Plate-1\n101, 205\n"
    "*Elset, elset=All, instance=Plate-1\n101, 205\n"
    "*Surface, type=ELEMENT, name=TopEdge\n_Top_S3, S3\n"
    "*Surface, type=NODE, name=Foot\nbase,\n"
    "*Surface, type=ELEMENT, name=SS2\n205, S2\n*End Assembly\n";
  EXPECT_NEAR(length_of(text, "TopEdge"), 2., 1e-12);
  EXPECT_NEAR(length_of(text, "base"), 2., 1e-12);
  EXPECT_NEAR(length_of(text, "Foot"), 2., 1e-12);
  EXPECT_NEAR(length_of(text, "2"), 1., 1e-12);
  Triangulation<2> mesh, mesh_with_other;
  read(text, mesh);
  EXPECT_EQ(mesh.begin_active()->material_id(), 3u);

  // a part without an instance is not in the body
  read(text + "*Part, name=Other\n*Node\n1, 9, 9\n", mesh_with_other);
  expect_in("uses *NGEN", refusal("*NODE\n1, 0, 0\n*NGEN\n1, 5\n"));
}



TEST(MeshFileGroups, PlanesAndFlatCornersAreNamed)
{
  const std::string cell = "*ELEMENT, TYPE=CPS4\n7, 1, 2, 3, 4\n";
  expect_in("lies in the x-z plane (y = 0.5",
            refusal("*NODE\n1, 0, 0.5, 0\n2, 1, 0.5, 0\n3, 1, 0.5, 1\n"
                    "4, 0, 0.5, 1\n" +
                    cell));
  expect_in(
    "is not flat",
    refusal("*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 1\n4, 0, 1, 0\n" + cell));
  expect_in("element 7 has a corner of 180 degrees at node 3",
            refusal("*NODE\n1, 0, 0\n2, 1, 0\n3, 0.5, 0.5\n4, 0, 1\n" + cell));
  expect_in("element 7 has two corners at one place, at node 2",
            refusal("*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 0\n4, 0, 1\n" + cell));
  expect_in("element 7 is twisted",
            refusal("*NODE\n1, 0, 0\n2, 1, 1\n3, 1, 0\n4, 0, 1\n" + cell));
  expect_in("elements of 7 nodes (type CPS8)",
            refusal("*NODE\n1, 0, 0\n*ELEMENT, TYPE=CPS8\n"
                    "1, 1, 1, 1, 1, 1, 1, 1\n"));
  expect_in("three cells at one face, with the nodes 2, 5",
            refusal(abaqus + "7, 1.5, 0\n8, 1.5, 1\n*ELEMENT\n1, 1, 2, 5, 4\n"
                             "2, 2, 3, 6, 5\n3, 2, 7, 8, 5\n"));
}



TEST(MeshFileGroups, WhatTheFileCallsItsBoundariesIsInTheHint)
{
  const auto hint = [](const std::string &text) {
    return mesh_file({written(text), "", ""})->hint_about_boundaries();
  };
  expect_in("has the ids 0; Geometry/Mesh file/Boundary names gives them names",
            hint(gmsh2("2\n" + two_cells)));
  expect_in("has the ids 0, 1 ('left edge');", hint(gmsh4("1 1", "1 2")));
  expect_in("Boundary names", hint("nonsense"));
}
