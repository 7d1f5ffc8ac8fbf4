// SPDX-License-Identifier: GPL-2.0-or-later
// Pressure laws: coefficients are the derivatives of the printed equations
// (M7), (M8), and every law is linear elasticity where nothing is damaged.
#include "automatic_differentiation.h"

#include <model/pressure_law.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  const PointConstants      constants{2593.4, 2.4, 1.};
  constexpr double          relaxation   = 0.7;
  const std::vector<double> degradations = {1e-4, 0.03, 0.5, 0.97, 1.};

  // Momentum pressure, constraint and driving pressure as functions of
  // x = (tr eps, p), as printed in model.md
  struct Equations
  {
    using Function =
      std::function<Active(const std::vector<Active> &x, double g)>;
    Function momentum;
    Function constraint;
    Function driving;
  };

  Active
  degraded(const Active &p, const double g)
  {
    const Active tension = positive_part(p);
    return g * tension + (p - tension);
  }

  const std::map<std::string, Equations> equations = {
    {"relaxed bulk",
     {[](const std::vector<Active> &x, double) -> Active { return x[1]; },
      [](const std::vector<Active> &x, const double g) -> Active {
        return x[0] - x[1] / constants.lambda -
               (1. - g) / (g * relaxation * constants.mu) * positive_part(x[1]);
      },
      [](const std::vector<Active> &x, const double g) -> Active {
        return positive_part(x[1]) / g;
      }}},
    {"degraded divergence",
     {[](const std::vector<Active> &x, const double g) -> Active {
        return degraded(x[1], g);
      },
      [](const std::vector<Active> &x, const double g) -> Active {
        return g * x[0] - x[1] / constants.lambda;
      },
      [](const std::vector<Active> &x, double) -> Active {
        return positive_part(x[1]);
      }}},
    {"degraded bulk",
     {[](const std::vector<Active> &x, const double g) -> Active {
        return degraded(x[1], g);
      },
      [](const std::vector<Active> &x, double) -> Active {
        return x[0] - x[1] / constants.lambda;
      },
      [](const std::vector<Active> &x, double) -> Active {
        return positive_part(x[1]);
      }}}};
} // namespace



TEST(PressureLaw, MatchesTheEquationsThroughSacado)
{
  for (const auto &[name, law] : equations)
    for (const double g : degradations)
      for (const double p : {3.1, -3.1})
      {
        SCOPED_TRACE(name + ", g = " + std::to_string(g));
        const bool                 tension = p > 0.;
        const PressureCoefficients found =
          all_pressure_laws().make(name)->coefficients(
            constants, relaxation, g, tension);
        const double volume_change = 1e-3;
        const auto   exact         = [&](const Equations::Function &function) {
          return differentiate(
            [&](const std::vector<Active> &x) { return function(x, g); },
            {volume_change, p});
        };
        const Derivatives momentum   = exact(law.momentum);
        const Derivatives constraint = exact(law.constraint);
        EXPECT_NEAR(found.stress * p, momentum.value, 1e-14);
        EXPECT_NEAR(found.stress, momentum.first[1], 1e-15);
        EXPECT_NEAR(found.divergence * volume_change - found.compliance * p,
                    constraint.value,
                    1e-12 * (1. + std::abs(constraint.value)));
        EXPECT_NEAR(found.divergence, constraint.first[0], 1e-15);
        EXPECT_NEAR(-found.compliance / constraint.first[1], 1., 1e-14);
        if (tension)
        {
          EXPECT_NEAR(found.driving * p / exact(law.driving).value, 1., 1e-14);
        }
      }
}



TEST(PressureLaw, IntactMaterialIsLinearlyElastic)
{
  for (const std::string &name : all_pressure_laws().names())
    for (const bool tension : {true, false})
    {
      SCOPED_TRACE(name);
      const PressureCoefficients law =
        all_pressure_laws().make(name)->coefficients(
          constants, relaxation, 1., tension);
      EXPECT_DOUBLE_EQ(law.stress, 1.);
      EXPECT_DOUBLE_EQ(law.divergence, 1.);
      EXPECT_DOUBLE_EQ(law.compliance, 1. / constants.lambda);
      EXPECT_DOUBLE_EQ(law.driving, 1.);
      EXPECT_DOUBLE_EQ(law.eliminated_stiffness(), constants.lambda);
    }
}



TEST(PressureLaw, IsSymmetricWhenItSaysSo)
{
  for (const std::string &name : all_pressure_laws().names())
  {
    SCOPED_TRACE(name);
    const auto law         = all_pressure_laws().make(name);
    bool       coincidence = true;
    for (const double g : degradations)
      for (const bool tension : {true, false})
      {
        const PressureCoefficients found =
          law->coefficients(constants, relaxation, g, tension);
        coincidence = coincidence && found.stress == found.divergence;
      }
    EXPECT_EQ(law->is_symmetric(), coincidence);
  }
}



TEST(PressureLaw, StiffnessFadesInTensionOnly)
{
  for (const std::string &name : all_pressure_laws().names())
  {
    SCOPED_TRACE(name);
    const auto law       = all_pressure_laws().make(name);
    double     softer    = 0.;
    double     transmits = 0.;
    for (const double g : degradations)
    {
      const PressureCoefficients tension =
        law->coefficients(constants, relaxation, g, true);
      const PressureCoefficients closed =
        law->coefficients(constants, relaxation, g, false);
      EXPECT_GT(tension.eliminated_stiffness(), softer);
      EXPECT_GE(tension.stress / tension.compliance, transmits);
      EXPECT_LE(tension.eliminated_stiffness(),
                closed.eliminated_stiffness() * (1. + 1e-15));
      EXPECT_DOUBLE_EQ(closed.stress, 1.);
      EXPECT_DOUBLE_EQ(closed.compliance, 1. / constants.lambda);
      softer    = tension.eliminated_stiffness();
      transmits = tension.stress / tension.compliance;
    }
    EXPECT_LT(law->coefficients(constants, relaxation, 1e-8, true)
                .eliminated_stiffness(),
              1e-6 * constants.lambda);
  }
}



// (M8): for small g the bulk stiffness is c g mu, however large lambda is
TEST(PressureLaw, RelaxedBulkFadesWithTheShearStiffness)
{
  const double g         = 1e-3;
  const auto   stiffness = [g](const double lambda) {
    return all_pressure_laws()
      .make("relaxed bulk")
      ->coefficients({lambda, 2.4, 1.}, 0.7, g, true)
      .eliminated_stiffness();
  };
  EXPECT_NEAR(stiffness(1e6) / (0.7 * g * 2.4), 1., 2e-3);
  EXPECT_NEAR(stiffness(1e6) / stiffness(1e9), 1., 1e-6);
}
