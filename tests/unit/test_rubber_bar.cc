// SPDX-License-Identifier: GPL-2.0-or-later
// A bar of rubber in uniaxial tension, against closed formulas.
#include <gtest/gtest.h>

#include <simulation/rubber_bar.h>

#include <cmath>

using namespace MixedCracks;

namespace
{
  MaterialDescription
  rubber(const std::string           &law,
         const double                 mu,
         const HyperelasticConstants &constants)
  {
    MaterialDescription description;
    description.constants    = PointConstants{1000. * mu, mu, 17., constants};
    description.length_scale = 0.3;
    description.residual_stiffness = 0.;
    description.relaxation         = 1.;
    description.deviator_dimension = 3;
    description.crack_density      = "Wu";
    description.energy_split       = "none";
    description.pressure_law       = "relaxed bulk";
    description.strains            = Strains::finite;
    description.hyperelastic_law   = law;
    return description;
  }
} // namespace



// stretch 2, incompressible
TEST(RubberBar, HasTheNominalStressOfItsLaw)
{
  const auto stress = [](const MaterialDescription &material) {
    return RubberBar(material).nominal_stress(2.);
  };
  EXPECT_NEAR(stress(rubber("neo-Hooke", 1., {{1.}})), 1.75, 1e-6);
  EXPECT_NEAR(stress(rubber("Mooney-Rivlin", 1., {{0.4, 0.1}})), 1.575, 1e-6);
  EXPECT_NEAR(stress(rubber("Yeoh", 1., {{0.5, -0.02, 0.002}})), 1.554, 1e-6);
  EXPECT_NEAR(stress(rubber("Gent", 1., {{1., 30.}})), 1.875, 1e-6);
}



// G_c/(pi l) = 18.04 MPa
TEST(RubberBar, BreaksAtTheEnergyOfTheThreshold)
{
  const auto strength = [](const double mu) {
    return rubber_strength(RubberBar(rubber("neo-Hooke", mu, {{mu}})),
                           *all_crack_densities().make("Wu"),
                           *all_degradations().make("quadratic", 0.),
                           17. / 0.3);
  };
  EXPECT_NEAR(strength(2.40).stretch, 4.190, 1e-3);
  EXPECT_NEAR(
    strength(2.40).stress, 2.4 * (4.190 - 1. / (4.190 * 4.190)), 5e-3);
  EXPECT_NEAR(strength(1.18).stretch, 5.764, 1e-3);
}



TEST(RubberBar, FindsTheEnergyOfAnyStretch)
{
  const RubberBar bar(rubber("neo-Hooke", 1., {{1.}}));
  for (const double stretch : {1.001, 2., 50., 1e7})
    EXPECT_NEAR(bar.stretch_of_energy(bar.energy(stretch)) / stretch, 1., 1e-6);
}



TEST(RubberBar, ThatSoftensBeforeItsStretchOfUseIsFound)
{
  EXPECT_FALSE(
    RubberBar(rubber("neo-Hooke", 1., {{1.}})).stretch_of_decline(5.));
  EXPECT_FALSE(RubberBar(rubber("Yeoh", 2.0258, {{1.0129, -0.01226, 0.001033}}))
                 .stretch_of_decline(5.));
  const auto found = RubberBar(rubber("Yeoh", 1., {{0.5, -0.03, 0.0008}}))
                       .stretch_of_decline(5.);
  ASSERT_TRUE(found);
  EXPECT_GT(*found, 2.);
  EXPECT_LT(*found, 4.);
}
