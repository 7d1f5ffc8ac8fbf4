// SPDX-License-Identifier: GPL-2.0-or-later
// Loads on boundaries: pressure in a thick-walled cylinder at small strain
// (Lame) and at finite strain (exact for an incompressible neo-Hookean wall),
// on a cube that becomes smaller, and the torque of a bar.
#include "body.h"

#include <output/watched_boundaries.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  const std::string hookean = "Model/Strains = small\n"
                              "Model/Kinematics = plane strain\n"
                              "Model/Energy split = none\n"
                              "Model/Pressure law = relaxed bulk\n";

  const std::string rubber = "Model/Strains = finite\n"
                             "Model/Hyperelastic law = neo-Hooke\n"
                             "Model/Energy split = none\n"
                             "Model/Pressure law = relaxed bulk\n"
                             "Model/Kinematics = plane strain\n";

  // radii 1 and 2 mm; boundaries are those of a box, the inner wall is 'left'
  const std::string quarter =
    "Geometry/Name = rectangle\n"
    "Geometry/Rectangle/Lower corner = 1, 0\n"
    "Geometry/Rectangle/Upper corner = 2, 1\n"
    "Geometry/Rectangle/Cells = 12, 40\n"
    "Boundary conditions/Displacement = bottom : y : 0; top : x : 0\n";

  dealii::Point<2>
  bent(const dealii::Point<2> &p)
  {
    const double angle = 0.5 * dealii::numbers::PI * p[1];
    return {p[0] * std::cos(angle), p[0] * std::sin(angle)};
  }

  // displacement of the inner wall (mm) under the pressure @p p (MPa)
  double
  lame(const double p, const double E, const double nu)
  {
    return p * (1. + nu) / E * ((1. - 2. * nu) + 4.) / 3.;
  }

  // p/mu in an incompressible neo-Hookean wall in plane strain whose inner
  // radius 1 has become a, the outer one, 2, b with b^2 = a^2 + 3:
  //
  //   p = mu integral from a to b of (lambda^2 - lambda^-2) dr/r,
  //   lambda = r/R, R^2 = r^2 - a^2 + 1,
  //
  // by Simpson's rule
  double
  pressure_of_stretch(const double a)
  {
    const double b = std::sqrt(a * a + 3.);
    const auto   f = [a](const double r) {
      const double square = r * r / (r * r - a * a + 1.);
      return (square - 1. / square) / r;
    };
    const unsigned int n   = 1000;
    double             sum = f(a) + f(b);
    for (unsigned int i = 1; i < n; ++i)
      sum += (i % 2 == 1 ? 4. : 2.) * f(a + (b - a) * i / n);
    return sum * (b - a) / (3. * n);
  }
} // namespace



TEST(BoundaryLoads, LameAtSmallStrain)
{
  for (const std::string &load :
       {std::string("Boundary conditions/Pressure = left : 2*t\n"),
        std::string("Boundary conditions/Traction = left : normal : -2*t\n")})
    for (const std::string &formulation :
         {std::string("mixed"), std::string("displacement")})
    {
      Body body(hookean + quarter + load +
                  "Model/Formulation = " + formulation +
                  "\nModel/Displacement degree = 2\n"
                  "Material/Young's modulus = 100\n"
                  "Material/Poisson ratio = 0.3\n",
                bent);
      body.solve();
      EXPECT_NEAR(body.displacement_at({1., 0.})[0],
                  lame(2., 100., 0.3),
                  2e-3 * lame(2., 100., 0.3))
        << load << formulation;
    }
}



TEST(BoundaryLoads, PressureInACylinderAtFiniteStrain)
{
  EXPECT_NEAR(pressure_of_stretch(1.5), 0.428228, 1e-6);
  Body body(rubber + quarter +
              "Model/Formulation = mixed\n"
              "Material/Lame lambda = 1e5\nMaterial/Shear modulus = 1\n"
              "Boundary conditions/Pressure = left : 0.45*t\n",
            bent);
  for (const double time : {0.25, 0.5, 0.75, 1.})
  {
    body.solve(time);
    const double stretch = 1. + body.displacement_at({1., 0.})[0];
    EXPECT_NEAR(pressure_of_stretch(stretch), 0.45 * time, 2e-3 * 0.45 * time);
    EXPECT_NEAR(1. + body.displacement_at({0., 1.})[1], stretch, 1e-3);
  }
  EXPECT_GT(body.displacement_at({1., 0.})[0], 0.5);
}



// The last residuals fall quadratically: the tangent has the pressure in it.
TEST(BoundaryLoads, NewtonsMethodConvergesQuadratically)
{
  for (const std::string &formulation :
       {std::string("mixed"), std::string("displacement")})
  {
    Body body(rubber + quarter + "Model/Formulation = " + formulation +
                "\nModel/Displacement degree = 2\n"
                "Material/Lame lambda = 10\nMaterial/Shear modulus = 1\n"
                "Boundary conditions/Pressure = left : (0.4 + 0.1*x)*t\n",
              bent);
    const std::vector<double> history = body.newton_history(0.5, 1e-11);
    ASSERT_GE(history.size(), 3u);
    ASSERT_LE(history.size(), 7u);
    EXPECT_LT(history.back(), 1e-11);
    const std::size_t n = history.size();
    EXPECT_LT(history[n - 2], 30. * history[n - 3] * history[n - 3])
      << formulation;
  }
}



// A cube pressed on three sides and held by its planes of symmetry: F = s I,
// and with W of (M12) and the energy of the volume
//   - p = mu (s^2 - 1)/J + lambda (J - 1),  J = s^3.
TEST(BoundaryLoads, ACubeUnderPressureAtFiniteStrain)
{
  const double mu = 1., lambda = 3.;
  BodyIn<3>    body(
    rubber +
    "Geometry/Name = box\nGeometry/Box/Cells = 2, 2, 2\n"
       "Model/Formulation = displacement\nModel/Displacement degree = 1\n"
       "Material/Lame lambda = 3\nMaterial/Shear modulus = 1\n"
       "Boundary conditions/Displacement = left : x : 0; bottom : y : 0; "
       "back : z : 0\n"
       "Boundary conditions/Pressure = right : 2*t; top : 2*t; front : 2*t\n");
  for (const double time : {0.5, 1.})
  {
    body.solve(time);
    const auto   u = body.displacement_at({1., 1., 1.});
    const double s = 1. + u[0], J = s * s * s;
    EXPECT_NEAR(u[1], u[0], 1e-8);
    EXPECT_NEAR(u[2], u[0], 1e-8);
    EXPECT_NEAR(-(mu * (s * s - 1.) / J + lambda * (J - 1.)), 2. * time, 1e-6);
  }
}



// A square bar, twisted between two sides whose warping is free: Saint-Venant's
// torque is 0.140577 G theta' a^4.
TEST(BoundaryLoads, TorqueOfASquareBar)
{
  BodyIn<3> body(
    hookean +
    "Geometry/Name = box\nGeometry/Box/Upper corner = 1, 1, 0.5\n"
    "Geometry/Box/Cells = 6, 6, 2\n"
    "Model/Formulation = displacement\nModel/Displacement degree = 2\n"
    "Material/Shear modulus = 5\nMaterial/Poisson ratio = 0.3\n"
    "Boundary conditions/Displacement = back : x : 0; back : y : 0; front : "
    "twist about 0.5, 0.5, 0 axis 0, 0, 1 : 5e-5*t\n"
    "Boundary conditions/Displacement at points = 0.5, 0.5, 0 : z : 0\n");
  body.solve();
  WatchedBoundary<3> front;
  front.name  = "front";
  front.about = dealii::Point<3>(0.5, 0.5, 0.5);
  front.ids   = body.boundary_ids("front");
  WatchedBoundaries<3> watched(
    body.fields, body.constraints, {front}, 1., false);
  watched.reinit();
  const std::vector<double> values   = watched.evaluate(body.state);
  const double              expected = 0.140577 * 5. * 1e-4;
  ASSERT_EQ(values.size(), 9u);
  EXPECT_NEAR(values[5], expected, 1e-2 * expected);
  EXPECT_LT(std::abs(values[3]), 1e-6 * expected);
  EXPECT_LT(std::abs(values[0]), 1e-6 * expected);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << "torque of a square bar over Saint-Venant's: "
              << values[5] / expected << '\n';
}
