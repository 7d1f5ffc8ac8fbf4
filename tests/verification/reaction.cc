// SPDX-License-Identifier: GPL-2.0-or-later
// The consistent nodal reaction against the integral of the traction over the
// boundary, and the balance of forces.
#include "body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  // A strip with a hole. Sliding supports leave the corners without
  // singularities; clamps do not.
  std::string
  strip(const std::string &supports,
        const unsigned int refinement,
        const std::string &model = "mixed")
  {
    return "Geometry/Name = punctured strip\n"
           "Geometry/Punctured strip/Notch length = 0\n"
           "Geometry/Punctured strip/Cell size = 4\n"
           "Mesh/Global refinements = " +
           std::to_string(refinement) +
           "\nModel/Kinematics = plane strain\n"
           "Model/Formulation = " +
           model +
           "\nMaterial/Lame lambda = 2593.4\n"
           "Material/Shear modulus = 2.4\n"
           "Boundary conditions/Displacement = " +
           supports + '\n';
  }

  const std::string sliding = "top : y : 0; bottom : y : -t; left : x : 0";
  const std::string clamped = "top : all : 0; bottom : x : 0; bottom : y : -t";

#ifdef DEBUG
  constexpr unsigned int fine = 3;
#else
  constexpr unsigned int fine = 4;
#endif
} // namespace



TEST(Reaction, IsTheLimitOfTheIntegratedTraction)
{
  // Q1 and Q2 displacements, compressible: first and second order
  for (const unsigned int degree : {1, 2})
  {
    double last_difference = 1.;
    for (unsigned int refinement = 1; refinement <= fine; ++refinement)
    {
      Body body(strip(sliding, refinement, "displacement") +
                "Model/Displacement degree = " + std::to_string(degree) +
                "\nMaterial/Lame lambda = 2.4\n");
      body.solve();
      const double consistent = body.reaction("top")[1];
      const double integrated = body.integrated_traction("top")[1];
      const double difference = std::abs(integrated / consistent - 1.);
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << "Q" << degree << ", h = " << body.cell_size
                  << ": consistent " << consistent << ", integrated "
                  << integrated << '\n';
      EXPECT_GT(consistent, 0.);
      EXPECT_LT(difference, (degree == 1 ? 0.6 : 0.35) * last_difference);
      last_difference = difference;
    }
    EXPECT_LT(last_difference, degree == 1 ? 5e-3 : 1e-4);
  }
}



TEST(Reaction, IsTheIntegratedTractionInRowsOfRectangles)
{
  // In a row of rectangles along the boundary the stress of Q2-Q1 elements
  // normal to it is linear in the direction of the normal; the quadratic test
  // functions then leave its resultant constant across the row.
  Body body(strip(sliding, 2));
  body.solve();
  const double consistent = body.reaction("top")[1];
  EXPECT_NEAR(
    body.integrated_traction("top")[1], consistent, 1e-9 * consistent);
}



TEST(Reaction, IsTheSameAtBothEnds)
{
  for (const std::string &supports : {sliding, clamped})
    for (const std::string model : {"mixed", "displacement"})
    {
      SCOPED_TRACE(supports + ", " + model);
      Body body(strip(supports, 2, model));
      body.solve();
      const double top = body.reaction("top")[1];
      EXPECT_GT(top, 0.);
      EXPECT_NEAR(body.reaction("bottom")[1], top, 1e-8 * top);
    }
}



TEST(Reaction, IsTheSameAtBothEndsAcrossACrack)
{
  Body body(strip(clamped, 2));
  body.set_phase_field([](const dealii::Point<2> &x) {
    return std::min(1., 0.1 + std::abs(x[1] - 8.) / 4.);
  });
  body.solve();
  const double top = body.reaction("top")[1];
  EXPECT_GT(top, 0.);
  EXPECT_NEAR(body.reaction("bottom")[1], top, 1e-8 * top);
}



TEST(Reaction, BalancesTheLoads)
{
  // hanging body of the volume 20 x 28 - pi 16 under its own weight and a load
  // on its right edge
  Body body(strip("top : all : 0", 3) +
            "Boundary conditions/Body force = y : -0.01\n"
            "Boundary conditions/Traction = right : x : 0.02*y\n");
  body.solve();
  double area = 0.;
  for (const auto &cell : body.triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      area += cell->measure();
  area = dealii::Utilities::MPI::sum(area, MPI_COMM_WORLD);
  EXPECT_NEAR(area, 20. * 28. - dealii::numbers::PI * 16., 0.3);
  const auto force = body.reaction("top");
  EXPECT_NEAR(force[1], 0.01 * area, 1e-8 * area);
  EXPECT_NEAR(force[0], -0.5 * 0.02 * 28. * 28., 1e-7);
}
