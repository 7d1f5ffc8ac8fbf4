// SPDX-License-Identifier: GPL-2.0-or-later
// Rubber at finite strain, elastic.
//  - Cook's membrane, plane strain: the trapezoid (0,0), (48,44), (48,60),
//    (0,44) mm, clamped on the left, a dead shear on the right edge, far into
//    the non-linear range. Nearly incompressible (E = 240.565 MPa, nu = 0.4999,
//    6.25 MPa), watched at (48,60): own calculations of an independent program,
//    done twice. Compressible (mu = 0.4225 MPa, nu = 0.3, 1 N in all), watched
//    at (48,52): published with the code gallery of deal.II.
//  - A thick-walled cylinder (plane strain) and sphere of incompressible
//    neo-Hooke material, inflated: r/R = l is the hoop stretch,
//
//      cylinder  P = mu   integral (l^2 - l^-2) dr/r,   r^2 - R^2 the same,
//      sphere    P = 2 mu integral (l^2 - l^-4) dr/r,   r^3 - R^3 the same,
//
//    from the inner to the outer radius; for B/A = 2 and inner stretches of 1.5
//    and 2 P/mu = 0.428228, 0.574054 and 0.755433, 0.806927.
#include "body.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  const double pi = dealii::numbers::PI;

  const std::string rubber = "Model/Strains = finite\n"
                             "Model/Hyperelastic law = neo-Hooke\n"
                             "Model/Energy split = none\n"
                             "Model/Pressure law = relaxed bulk\n"
                             "Model/Kinematics = plane strain\n";

  const std::string membrane =
    "Geometry/Name = quadrilateral\n"
    "Geometry/Quadrilateral/Corners = 0,0 ; 48,44 ; 48,60 ; 0,44\n"
    "Geometry/Quadrilateral/Cells = 1, 1\n"
    "Boundary conditions/Displacement = left : all : 0\n";

  const std::string stiff =
    "Material/Young's modulus = 240.565\n"
    "Material/Poisson ratio = 0.4999\n"
    "Boundary conditions/Traction = right : y : 6.25*t\n"
    "Model/Formulation = mixed\n";

  const std::string soft = "Material/Shear modulus = 0.4225\n"
                           "Material/Poisson ratio = 0.3\n"
                           "Boundary conditions/Traction = right : y : t/16\n"
                           "Model/Formulation = displacement\n"
                           "Model/Displacement degree = 2\n";

  std::string
  form(const std::string &name)
  {
    return "Model/Volumetric form = " + name + '\n';
  }

  const std::string coupled       = "coupled";
  const std::string isochoric     = "isochoric, K/2 (J-1)^2";
  const std::string isochoric_log = "isochoric, K/4 (J^2-1-2 ln J)";

  std::string
  refined(const unsigned int levels)
  {
    return "Mesh/Global refinements = " + std::to_string(levels) + '\n';
  }

  void
  print(const std::string &what, const double value)
  {
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << what << ": " << value << '\n';
  }

  // @p levels: 2^levels cells in each direction
  double
  membrane_displacement(const std::string      &material,
                        const unsigned int      levels,
                        const dealii::Point<2> &watched)
  {
    Body body(membrane + rubber + material + refined(levels));
    for (const double time : {0.5, 1.})
      body.solve(time);
    const double result = body.displacement_at(watched)[1];
    print("Cook's membrane, " + std::to_string(1 << levels) + " cells", result);
    return result;
  }

  // a thick wall between the radii 1 and 2 mm, mu = 1 MPa; boundaries and
  // supports are those of a box, the inner wall is 'left'
  const std::string wall = rubber + "Model/Formulation = mixed\n"
                                    "Material/Lame lambda = 1e5\n"
                                    "Material/Shear modulus = 1\n";

  // Pressure in the wall once the inner radius is @p stretch times the first
  // one, divided by mu. Forces times displacements are P (stretch - 1) times
  // the integral of X . n over the inside as it is then; that is
  // stretch^(dim-1) times dim times the volume in there, to which the volume of
  // the wall is as 2^dim - 1 to 1, polyhedra included.
  template <int dim>
  double
  pressure_in_wall(BodyIn<dim> &body, const double stretch)
  {
    body.solve(stretch - 1.);
    const double inside =
      dealii::GridTools::volume(body.triangulation, body.fields.mapping) /
      (std::pow(2., dim) - 1.);
    const double result =
      body.reaction_times_displacement() /
      ((stretch - 1.) * std::pow(stretch, dim - 1) * dim * inside);
    print(std::to_string(dim) + "-d wall, stretch " + std::to_string(stretch),
          result);
    return result;
  }
} // namespace



TEST(FiniteStrain, CooksMembraneCoupled)
{
  EXPECT_NEAR(
    membrane_displacement(stiff + form(coupled), 5, {48., 60.}), 6.924, 0.003);
}



TEST(FiniteStrain, CooksMembraneIsochoric)
{
  EXPECT_NEAR(membrane_displacement(stiff + form(isochoric), 5, {48., 60.}),
              6.932,
              0.003);
}



TEST(FiniteStrain, CooksMembraneCompressible)
{
  EXPECT_NEAR(membrane_displacement(soft + form(isochoric_log), 5, {48., 52.}),
              14.74,
              0.01);
}



TEST(FiniteStrain, MixedAndDisplacementAgreeWhereNothingLocks)
{
  const std::string mixed = "Material/Shear modulus = 0.4225\n"
                            "Material/Poisson ratio = 0.3\n"
                            "Boundary conditions/Traction = right : y : t/16\n"
                            "Model/Formulation = mixed\n";
  for (const std::string &kinematics :
       {std::string(), std::string("Model/Kinematics = plane stress\n")})
  {
    const double of_mixed =
      membrane_displacement(mixed + kinematics, 4, {48., 52.});
    EXPECT_NEAR(membrane_displacement(soft + kinematics, 4, {48., 52.}),
                of_mixed,
                2e-3 * of_mixed);
  }
}



// r_(k+1) <= C r_k^2 over the last three iterations, C being that of the first
// of them but for a factor
TEST(FiniteStrain, NewtonsMethodConvergesQuadratically)
{
  for (const std::string &material : {stiff + form(coupled), soft})
  {
    Body body(membrane + rubber + material + refined(3));
    body.solve(0.5);
    const std::vector<double> residuals = body.newton_history(1., 1e-11);
    for (const double residual : residuals)
      print("|R|", residual);
    ASSERT_LE(residuals.back(), 1e-11);
    // iterations that are in the quadratic range and above rounding
    unsigned int n_quadratic = 0;
    double       constant    = 0.;
    for (std::size_t k = 0; k + 1 < residuals.size(); ++k)
    {
      const double r = residuals[k], next = residuals[k + 1];
      if (r > 0.1 || next < 1e-12)
        continue;
      if (constant == 0.)
        constant = std::max(10. * next / (r * r), 10.);
      EXPECT_LE(next, constant * r * r);
      ++n_quadratic;
    }
    EXPECT_GE(n_quadratic, 2u);
    EXPECT_LE(residuals.size(), 9u);
  }
}



// A strip of 8 x 4 mm that is cut to its middle, pulled to twice its height and
// beyond: the cells of the cut, which carry with kappa only, are stretched far
// more. Nothing is turned inside out, and the cut takes from the force.
TEST(FiniteStrain, BrokenCellsAreStretchedFar)
{
  const double      length = 0.5;
  const std::string strip =
    "Geometry/Name = rectangle\n"
    "Geometry/Rectangle/Lower corner = 0, 0\n"
    "Geometry/Rectangle/Upper corner = 8, 4\n"
    "Geometry/Rectangle/Cells = 32, 16\n"
    "Model/Residual stiffness = 1e-4\n"
    "Material/Lame lambda = 1e3\n"
    "Material/Shear modulus = 1\n"
    "Boundary conditions/Displacement = bottom : all : 0; top : x : 0; "
    "top : y : t\n";
  for (const std::string &model :
       {std::string("Model/Formulation = mixed\n"),
        std::string("Model/Formulation = mixed\n"
                    "Model/Kinematics = plane stress\n"),
        std::string("Model/Formulation = displacement\n"
                    "Model/Displacement degree = 2\n"
                    "Model/Kinematics = plane stress\n")})
  {
    SCOPED_TRACE(model);
    double forces[2] = {0., 0.};
    for (const bool is_cut : {false, true})
    {
      Body body(rubber + strip + model);
      if (is_cut)
        body.set_phase_field([=](const dealii::Point<2> &p) {
          const double to_line = std::abs(p[1] - 2.);
          const double distance =
            p[0] < 4. ? to_line : std::hypot(to_line, p[0] - 4.);
          return distance < 0.5 * pi * length ? std::sin(distance / length)
                                              : 1.;
        });
      for (const double time : {1., 2., 3., 4., 5., 6.})
        body.solve(time);
      forces[is_cut] = body.reaction("top")[1];
    }
    print("intact", forces[0]);
    print("cut", forces[1]);
    EXPECT_GT(forces[1], 0.);
    EXPECT_LT(forces[1], 0.8 * forces[0]);
  }
}



TEST(FiniteStrain, ThickWalledCylinder)
{
  Body body(wall + "Boundary conditions/Displacement = left : x : x*t; "
                   "left : y : y*t; bottom : y : 0; top : x : 0\n"
                   "Geometry/Name = rectangle\n"
                   "Geometry/Rectangle/Lower corner = 1, 0\n"
                   "Geometry/Rectangle/Upper corner = 2, 1\n"
                   "Geometry/Rectangle/Cells = 12, 40\n",
            [](const dealii::Point<2> &p) {
              const double angle = 0.5 * pi * p[1];
              return dealii::Point<2>(p[0] * std::cos(angle),
                                      p[0] * std::sin(angle));
            });
  EXPECT_NEAR(pressure_in_wall(body, 1.5), 0.428228, 2e-3 * 0.428228);
  EXPECT_NEAR(pressure_in_wall(body, 2.), 0.574054, 2e-3 * 0.574054);
}



TEST(FiniteStrain, ThickWalledSphere)
{
  // an eighth; the ids of inside, outside, x = 0, y = 0 and z = 0 are those
  // that left, right, bottom, top and back have in a box
  const BodyIn<3>::MeshMaker eighth = [](const Geometry<3> &,
                                         dealii::Triangulation<3> &mesh) {
    dealii::GridGenerator::quarter_hyper_shell(
      mesh, dealii::Point<3>(), 1., 2., 0, /*colorize=*/true);
  };
  BodyIn<3> body(wall +
                   "Boundary conditions/Displacement = left : x : x*t; "
                   "left : y : y*t; left : z : z*t; "
                   "bottom : x : 0; top : y : 0; back : z : 0\n"
                   "Geometry/Name = box\n" +
                   refined(2),
                 eighth);
  EXPECT_NEAR(pressure_in_wall(body, 1.5), 0.755433, 1e-3 * 0.755433);
  EXPECT_NEAR(pressure_in_wall(body, 2.), 0.806927, 1e-3 * 0.806927);
}
