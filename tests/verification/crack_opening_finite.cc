// SPDX-License-Identifier: GPL-2.0-or-later
// Does a crack open in rubber that is stretched far? [model.md, section 8]
//
// The strip of crack_opening.cc, 20 x 28 mm, with the profile of Wu's
// functional right across it, phi = sin(|y - 14| / l), one row of nodes at 0,
// at finite strain: neo-Hooke, mu = 2.4 MPa, lambda = 2593.4 MPa, mixed. It is
// pulled by 1 % and by 50 % of its height. The figures are the force that
// remains over that of the intact strip at the same displacement. 0 is ideal.
// They are less than at small strain, since the energy of broken cells is
// interpolated to one without a constraint.
#include "body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr double       height        = 28.; // mm
  constexpr unsigned int n_coarse_rows = 22;
  constexpr double       cell_size     = height / n_coarse_rows / 4;
  constexpr double       length_scale  = 2. * cell_size;

  const std::vector<double> stretched = {0.01, 0.5}; // of the height

  struct Law
  {
    std::string         name;
    std::string         kinematics;
    unsigned int        cells_per_length; // l / h
    std::vector<double> remaining;        // measured, at both of 'stretched'
  };

  std::string
  case_for(const Law &law)
  {
    std::ostringstream prm;
    prm << "Geometry/Name = rectangle\n"
           "Geometry/Rectangle/Upper corner = 20, 28\n"
           "Geometry/Rectangle/Cell size = "
        << height / n_coarse_rows << "\nMesh/Refined boxes = 0,"
        << 0.5 * height - 1.8 * length_scale << " : 20, "
        << 0.5 * height + 1.8 * length_scale + cell_size << " : "
        << (law.cells_per_length == 2 ? 2 : 3)
        << "\nModel/Strains = finite\n"
           "Model/Formulation = mixed\n"
           "Model/Kinematics = "
        << law.kinematics << "\nModel/Pressure law = " << law.name
        << "\nModel/Relaxation constant = 1\n"
           "Model/Energy split = none\n"
           "Model/Length scale = "
        << length_scale
        << "\nModel/Residual stiffness = 1e-4\n"
           "Material/Shear modulus = 2.4\n"
           "Material/Lame lambda = 2593.4\n"
           "Boundary conditions/Displacement = bottom : all : 0; top : x : 0; "
           "top : y : t\n";
    return prm.str();
  }

  // at both of 'stretched', on the way in steps of at most 3.5 %
  std::vector<double>
  forces(const Law &law, const bool is_cut)
  {
    Body body(case_for(law));
    if (is_cut)
      body.set_phase_field([&](const dealii::Point<2> &x) {
        return body.material->crack_density().optimal_profile(
          std::abs(x[1] - 0.5 * height) / length_scale);
      });
    std::vector<double> result;
    double              reached = 0.;
    for (const double stretch : stretched)
    {
      const unsigned int n_steps = std::ceil((stretch - reached) / 0.035);
      for (unsigned int i = 1; i <= n_steps; ++i)
        body.solve(height * (reached + (stretch - reached) * i / n_steps));
      reached = stretch;
      result.push_back(body.reaction("top")[1]);
    }
    return result;
  }

  void
  expect_remaining(const Law &law)
  {
    const std::string name = law.name + ", " + law.kinematics + ", h = l/" +
                             std::to_string(law.cells_per_length);
    SCOPED_TRACE(name);
    const std::vector<double> intact = forces(law, false),
                              cut    = forces(law, true);
    for (unsigned int i = 0; i < stretched.size(); ++i)
    {
      const double remaining = cut[i] / intact[i];
      EXPECT_NEAR(remaining, law.remaining[i], 0.02);
      if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << name << ", at " << stretched[i] << ": " << remaining
                  << '\n';
    }
  }
} // namespace



TEST(CrackOpeningFinite, OfRelaxedBulk)
{
  expect_remaining({"relaxed bulk", "plane strain", 2, {0.21, 0.344}});
  expect_remaining({"relaxed bulk", "plane strain", 4, {0.121, 0.203}});
  expect_remaining({"relaxed bulk", "plane stress", 2, {0.289, 0.393}});
  expect_remaining({"relaxed bulk", "plane stress", 4, {0.173, 0.242}});
}



TEST(CrackOpeningFinite, OfCubic)
{
  expect_remaining({"cubic", "plane strain", 2, {0.212, 0.348}});
  expect_remaining({"cubic", "plane strain", 4, {0.123, 0.207}});
  expect_remaining({"cubic", "plane stress", 2, {0.289, 0.394}});
  expect_remaining({"cubic", "plane stress", 4, {0.174, 0.243}});
}
