// SPDX-License-Identifier: GPL-2.0-or-later
// Does a crack open? [model.md, section 3]
//
//      u_x = 0, u_y = 0      A strip of 20 x 28 mm is cut right through by the
//     +--------------+       optimal profile of Wu's functional,
//     |              |       phi = sin(|y - 14| / l), one row of nodes at 0,
//     and
//     |~~~~ phi ~~~~~|       pulled. What force remains, compared with that of
//     |              |       the intact strip? An open crack would leave
//     +--------------+       nothing; the figures say how much every pressure
//      u_x = 0, u_y = -t     law still transmits.
//
// The figures depend on l / 28 mm; l = 0.636 mm reproduces those that a
// separate trial code gave for one row of nodes at 0.
#include "body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr double       height        = 28.; // mm
  constexpr unsigned int n_coarse_rows = 22;
  constexpr double       cell_size     = height / n_coarse_rows / 4; // at l/2
  constexpr double       length_scale  = 2. * cell_size;

  struct Variant
  {
    std::string  law;
    std::string  kinematics;
    double       remaining;        // measured fraction of the intact force
    unsigned int cells_per_length; // l / h
    double       relaxation = 1.;
    double       lambda     = 2593.4; // MPa
    unsigned int n_rows     = 1;      // of nodes at phi = 0
    double       kappa      = 1e-4;
  };

  std::string
  name(const Variant &variant)
  {
    std::ostringstream text;
    text << variant.law << ", " << variant.kinematics << ", h = l/"
         << variant.cells_per_length << ", c = " << variant.relaxation
         << ", lambda = " << variant.lambda << ", " << variant.n_rows
         << " row(s) at 0, kappa = " << variant.kappa;
    return text.str();
  }

  // fine cells along the crack only
  std::string
  case_for(const Variant &variant)
  {
    std::ostringstream prm;
    prm << "Geometry/Name = rectangle\n"
           "Geometry/Rectangle/Upper corner = 20, 28\n"
           "Geometry/Rectangle/Cell size = "
        << height / n_coarse_rows << "\nMesh/Refined boxes = 0,"
        << 0.5 * height - 1.8 * length_scale << " : 20, "
        << 0.5 * height + 1.8 * length_scale + cell_size << " : "
        << (variant.cells_per_length == 2 ? 2 : 3)
        << "\nModel/Formulation = mixed\n"
           "Model/Kinematics = "
        << variant.kinematics << "\nModel/Pressure law = " << variant.law
        << "\nModel/Relaxation constant = " << variant.relaxation
        << "\nModel/Energy split = volumetric-deviatoric\n"
           "Model/Length scale = "
        << length_scale << "\nModel/Residual stiffness = " << variant.kappa
        << "\nMaterial/Shear modulus = 2.4\n"
           "Material/Lame lambda = "
        << variant.lambda
        << "\nBoundary conditions/Displacement = top : all : 0; "
           "bottom : x : 0; bottom : y : -t\n";
    return prm.str();
  }

  // the intact strip is the same for every pressure law
  double
  intact_force(Body &body, const Variant &variant)
  {
    static std::map<std::tuple<std::string, unsigned int, double>, double>
               known;
    const auto key = std::make_tuple(
      variant.kinematics, variant.cells_per_length, variant.lambda);
    const auto found = known.find(key);
    if (found != known.end())
      return found->second;
    body.solve();
    return known[key] = body.reaction("top")[1];
  }

  void
  expect_remaining(const Variant &variant)
  {
    SCOPED_TRACE(name(variant));
    Body                body(case_for(variant));
    const double        intact  = intact_force(body, variant);
    const CrackDensity &density = body.material->crack_density();
    const double        width =
      (variant.n_rows - 1) * length_scale / variant.cells_per_length;
    body.set_phase_field([&](const dealii::Point<2> &x) {
      const double above    = x[1] - 0.5 * height;
      const double distance = std::max(-above, above - width);
      return distance < 1e-8 ? 0.
                             : density.optimal_profile(distance / length_scale);
    });
    body.solve();
    const double remaining = body.reaction("top")[1] / intact;
    EXPECT_NEAR(remaining, variant.remaining, 0.02);
    EXPECT_NEAR(body.reaction("bottom")[1] / intact, remaining, 1e-7);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << name(variant) << ": " << remaining << ", largest p "
                << body.pressure_range().second << '\n';
    else
      body.pressure_range();
  }

  const std::string strain = "plane strain", stress = "plane stress";

  const std::vector<Variant> figures = {
    {"relaxed bulk", strain, 0.40, 2},
    {"relaxed bulk", strain, 0.26, 4},
    {"relaxed bulk", stress, 0.51, 2},
    {"relaxed bulk", stress, 0.35, 4},
    {"degraded divergence", strain, 0.774, 2},
    {"degraded divergence", strain, 0.517, 4},
    {"degraded divergence", stress, 0.45, 2},
    {"degraded divergence", stress, 0.29, 4},
    {"degraded bulk", strain, 0.937, 2},
    {"degraded bulk", strain, 0.935, 4},
    {"degraded bulk", stress, 0.605, 2},
    {"degraded bulk", stress, 0.442, 4},
  };
} // namespace



TEST(CrackOpening, HasAFigureForEveryPressureLawInBothKinematics)
{
  for (const std::string &law : all_pressure_laws().names())
    for (const std::string &kinematics : {strain, stress})
      for (const unsigned int cells : {2, 4})
      {
        bool found = false;
        for (const Variant &variant : figures)
          found |= variant.law == law && variant.kinematics == kinematics &&
                   variant.cells_per_length == cells;
        EXPECT_TRUE(found) << "measure what '" << law << "' leaves in "
                           << kinematics << " at h = l/" << cells
                           << " and add it to the list, and to doc/";
      }
}



TEST(CrackOpening, AtHalfTheLengthScale)
{
  for (const Variant &variant : figures)
    if (variant.cells_per_length == 2)
      expect_remaining(variant);
}



TEST(CrackOpening, AtAQuarterOfTheLengthScale)
{
  for (const Variant &variant : figures)
    if (variant.cells_per_length == 4)
      expect_remaining(variant);
}



TEST(CrackOpening, OfARelaxationConstantBelowOne)
{
  expect_remaining({"relaxed bulk", strain, 0.35, 2, 0.2});
}



TEST(CrackOpening, OfACompressibleMaterial)
{
  // lambda = mu, where nothing can lock: what is left comes from h and l alone
  expect_remaining({"relaxed bulk", strain, 0.54, 2, 1., 2.4});
  expect_remaining({"relaxed bulk", strain, 0.38, 4, 1., 2.4});
  expect_remaining({"degraded bulk", strain, 0.574, 2, 1., 2.4});
}



TEST(CrackOpening, OfAFullyBrokenRowOfCells)
{
  // Only the residual stiffness is left in it, and the constraint of "degraded
  // bulk", which never fades: that law holds an incompressible strip together
  // whatever is broken.
  expect_remaining({"relaxed bulk", strain, 0.005, 2, 1., 2593.4, 2});
  expect_remaining({"relaxed bulk", strain, 0.118, 2, 1., 2593.4, 2, 0.003});
  expect_remaining({"degraded divergence", strain, 0.004, 2, 1., 2593.4, 2});
  expect_remaining({"degraded bulk", strain, 0.556, 2, 1., 2593.4, 2});
}
