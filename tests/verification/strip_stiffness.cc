// SPDX-License-Identifier: GPL-2.0-or-later
// Stiffness of the punctured strip before anything breaks: notch at 6 mm, hole,
// "Neo Hooke" parameters. A separate trial code gives 5.72 N/mm per mm of
// thickness in plane strain [model.md, 7], 11.44 N/mm for the specimen.
#include "body.h"

#include <gtest/gtest.h>

#include <iostream>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  // N/mm for the specimen, 2 mm thick
  double
  stiffness(const std::string &kinematics, const unsigned int refinement)
  {
    Body         body("Geometry/Name = punctured strip\n"
                      "Geometry/Punctured strip/Notch height = 6\n"
                      "Geometry/Punctured strip/Cell size = 1.2\n"
                      "Mesh/Global refinements = " +
              std::to_string(refinement) +
              "\nModel/Formulation = mixed\n"
              "Model/Kinematics = " +
              kinematics +
              "\nMaterial/Lame lambda = 2593.40\n"
              "Material/Shear modulus = 2.40\n"
              "Material/Thickness = 2\n"
              "Boundary conditions/Displacement = "
              "top : all : 0; bottom : x : 0; bottom : y : -t\n");
    const double displacement = 0.1;
    EXPECT_LE(body.solve(displacement).iterations, 1u);
    const double result = body.parameters.material.thickness *
                          body.reaction("top")[1] / displacement;
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << kinematics << ", h >= " << body.cell_size << ": " << result
                << " N/mm\n";
    return result;
  }

} // namespace



TEST(StripStiffness, InPlaneStrain)
{
  for (int i : {0,1,2,3})
  EXPECT_NEAR(stiffness("plane strain", i), 11.44, 0.005 * 11.44);
  for (int i : {0,1,2,3}) stiffness("plane stress", i);
}
