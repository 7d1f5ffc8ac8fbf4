// SPDX-License-Identifier: GPL-2.0-or-later
// Layered blocks in 3-d. Pulled along the layers all have one strain, and with
// the same Poisson ratio everywhere the block shrinks across as one: the
// stiffnesses add up. Pulled across the layers, held at the sides, all carry
// one stress: the compliances of constrained layers add up. The layers come
// from expressions, a table and the material ids of a mesh file.
#include "body.h"

#include "../unit/hex_meshes.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <fstream>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr double soft = 100., stiff = 700., nu = 0.25;

  // 2 x 3 x 1 mm, soft for x < 1
  const std::string box = "Geometry/Name = box\n"
                          "Geometry/Box/Upper corner = 2, 3, 1\n"
                          "Geometry/Box/Cells = 4, 3, 2\n";

  // as in every description of one body
  const std::string modulus = "Material/Young's modulus = ";

  std::string
  file_name(const std::string &name)
  {
    return ::testing::TempDir() + "mixed_cracks_layers_" +
           std::to_string(
             dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) +
           name;
  }

  // Young's modulus / 100 at two nodes in x
  std::string
  table()
  {
    const std::string name = file_name(".csv");
    std::ofstream(name) << "x,y,z,value\n0.5,0,0,1\n1.5,0,0,7\n";
    return name;
  }

  // cells counted from different corners, so that refined neighbours meet
  // turned
  std::string
  mesh_file()
  {
    GeometryTests::HexMesh mesh = GeometryTests::unit_cubes(2, 3);
    for (unsigned int i = 0; i < mesh.cells.size(); ++i)
      GeometryTests::turn(mesh.cells[i], i % 4, i % 2 == 0);
    const std::string name = file_name(".msh");
    std::ofstream(name) << mesh.gmsh2();
    return "Geometry/Name = mesh file\nGeometry/Mesh file/File name = " + name +
           "\nGeometry/Mesh file/Boundary names = 1 = bottom ; 2 = top ; "
           "0 = sides\n";
  }

  std::vector<std::string>
  descriptions()
  {
    return {box + modulus + "if(x < 1, 100, 700)\n",
            box + modulus + "100*map\nMaterial/Map/File name = " + table() +
              "\nMaterial/Map/Interpolation = nearest\n",
            mesh_file() + modulus +
              "100\nMaterial/By material id = 8 : Young's modulus = 700\n"};
  }

  const std::string rest = "Material/Poisson ratio = 0.25\n"
                           "Mesh/Refined boxes = 0,2,0 : 1,3,0.5 : 1\n";
} // namespace



namespace
{
  // free to shrink across
  std::string
  pulled(const std::string &formulation)
  {
    return rest + "Model/Formulation = " + formulation +
           "\nBoundary conditions/Displacement = bottom : y : 0; top : y : "
           "0.03*t\nBoundary conditions/Displacement at points = "
           "0,0,0 : all : 0 ; 2,0,0 : z : 0\n";
  }

  constexpr double sum_of_stiffnesses = 0.01 * (soft + stiff); // 1 mm^2 each
} // namespace



TEST(Layers3d, InParallelStiffnessesAddUp)
{
  for (const std::string &description : descriptions())
  {
    SCOPED_TRACE(description);
    BodyIn<3> body(description + pulled("displacement"));
    body.solve();
    EXPECT_NEAR(
      body.reaction("top")[1], sum_of_stiffnesses, 1e-9 * sum_of_stiffnesses);
    const auto corner = body.displacement_at({2., 3., 1.});
    EXPECT_NEAR(corner[0], -nu * 0.01 * 2., 1e-9);
    EXPECT_NEAR(corner[1], 0.03, 1e-12);
    EXPECT_NEAR(corner[2], -nu * 0.01, 1e-9);
  }
}



// As in the plane (TwoMaterials): the continuous pressure cannot jump.
TEST(Layers3d, MixedFormulationConverges)
{
  double errors[2];
  for (const int refinements : {0, 1})
  {
    BodyIn<3> body(descriptions()[0] + pulled("mixed") +
                   "Mesh/Global refinements = " + std::to_string(refinements));
    body.solve();
    errors[refinements] =
      std::abs(body.reaction("top")[1] / sum_of_stiffnesses - 1.);
  }
  EXPECT_LT(errors[0], 0.02);
  EXPECT_LT(errors[1], 0.6 * errors[0]);
}



TEST(Layers3d, InSeriesCompliancesAddUp)
{
  const double constrained = (1. - nu) / ((1. + nu) * (1. - 2. * nu));
  const double exact       = // 3 mm^2
    3. * 0.02 * constrained / (1. / soft + 1. / stiff);
  for (unsigned int i = 0; i < 2; ++i) // those with named sides
  {
    const std::string description = descriptions()[i];
    SCOPED_TRACE(description);
    BodyIn<3> body(description + rest +
                   "Model/Formulation = displacement\n"
                   "Boundary conditions/Displacement = left : x : 0; right : x "
                   ": 0.02*t; bottom : y : 0; top : y : 0; back : z : 0; "
                   "front : z : 0\n");
    body.solve();
    EXPECT_NEAR(body.reaction("right")[0], exact, 1e-9 * exact);
    EXPECT_NEAR(body.reaction("left")[0], exact, 1e-9 * exact);
    EXPECT_NEAR(body.displacement_at({1., 3., 1.})[0],
                exact / 3. / constrained / soft,
                1e-10);
  }
}
