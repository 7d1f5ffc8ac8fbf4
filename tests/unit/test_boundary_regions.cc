// SPDX-License-Identifier: GPL-2.0-or-later
// Names for parts of the boundary and for points by their position.
#include <deal.II/distributed/tria.h>

#include <gtest/gtest.h>

#include "mesh_files.h"

using namespace GeometryTests;
using dealii::Point;
using dealii::Triangulation;

namespace
{
  // Subsection Geometry with these entries
  template <int dim = 2>
  struct Described
  {
    GeometryParameters<dim>  parameters;
    dealii::ParameterHandler prm;

    explicit Described(const Entries &entries,
                       const Entries &in_subsection = {})
    {
      parameters.add_parameters(prm);
      prm.enter_subsection("Geometry");
      for (const auto &[entry, value] : entries)
        prm.set(entry, value);
      std::string name = entries.at("Name");
      name[0]          = static_cast<char>(std::toupper(name[0]));
      prm.enter_subsection(name);
      for (const auto &[entry, value] : in_subsection)
        prm.set(entry, value);
      prm.leave_subsection();
      prm.leave_subsection();
    }
  };

  // a plate of 4 x 2 with cells of 0.5
  const Entries plate_cells = {{"Upper corner", "4, 2"}, {"Cell size", "0.5"}};

  Entries
  rectangle_with(const std::string &regions)
  {
    return {{"Name", "rectangle"}, {"Boundary regions", regions}};
  }

  template <typename Action>
  std::string
  message_of(const Action &action)
  {
    try
    {
      action();
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    ADD_FAILURE() << "accepted";
    return "";
  }

  std::string
  refusal(const Entries &entries, const Entries &in_subsection)
  {
    return message_of([&]() {
      const Described<>        described(entries, in_subsection);
      dealii::Triangulation<2> mesh;
      described.parameters.check();
      described.parameters.chosen().create(mesh);
    });
  }

  void
  expect_part(const std::string &part, const std::string &whole)
  {
    EXPECT_NE(whole.find(part), std::string::npos)
      << "'" << part << "' is not in: " << whole;
  }
} // namespace



TEST(BoundaryRegions, TakeFacesByTheirCentreAndTheLaterWins)
{
  const Described<> described(
    rectangle_with("grip : x > 2.9 && y > 1.9 ; corner : x > 3.6 ; "
                   "ends : x < 1e-6"),
    plate_cells);
  described.parameters.check();
  const Geometry<2> &geometry = described.parameters.chosen();
  Triangulation<2>   mesh;
  geometry.create(mesh);
  const NamedBoundaries ids    = geometry.boundary_ids();
  const auto            length = [&](const std::string &name) {
    return boundary_length(mesh, ids.at(name));
  };
  for (unsigned int level = 0; level < 2; ++level)
  {
    // faces of the top with centres at 3.25 and, but for the corner, 3.75; a
    // limit at 2.9 lies within one that goes by its centre at 2.75
    EXPECT_NEAR(length("grip"), 0.5, 1e-12);
    EXPECT_NEAR(length("corner"), 2. + 0.5 + 0.5, 1e-12);
    EXPECT_NEAR(length("ends"), 2., 1e-12);
    EXPECT_NEAR(length("left"), 0., 1e-12);
    EXPECT_NEAR(length("right"), 0., 1e-12);
    EXPECT_NEAR(length("top"), 3., 1e-12);
    EXPECT_NEAR(length("bottom"), 3.5, 1e-12);
    mesh.refine_global(1);
  }
}



// what decides about cracks does not change
TEST(BoundaryRegions, PartsOfTheBodyKeepTheirNamesForCracks)
{
  const Described<> described(
    Entries({{"Name", "punctured strip"},
             {"Boundary regions",
              "pumped : (x - 12)^2 + (y - 18)^2 < 17 && x > 12 ; "
              "mouth : y > 11 && y < 13 && x < 0.9"}}));
  const Geometry<2> &geometry = described.parameters.chosen();
  Triangulation<2>   mesh;
  geometry.create(mesh);
  const auto                    names = geometry.names_of_ids();
  std::map<std::string, double> length;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
      length[names.at(face->boundary_id())] += face->measure();
  EXPECT_NEAR(length.at("left"), 28., 1e-9);
  EXPECT_NEAR(length.at("notch"), 2., 1e-9);
  EXPECT_EQ(length.count("pumped"), 0u);
  EXPECT_EQ(length.size(), 6u);
  const auto ids = geometry.boundary_ids();
  EXPECT_NEAR(boundary_length(mesh, ids.at("pumped")),
              0.5 * length.at("hole"),
              0.2 * length.at("hole"));
  // both faces of the slit are at one place
  EXPECT_GT(boundary_length(mesh, ids.at("mouth")), 2.);
  EXPECT_EQ(boundary_length(mesh, ids.at("notch lower")), 0.);
}



TEST(BoundaryRegions, InThreeDimensions)
{
  const Described<3> described(
    Entries({{"Name", "slit cube"},
             {"Boundary regions", "patch : z > 0.99 && x < 0.5 && y < 0.5"}}));
  described.parameters.check();
  Triangulation<3> mesh;
  described.parameters.chosen().create(mesh);
  const auto ids = described.parameters.chosen().boundary_ids();
  std::map<std::string, double> area;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
      for (const auto &[name, parts] : ids)
        if (parts.contains(face->boundary_id()))
          area[name] += face->measure();
  EXPECT_NEAR(area["patch"], 0.25, 1e-12);
  EXPECT_NEAR(area["front"], 0.75, 1e-12);
  EXPECT_NEAR(area["slit"], 1., 1e-12);
  EXPECT_NEAR(area["slit lower"], 0.5, 1e-12);
  EXPECT_NEAR(area["slit upper"], 0.5, 1e-12);
}



TEST(BoundaryRegions, SlitFacesBelongToTheCellsBesideThem)
{
  for (const std::string name : {"slit square", "punctured strip"})
  {
    const auto        geometry = all_geometries<2>().make(name);
    const auto        ids      = geometry->boundary_ids();
    const bool        is_strip = name == "punctured strip";
    const std::string slit     = is_strip ? "notch" : "slit";
    Triangulation<2>  mesh;
    geometry->create(mesh);
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (const auto id = cell->face(f)->boundary_id();
            cell->face(f)->at_boundary() && ids.at(slit).contains(id))
        {
          const bool is_above =
            cell->center()[1] > geometry->slits()[0].corners[1][1];
          EXPECT_EQ(ids.at(slit + " upper").contains(id), is_above);
          EXPECT_EQ(ids.at(slit + " lower").contains(id), !is_above);
        }
  }
}



TEST(BoundaryRegions, AreRefusedWithTheNearestFaces)
{
  const std::string entry = "Geometry/Boundary regions: found ";
  std::string       message =
    refusal(rectangle_with("grip : x > 4.1 && y > 1.9"), plate_cells);
  expect_part(entry + "'grip : x > 4.1 && y > 1.9'", message);
  expect_part("the nearest are (", message);
  expect_part("(4, 1.75)", message);
  message = refusal(rectangle_with("a : x < 0.1 ; b : x < 0.2"), plate_cells);
  expect_part("only on faces that belong to a later region", message);
  message = refusal(rectangle_with("a : x == 17.123"), plate_cells);
  expect_part("they lie between (0, 0) and (4, 2)", message);
  expect_part("'top', which the geometry has already",
              refusal(rectangle_with("top : x < 0.1"), plate_cells));
  expect_part("a second condition for 'a'",
              refusal(rectangle_with("a : x < 1 ; a : y < 1"), plate_cells));
  expect_part("allowed is 'name : condition'",
              refusal(rectangle_with("x < 1"), plate_cells));
  expect_part("the name '1a'",
              refusal(rectangle_with("1a : x < 1"), plate_cells));
  expect_part("unknown name 't'",
              refusal(rectangle_with("a : x < t"), plate_cells));
  expect_part("infinity at x = 4",
              refusal(rectangle_with("a : 1/(x - 4)"), plate_cells));
}



// A mesh for --check: no region without a face, though faces are larger
TEST(BoundaryRegions, SayWhatTheirMeshFileSays)
{
  const Described<> described(
    Entries({{"Name", "mesh file"}, {"Boundary regions", "low : y < 1e-6"}}),
    Entries({{"File name", meshes + "/plate_of_triangles.msh"},
             {"Cut simplices", "true"}}));
  described.parameters.check();
  const Geometry<2> &geometry = described.parameters.chosen();
  unsigned int       n_cells  = 0;
  for (const bool again : {false, true}) // what check() has read, and anew
  {
    SCOPED_TRACE(again);
    Triangulation<2> mesh;
    geometry.create(mesh);
    EXPECT_NE(geometry.about_mesh().find("cut"), std::string::npos);
    EXPECT_GT(boundary_length(mesh, geometry.boundary_ids().at("low")), 0.);
    if (again)
    {
      EXPECT_EQ(mesh.n_active_cells(), n_cells);
    }
    n_cells = mesh.n_active_cells();
  }
}



TEST(BoundaryRegions, OnLargerCellsNoneIsMissed)
{
  const Described<> described(
    rectangle_with("bit : x > 3.6 && y > 1.9"),
    {{"Upper corner", "4, 2"}, {"Cell size", "0.25"}});
  const auto       larger = described.parameters.chosen().coarser(8.);
  Triangulation<2> mesh;
  larger->create(mesh);
  EXPECT_EQ(mesh.n_active_cells(), 2u);
  EXPECT_GT(boundary_length(mesh, larger->boundary_ids().at("bit")), 0.);
}



TEST(PointSets, AreTheVerticesOfAllRanksInOrder)
{
  Described<> described(
    {{"Name", "rectangle"},
     {"Point sets", "low : y < 0.3 && x > 3.4 ; tip : x > 9"}},
    plate_cells);
  described.parameters.check();
  dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
  described.parameters.chosen().create(mesh);
  const PointSets<2> &sets = described.parameters.point_sets();
  const auto          same = [&](const std::vector<Point<2>> &expected) {
    EXPECT_EQ(sets.points_of("low", mesh), expected);
  };
  same({{3.5, 0.}, {4., 0.}});
  mesh.refine_global(1);
  same(
    {{3.5, 0.}, {3.5, 0.25}, {3.75, 0.}, {3.75, 0.25}, {4., 0.}, {4., 0.25}});
  const std::string message =
    message_of([&]() { sets.points_of("tip", mesh); });
  expect_part(
    "Geometry/Point sets: found 'tip : x > 9', which holds at no vertex",
    message);
  expect_part("the nearest are (4, ", message);
  expect_part("Allowed: low, tip",
              message_of([&]() { sets.points_of("Tip of it", mesh); }));
  for (const Point<2> &point : sets.points_near("tip", mesh))
    EXPECT_EQ(point[0], 4.);
}



TEST(MeshFileNames, OfTheFileHoldAsTheyAre)
{
  // two unit squares; the left edge in two groups, of which one is all around
  const std::string text =
    "*Heading\n*NODE\n1, 0, 0\n2, 1, 0\n3, 2, 0\n4, 0, 1\n5, 1, 1\n6, 2, 1\n"
    "*ELEMENT, TYPE=CPS4\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n"
    "*NSET, NSET=Left side\n1, 4\n*NSET, NSET=Nodes of all\n1, 2, 3, 4, 5, 6\n"
    "*NSET, NSET=pin\n1\n*SURFACE, NAME=SS3, TYPE=ELEMENT\n1, S3\n2, S3\n";
  const auto length = [&](const std::string &names, const std::string &name) {
    const auto       geometry = mesh_file({written(text), names, ""});
    Triangulation<2> mesh;
    geometry->create(mesh);
    const auto ids = geometry->boundary_ids();
    return ids.count(name) == 0 ? -1. : boundary_length(mesh, ids.at(name));
  };
  for (const std::string names : {"", "3 = roof"})
  {
    EXPECT_NEAR(length(names, "Left side"), 1., 1e-12);
    EXPECT_NEAR(length(names, "Nodes of all"), 6., 1e-12);
    EXPECT_EQ(length(names, "pin"), -1.);
  }
  EXPECT_NEAR(length("", "SS3"), 2., 1e-12);
  EXPECT_NEAR(length("3 = roof", "roof"), 2., 1e-12);
  EXPECT_EQ(length("3 = roof", "SS3"), -1.);
  // one name for each face: of the .prm, or that of the smaller part
  const auto       geometry = mesh_file({written(text), "3 = roof", ""});
  Triangulation<2> mesh;
  geometry->create(mesh);
  const auto            names = geometry->names_of_ids();
  std::set<std::string> found;
  for (const auto id : mesh.get_boundary_ids())
    found.insert(names.at(id));
  EXPECT_EQ(found,
            (std::set<std::string>{"roof", "Left side", "Nodes of all"}));
}
