// SPDX-License-Identifier: GPL-2.0-or-later
// A bar of two materials in series, held at its sides: both halves carry one
// stress, and their strains are u/L M_other/(M_1 + M_2)/2 with the modulus
// M = lambda + 2 mu, lambda reduced by (M6) in plane stress.
#include "body.h"

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  struct Half
  {
    double youngs_modulus;
    double poisson_ratio;

    double
    modulus(const bool plane_stress) const
    {
      const double mu     = youngs_modulus / (2. * (1. + poisson_ratio));
      const double lambda = 2. * mu * poisson_ratio / (1. - 2. * poisson_ratio);
      return plane_stress ? 2. * lambda * mu / (lambda + 2. * mu) + 2. * mu
                          : lambda + 2. * mu;
    }
  };

  constexpr Half left = {100., 0.3}, right = {2000., 0.2};

  Body
  bar(const std::string &formulation,
      const std::string &kinematics,
      const int          refinements)
  {
    return Body("Geometry/Name = rectangle\n"
                "Geometry/Rectangle/Upper corner = 4, 1\n"
                "Geometry/Rectangle/Cell size = 0.5\n"
                "Mesh/Global refinements = " +
                std::to_string(refinements) + "\nModel/Formulation = " +
                formulation + "\nModel/Kinematics = " + kinematics +
                "\nMaterial/Young's modulus = if(x < 2, 100, 2000)\n"
                "Material/Poisson ratio = if(x < 2, 0.3, 0.2)\n"
                "Boundary conditions/Displacement = "
                "left : all : 0; right : x : t; right : y : 0; "
                "bottom : y : 0; top : y : 0\n");
  }

  double
  exact_stress(const bool plane_stress, const double displacement)
  {
    return displacement /
           (2. / left.modulus(plane_stress) + 2. / right.modulus(plane_stress));
  }
} // namespace



TEST(TwoMaterials, DisplacementFormulationIsExact)
{
  for (const std::string kinematics : {"plane strain", "plane stress"})
  {
    Body body = bar("displacement", kinematics, 0);
    body.solve(0.1);
    const double exact = exact_stress(kinematics == "plane stress", 0.1);
    EXPECT_NEAR(body.reaction("right")[0], exact, 1e-9 * exact);
    EXPECT_NEAR(body.reaction("left")[0], exact, 1e-9 * exact);
    EXPECT_NEAR(body.displacement_at({2., 0.5})[0],
                2. * exact / left.modulus(kinematics == "plane stress"),
                1e-10);
  }
}



// The pressure is continuous: it cannot jump with the material, but the band
// in which it does not is as narrow as the cells.
TEST(TwoMaterials, MixedFormulationConverges)
{
  for (const std::string kinematics : {"plane strain", "plane stress"})
  {
    const double exact = exact_stress(kinematics == "plane stress", 0.1);
    double       errors[3];
    for (const int refinements : {0, 1, 2})
    {
      Body body = bar("mixed", kinematics, refinements);
      body.solve(0.1);
      errors[refinements] = std::abs(body.reaction("right")[0] - exact) / exact;
    }
    EXPECT_LT(errors[2], 0.6 * errors[1]);
    EXPECT_LT(errors[1], 0.6 * errors[0]);
    EXPECT_LT(errors[2], 0.02);
  }
}
