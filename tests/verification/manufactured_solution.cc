// SPDX-License-Identifier: GPL-2.0-or-later
// Mixed elasticity (Q2-Q1, plane strain, intact) against a manufactured
// solution, from compressible to nearly incompressible. On the unit square
//   u = curl(sin(pi x) sin(pi y)) / pi + grad(chi) / lambda,
//   p = lambda div u = laplace(chi) = mu sin(pi x) sin(pi y),
// so that p does not grow with lambda. Body force, prescribed displacement and
// traction are entered as expressions, as a .prm has them.
#include "body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  using dealii::numbers::PI;

  constexpr double mu = 2.4; // MPa

#ifdef DEBUG
  const std::vector<unsigned int> refinements = {1, 2, 3, 4};
#else
  const std::vector<unsigned int> refinements = {2, 3, 4, 5};
#endif

  // Displacement, and the pressure as third component
  class ExactSolution : public dealii::Function<2>
  {
  public:
    explicit ExactSolution(const double lambda)
      : dealii::Function<2>(3)
      , gradient_part(-mu / (2. * PI * lambda))
    {}

    double
    value(const dealii::Point<2> &x,
          const unsigned int      component) const override
    {
      const double sx = std::sin(PI * x[0]), cx = std::cos(PI * x[0]);
      const double sy = std::sin(PI * x[1]), cy = std::cos(PI * x[1]);
      switch (component)
      {
        case 0:
          return sx * cy + gradient_part * cx * sy;
        case 1:
          return -cx * sy + gradient_part * sx * cy;
        default:
          return mu * sx * sy;
      }
    }

  private:
    const double gradient_part;
  };

  std::string
  text(const double number)
  {
    std::ostringstream stream;
    stream.precision(17);
    stream << '(' << number << ')';
    return stream.str();
  }

  // The .prm with the loads that belong to the exact solution: displacement
  // prescribed but for the right edge, which carries its traction.
  std::string
  case_for(const double lambda, const unsigned int refinement)
  {
    const std::string a  = text(-mu / (2. * PI * lambda));
    const std::string ux = "sin(pi*x)*cos(pi*y)+" + a + "*cos(pi*x)*sin(pi*y)";
    const std::string uy = "-cos(pi*x)*sin(pi*y)+" + a + "*sin(pi*x)*cos(pi*y)";
    // -div(2 mu eps + p I); the divergence-free part is an eigenfunction of
    // the Laplacian, the gradient part gives 2 mu / lambda times grad p
    const std::string curl = text(2. * PI * PI * mu);
    const std::string grad = text(-(2. * mu / lambda + 1.) * PI * mu);
    const std::string fx =
      curl + "*sin(pi*x)*cos(pi*y)+" + grad + "*cos(pi*x)*sin(pi*y)";
    const std::string fy =
      "-" + curl + "*cos(pi*x)*sin(pi*y)+" + grad + "*sin(pi*x)*cos(pi*y)";
    // 2 mu du_x/dx + p and mu (du_x/dy + du_y/dx) on x = 1
    const std::string tx = text(2. * mu * PI) + "*cos(pi*x)*cos(pi*y)";
    const std::string ty =
      text(2. * mu * PI) + "*" + a + "*cos(pi*x)*cos(pi*y)";

    std::string prescribed;
    for (const std::string boundary : {"left", "bottom", "top"})
      prescribed +=
        boundary + " : x : " + ux + ";" + boundary + " : y : " + uy + ";";
    return "Geometry/Name = rectangle\n"
           "Geometry/Rectangle/Cell size = 1\n"
           "Mesh/Global refinements = " +
           std::to_string(refinement) +
           "\nModel/Formulation = mixed\n"
           "Model/Kinematics = plane strain\n"
           "Material/Lame lambda = " +
           std::to_string(lambda) + "\nMaterial/Shear modulus = 2.4\n" +
           "Boundary conditions/Displacement = " + prescribed +
           "\nBoundary conditions/Body force = x : " + fx + "; y : " + fy +
           "\nBoundary conditions/Traction = right : x : " + tx +
           "; right : y : " + ty + "\n";
  }

  void
  check_orders(const double ratio)
  {
    SCOPED_TRACE("lambda / mu = " + std::to_string(ratio));
    const ExactSolution exact(ratio * mu);
    double              displacement = 0., pressure = 0.;
    for (const unsigned int refinement : refinements)
    {
      Body body(case_for(ratio * mu, refinement));
      EXPECT_EQ(body.solve().iterations, 1u); // linear
      const double new_displacement = body.error(exact, 0, 2);
      const double new_pressure     = body.error(exact, 2, 1);
      if (refinement != refinements.front())
      {
        const double displacement_order =
          std::log2(displacement / new_displacement);
        const double pressure_order = std::log2(pressure / new_pressure);
        // orders of the finest two differences count, the first is on its way
        if (refinement > refinements[1])
        {
          EXPECT_GE(displacement_order, 2.9);
          EXPECT_GE(pressure_order, 1.9);
        }
        if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
          std::cout << "lambda/mu " << ratio << ", h = 1/" << (1 << refinement)
                    << ": u " << new_displacement << " order "
                    << displacement_order << ", p " << new_pressure << " order "
                    << pressure_order << '\n';
      }
      displacement = new_displacement;
      pressure     = new_pressure;
    }
    EXPECT_LT(displacement, 1e-4);
    EXPECT_LT(pressure, 1e-2 * mu);
  }
} // namespace



TEST(ManufacturedSolution, ConvergesWhenCompressible)
{
  check_orders(1.);
}



TEST(ManufacturedSolution, ConvergesAtRatio100)
{
  check_orders(1e2);
}



TEST(ManufacturedSolution, ConvergesAtRatio10000)
{
  check_orders(1e4);
}



TEST(ManufacturedSolution, ConvergesWhenNearlyIncompressible)
{
  check_orders(1e6);
}
