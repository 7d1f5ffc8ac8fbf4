// SPDX-License-Identifier: GPL-2.0-or-later
#include "body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  struct Variant
  {
    std::string  law        = "relaxed bulk";
    std::string  kinematics = "plane strain";
    double       relaxation = 1.;
    double       lambda     = 2593.4;
    double       h_over_l   = 0.5;
    unsigned int n_rows     = 1;
    std::string  formulation = "mixed";
    std::string  split = "volumetric-deviatoric";
    std::string  deviator = "auto";
  };

  double
  remaining(const Variant &v, double length)
  {
    const double h = v.h_over_l * length;
    std::ostringstream prm;
    prm << "Geometry/Name = rectangle\n"
           "Geometry/Rectangle/Upper corner = 20, 28\n"
           "Geometry/Rectangle/Cell size = " << h
        << "\nModel/Formulation = " << v.formulation
        << "\nModel/Displacement degree = " << (v.formulation=="mixed" ? "2" : "1")
        << "\nModel/Kinematics = " << v.kinematics
        << "\nModel/Deviator dimension = " << v.deviator
        << "\nModel/Energy split = " << v.split
        << "\nModel/Pressure law = " << v.law
        << "\nModel/Relaxation = " << v.relaxation
        << "\nModel/Length scale = " << length
        << "\nModel/Residual stiffness = 1e-4\n"
           "Material/Shear modulus = 2.4\nMaterial/Lame lambda = " << v.lambda
        << "\nBoundary conditions/Displacement = top : all : 0; bottom : x : 0; bottom : y : -t\n";
    Body body(prm.str());
    body.solve();
    const double intact = body.reaction("top")[1];
    const CrackDensity &density = body.material->crack_density();
    body.set_phase_field([&](const dealii::Point<2> &x) {
      const double above = x[1] - 14.;
      const double distance = std::max(-above, above - (v.n_rows-1)*h);
      return distance < 1e-8 ? 0. : density.optimal_profile(distance / length);
    });
    const auto o = body.solve();
    const double f = body.reaction("top")[1];
    std::cout << v.law << ", " << v.kinematics << ", n " << v.deviator << ", c " << v.relaxation << ", lambda " << v.lambda
      << ", h/l " << v.h_over_l << ", l " << length << ", rows " << v.n_rows << " " << v.formulation << " " << v.split << ": " << f/intact << " (intact " << intact
      << ", newton " << o.iterations << ", p max " << (v.formulation=="mixed"?body.pressure_range().second:0) << ")" << std::endl;
    return f / intact;
  }
}

TEST(CrackOpening, Explore)
{
  for (double l : {0.5, 1., 2., 4.})
  {
    Variant v;
    if (l >= 1.) { remaining(v, l); v.deviator = "2"; remaining(v, l); v.deviator = "auto"; }
    Variant w; w.lambda = 2.4; w.formulation = "displacement"; w.law = "degraded bulk";
    remaining(w, l);
    w.formulation = "mixed"; if (l>=1.) remaining(w, l);
  }
}
