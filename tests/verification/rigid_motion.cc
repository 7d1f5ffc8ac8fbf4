// SPDX-License-Identifier: GPL-2.0-or-later
// A supported body that is moved as a whole: no strain, hence no forces but
// what rounding leaves, and Newton's method ends all the same.
#include "body.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  std::string
  block(const std::string &formulation, const std::string &kinematics)
  {
    return "Geometry/Name = rectangle\n"
           "Geometry/Rectangle/Upper corner = 2, 1\n"
           "Geometry/Rectangle/Cell size = 0.125\n"
           "Model/Kinematics = " +
           kinematics + "\nModel/Formulation = " + formulation +
           "\nModel/Displacement degree = 2\n"
           "Material/Young's modulus = 10\n"
           "Material/Poisson ratio = 0.3\n";
  }

  // forces of a strain of 1e-8 in all of the 1 mm wide cross section would be
  // 1e-7 N per mm thickness
  constexpr double next_to_nothing = 1e-7;
} // namespace



// 100 mm, of a body 2 mm long
TEST(RigidMotion, OfASupportedBodyCausesNoForces)
{
  for (const std::string formulation : {"mixed", "displacement"})
    for (const std::string kinematics : {"plane strain", "plane stress"})
    {
      SCOPED_TRACE(formulation + ", " + kinematics);
      Body body(block(formulation, kinematics) +
                "Boundary conditions/Displacement = left : x : 100*t ; left : y"
                " : 50*t ; right : x : 100*t ; right : y : 50*t\n");
      body.solve();
      EXPECT_LT(body.reaction("right").norm(), next_to_nothing);
      EXPECT_NEAR(body.displacement_at({1., 0.5})[0], 100., 1e-9);
      EXPECT_NEAR(body.displacement_at({1., 0.5})[1], 50., 1e-9);
    }
}



// a whole turn about a point 20 mm away, in steps
TEST(RigidMotion, OfABodyThatIsTurnedAtFiniteStrain)
{
  for (const std::string formulation : {"mixed", "displacement"})
  {
    SCOPED_TRACE(formulation);
    const std::string turned = " : rotation about 20, 0 : 2*pi*t";
    Body              body(block(formulation, "plane strain") +
              "Model/Strains = finite\n"
                           "Model/Hyperelastic law = neo-Hooke\n"
                           "Model/Energy split = none\n"
                           "Boundary conditions/Displacement = left" +
              turned + " ; right" + turned + "\n");
    for (const double time : {0.05, 0.1, 0.15, 0.2, 0.3, 0.5})
      body.solve(time);
    EXPECT_LT(body.reaction("right").norm(), next_to_nothing);
    // half a turn
    EXPECT_NEAR(body.displacement_at({1., 0.5})[0], 38., 1e-7);
    EXPECT_NEAR(body.displacement_at({1., 0.5})[1], -1., 1e-7);
  }
}
