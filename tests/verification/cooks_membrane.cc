// SPDX-License-Identifier: GPL-2.0-or-later
// Cook's membrane: the trapezoid (0,0), (48,44), (48,60), (0,44), clamped on
// the left, a shear force of 1 N spread over the right edge. Watched is the
// vertical displacement of the middle (48,52) of that edge.
//  - Plane stress, E = 1, nu = 1/3: 23.96, the value that the literature on
//    elements agrees on (Cook's own example of 1974; e.g. Simo and Rifai 1990).
//  - Plane strain, incompressible (lambda = 0.75e7, mu = 0.375): 16.4326,
//    extrapolated by Krysl, example cookstrain.m of FinEALE, from nodally
//    integrated triangles [Krysl, Zhu 2008].
//  - Plane strain, nearly incompressible: the converged displacement of our own
//    Q2 displacement elements and of the mixed ones on fine meshes.
#include "body.h"

#include <gtest/gtest.h>

#include <iostream>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  const std::string membrane =
    "Geometry/Name = quadrilateral\n"
    "Geometry/Quadrilateral/Corners = 0,0 ; 48,44 ; 48,60 ; 0,44\n"
    "Geometry/Quadrilateral/Cells = 1, 1\n"
    "Boundary conditions/Displacement = left : all : 0\n"
    "Boundary conditions/Traction = right : y : 1/16\n";

  // @p refinement: 2^refinement cells in each direction
  double
  tip_displacement(const std::string &model,
                   const std::string &poisson_ratio,
                   const unsigned int refinement)
  {
    Body body(membrane +
              "Mesh/Global refinements = " + std::to_string(refinement) +
              "\nMaterial/Young's modulus = 1\n"
              "Material/Poisson ratio = " +
              poisson_ratio + '\n' + model);
    body.solve();
    const double tip = body.displacement_at({48., 52.})[1];
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << body.parameters.model.formulation << " Q"
                << body.parameters.model.degree() << ", nu " << poisson_ratio
                << ", " << (1 << refinement) << " cells: " << tip << '\n';
    return tip;
  }

  const std::string mixed           = "Model/Formulation = mixed\n";
  const std::string linear          = "Model/Formulation = displacement\n"
                                      "Model/Displacement degree = 1\n";
  const std::string quadratic       = "Model/Formulation = displacement\n"
                                      "Model/Displacement degree = 2\n";
  const std::string in_plane_stress = "Model/Kinematics = plane stress\n";
  const std::string in_plane_strain = "Model/Kinematics = plane strain\n";
#ifdef DEBUG
  constexpr unsigned int fine = 5;
#else
  constexpr unsigned int fine = 6;
#endif
} // namespace



TEST(CooksMembrane, AgreesWithTheLiteratureInPlaneStress)
{
  for (const std::string &model : {mixed, quadratic})
    EXPECT_NEAR(tip_displacement(model + in_plane_stress, "0.3333333333", fine),
                23.96,
                0.002 * 23.96);
}



TEST(CooksMembrane, AgreesWithAnExtrapolatedValueInPlaneStrain)
{
  // E = mu (3 lambda + 2 mu) / (lambda + mu) = 3 mu but for the eighth digit
  EXPECT_NEAR(0.375 * 3. * 16.4326,
              tip_displacement(mixed + in_plane_strain, "0.499999975", fine),
              0.002 * 0.375 * 3. * 16.4326);
}



TEST(CooksMembrane, MixedDoesNotLockAndDisplacementDoes)
{
  const std::string nu   = "0.49999";
  const double reference = tip_displacement(mixed + in_plane_strain, nu, fine);
  // the same limit by another element
  EXPECT_NEAR(tip_displacement(quadratic + in_plane_strain, nu, fine),
              reference,
              0.01 * reference);
  // 8 x 8 cells
  EXPECT_NEAR(tip_displacement(mixed + in_plane_strain, nu, 3),
              reference,
              0.02 * reference);
  EXPECT_LT(tip_displacement(linear + in_plane_strain, nu, 3), 0.5 * reference);
  EXPECT_LT(tip_displacement(linear + in_plane_strain, nu, 5), 0.7 * reference);
}



TEST(CooksMembrane, MixedIsIndifferentToTheLastDigitsOfThePoissonRatio)
{
  const double first = tip_displacement(mixed + in_plane_strain, "0.4999", 4);
  const double last = tip_displacement(mixed + in_plane_strain, "0.4999999", 4);
  EXPECT_NEAR(first, last, 2e-3 * last);
}
