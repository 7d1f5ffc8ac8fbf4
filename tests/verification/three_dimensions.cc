// SPDX-License-Identifier: GPL-2.0-or-later
// Bodies in 3-d against exact stresses, the balance of forces, and plane strain
// in 2-d.
#include "body.h"

#include <input/case_signature.h>
#include <input/parameter_file.h>

#include <simulation/simulation.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  const std::vector<std::string> formulations = {"mixed", "displacement"};

  std::string
  box(const std::string &model, const std::string &more)
  {
    return "Geometry/Name = box\n"
           "Geometry/Box/Upper corner = 2, 3, 1.5\n"
           "Geometry/Box/Cells = 2, 3, 1\n"
           "Model/Formulation = " +
           model + "\nMaterial/Young's modulus = 7.2\n" + more + '\n';
  }

  // a strip with a hole, coarse
  std::string
  strip(const std::string &model, const std::string &more)
  {
    return "Geometry/Name = punctured strip\n"
           "Geometry/Punctured strip/Notch length = 0\n"
           "Geometry/Punctured strip/Cell size = 5\n"
           "Model/Kinematics = plane strain\n"
           "Model/Formulation = " +
           model +
           "\nMaterial/Shear modulus = 2.4\n"
           "Material/Thickness = 2\n" +
           more + '\n';
  }

  const std::string sliding = "top : y : 0; bottom : y : -t; left : x : 0";
  const std::string clamped = "top : all : 0; bottom : x : 0; bottom : y : -t";
} // namespace



TEST(ThreeDimensions, UniaxialTensionOfABox)
{
  // a mesh with hanging nodes, on the boundaries too
  for (const std::string &model : formulations)
    for (const double nu : {0.3, 0.499})
    {
      SCOPED_TRACE(model + ", nu = " + std::to_string(nu));
      BodyIn<3> body(
        box(model,
            "Material/Poisson ratio = " + std::to_string(nu) +
              "\nMesh/Refined boxes = 0,2,0 : 1,3,0.5 : 1\n"
              "Boundary conditions/Displacement = left : x : 0; bottom : y : 0;"
              " back : z : 0; top : y : 0.03*t"));
      body.solve();
      const double strain = 0.01;
      const auto   force  = body.reaction("top");
      EXPECT_NEAR(force[1], 7.2 * strain * 2. * 1.5, 1e-9);
      EXPECT_NEAR(force[0], 0., 1e-9);
      EXPECT_NEAR(force[2], 0., 1e-9);
      EXPECT_NEAR(body.integrated_traction("top")[1], force[1], 1e-9);
      EXPECT_NEAR(body.reaction("bottom")[1], force[1], 1e-9);
      const auto corner = body.displacement_at({2., 3., 1.5});
      EXPECT_NEAR(corner[0], -nu * strain * 2., 1e-9);
      EXPECT_NEAR(corner[1], 0.03, 1e-12);
      EXPECT_NEAR(corner[2], -nu * strain * 1.5, 1e-9);
    }
}



TEST(ThreeDimensions, SimpleShearInZ)
{
  // u_z = gamma y: the stress is mu gamma everywhere
  for (const std::string &model : formulations)
  {
    SCOPED_TRACE(model);
    BodyIn<3> sheared(
      box(model,
          "Material/Poisson ratio = 0.2\n"
          "Boundary conditions/Displacement = bottom : all : 0; top : x : 0; "
          "top : y : 0; top : z : 0.06*t; back : x : 0; back : y : 0; "
          "back : z : 0.02*y; front : x : 0; front : y : 0; "
          "front : z : 0.02*y"));
    sheared.solve();
    const double mu = 7.2 / (2. * 1.2);
    EXPECT_NEAR(
      sheared.integrated_traction("top")[2], mu * 0.02 * 2. * 1.5, 1e-9);
  }
}



TEST(ThreeDimensions, ReactionIsTheIntegratedTraction)
{
  // as in 2-d, see Reaction.IsTheIntegratedTractionInRowsOfRectangles; free at
  // both faces, so that it bulges
  BodyIn<3> body(strip("mixed",
                       "Geometry/Punctured strip/Cell size = 4\n"
                       "Material/Lame lambda = 2593.4\n"
                       "Boundary conditions/Displacement = " +
                         sliding + "; back : z : 0"));
  body.solve();
  const double consistent = body.reaction("top")[1];
  EXPECT_GT(consistent, 0.);
  EXPECT_NEAR(
    body.integrated_traction("top")[1], consistent, 1e-9 * consistent);
  EXPECT_NEAR(body.reaction("bottom")[1], consistent, 1e-9 * consistent);
}



TEST(ThreeDimensions, ReactionsBalanceOnAMeshWithHangingNodes)
{
  for (const std::string &model : formulations)
  {
    SCOPED_TRACE(model);
    BodyIn<3> body(strip(model,
                         "Material/Lame lambda = 24\n"
                         "Geometry/Punctured strip/Thickness cells = 2\n"
                         "Mesh/Refined boxes = 0,20,0 : 10,28,1 : 1\n"
                         "Boundary conditions/Displacement = " +
                           clamped));
    body.set_phase_field([](const dealii::Point<3> &x) {
      return std::min(1., 0.1 + std::abs(x[1] + x[2] - 8.) / 6.);
    });
    body.solve();
    const auto top = body.reaction("top"), bottom = body.reaction("bottom");
    EXPECT_GT(top[1], 0.);
    EXPECT_NEAR(bottom[1], top[1], 1e-8 * top[1]);
    EXPECT_NEAR(bottom[0], top[0], 1e-8 * top[1]);
  }
}



TEST(ThreeDimensions, BalancesTheLoads)
{
  BodyIn<3> body(box("displacement",
                     "Material/Poisson ratio = 0.3\n"
                     "Boundary conditions/Displacement = top : all : 0\n"
                     "Boundary conditions/Body force = z : 0.01\n"
                     "Boundary conditions/Traction = front : z : 0.02*y"));
  body.solve();
  // reactions against volume 9 and the face 2 x 3
  EXPECT_NEAR(body.reaction("top")[2], -0.09 - 0.02 * 4.5 * 2., 1e-10);
}



TEST(ThreeDimensions, ThickStripWithoutStrainInZIsPlaneStrain)
{
  for (const std::string &model : formulations)
    for (const std::string lambda : {"2.4", "2593.4"})
    {
      SCOPED_TRACE(model + ", lambda = " + lambda);
      const std::string more =
        "Mesh/Global refinements = 1\n"
        "Material/Lame lambda = " +
        lambda + "\nBoundary conditions/Displacement = " + clamped;
      BodyIn<2> plane(strip(model, more));
      BodyIn<3> body(strip(model, more + "; back : z : 0; front : z : 0"));
      plane.solve();
      body.solve();
      // the one per mm of thickness, the other of 2 mm
      const double expected = 2. * plane.reaction("top")[1];
      EXPECT_GT(expected, 0.);
      EXPECT_NEAR(body.reaction("top")[1], expected, 1e-8 * expected);
    }
}



namespace
{
  using Columns = std::map<std::string, std::vector<double>>;

  Columns
  read_columns(const std::string &file_name)
  {
    std::ifstream            file(file_name);
    std::string              line;
    std::vector<std::string> names;
    Columns                  columns;
    std::getline(file, line);
    std::istringstream header(line);
    for (std::string name; std::getline(header, name, ',');)
      names.push_back(name);
    while (std::getline(file, line))
    {
      std::istringstream row(line);
      for (const std::string &name : names)
      {
        std::string cell;
        std::getline(row, cell, ',');
        columns[name].push_back(std::stod(cell));
      }
    }
    return columns;
  }



  // the whole program but for the reading of a file
  template <int dim>
  Columns
  run(std::vector<std::string> settings)
  {
    const std::string directory =
      "three_dimensions_" + std::to_string(dim) + "d_" +
      std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)) +
      "_ranks";
    settings.push_back("Geometry/Dimension=" + std::to_string(dim));
    settings.push_back("Output/Directory=" + directory);
    Parameters<dim>          parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    read_parameters(std::vector<SourceLine>(), settings, prm);
    parameters.check();
    {
      Log             log(/*active=*/false);
      Simulation<dim> simulation(
        parameters, "", case_signature(prm), MPI_COMM_WORLD, log);
      EXPECT_EQ(simulation.run(ExistingRun::overwrite).exit_status, 0);
    }
    const Columns columns = read_columns(directory + "/statistics.csv");
    MPI_Barrier(MPI_COMM_WORLD);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::filesystem::remove_all(directory);
    return columns;
  }
} // namespace



// The independent check of everything at once: a crack that runs through a
// strip of one layer of cells, held in z, is that of the plane-strain run.
TEST(ThreeDimensions, CrackInAThickStripIsThatOfPlaneStrain)
{
  for (const std::string &model : formulations)
  {
    SCOPED_TRACE(model);
    const std::string supports = "Boundary conditions/Displacement=" + clamped;
    const std::vector<std::string> settings = {
      "Geometry/Name=punctured strip",
      "Geometry/Punctured strip/Width=10",
      "Geometry/Punctured strip/Height=8",
      "Geometry/Punctured strip/Hole radius=0",
      "Geometry/Punctured strip/Notch height=3",
      "Geometry/Punctured strip/Notch length=4",
      "Geometry/Punctured strip/Cell size=1",
      "Model/Kinematics=plane strain",
      "Model/Formulation=" + model,
      "Model/Length scale=2",
      "Model/Coupling tolerance=1e-6",
      "Model/Running crack tolerance=1e-6",
      "Material/Lame lambda=20",
      "Material/Shear modulus=2.4",
      "Material/Critical energy release rate=1",
      "Material/Thickness=1.5",
      "Load stepping/End time=2.4",
      "Load stepping/First step=0.6",
      "Load stepping/Largest step=0.6",
      "Load stepping/Onset step=0.6",
      "Output/Fields every=0"};
    std::vector<std::string> in_plane = settings, thick = settings;
    in_plane.push_back(supports);
    thick.push_back(supports + "; back : z : 0; front : z : 0");
    Columns expected = run<2>(in_plane);
    Columns found    = run<3>(thick);
    ASSERT_EQ(expected["step"].size(), 5u);
    ASSERT_EQ(found["step"].size(), 5u);
    // it has run
    const std::vector<double> &force = expected["force_y_N"];
    EXPECT_LT(force.back(),
              0.5 * *std::max_element(force.begin(), force.end()));
    for (const char *name : {"force_x_N",
                             "force_y_N",
                             "elastic_energy_mJ",
                             "crack_energy_mJ",
                             "external_work_mJ",
                             "max_phase_field_change",
                             "displacement_mm"})
    {
      double largest = 0.;
      for (const double value : expected[name])
        largest = std::max(largest, std::abs(value));
      for (unsigned int step = 0; step < 5; ++step)
        EXPECT_NEAR(found[name][step], expected[name][step], 1e-4 * largest)
          << name << ", step " << step;
    }
  }
}
