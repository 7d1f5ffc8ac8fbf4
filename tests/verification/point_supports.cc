// SPDX-License-Identifier: GPL-2.0-or-later
// A body held at single points: bar under tension, exact.
#include "body.h"

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr double youngs_modulus = 10., poisson_ratio = 0.3;

  // pulled to the right by 1 MPa in plane stress, held by the left side in x
  // and by one corner in y, which is moved
  std::string
  bar(const std::string &formulation)
  {
    return "Geometry/Name = rectangle\n"
           "Geometry/Rectangle/Upper corner = 2, 1\n"
           "Geometry/Rectangle/Cell size = 0.5\n"
           "Mesh/Refined boxes = 0,0 : 0.6,0.6 : 2\n"
           "Model/Kinematics = plane stress\n"
           "Model/Formulation = " +
           formulation +
           "\nModel/Displacement degree = 2\n"
           "Material/Young's modulus = 10\n"
           "Material/Poisson ratio = 0.3\n"
           "Boundary conditions/Displacement = left : x : 0\n"
           "Boundary conditions/Displacement at points = 0,0 : y : 0.5*t\n"
           "Boundary conditions/Traction = right : x : t\n";
  }
} // namespace



TEST(PointSupports, HoldABarInTension)
{
  for (const std::string formulation : {"mixed", "displacement"})
  {
    SCOPED_TRACE(formulation);
    Body body(bar(formulation));
    body.solve();
    for (const dealii::Point<2> &vertex : {dealii::Point<2>(0., 0.),
                                           dealii::Point<2>(2., 0.),
                                           dealii::Point<2>(2., 1.),
                                           dealii::Point<2>(0.5, 0.5)})
    {
      const auto u = body.displacement_at(vertex);
      EXPECT_NEAR(u[0], vertex[0] / youngs_modulus, 1e-9);
      EXPECT_NEAR(u[1], 0.5 - poisson_ratio / youngs_modulus * vertex[1], 1e-9);
    }
  }
}
