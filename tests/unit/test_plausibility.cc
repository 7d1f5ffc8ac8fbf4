// SPDX-License-Identifier: GPL-2.0-or-later
// Cases whose numbers cannot mean what a user wants are warned of, and others
// are not.
#include <deal.II/base/numbers.h>

#include <model/strength.h>

#include <simulation/simulation_plausibility.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace MixedCracks;

namespace
{
  // steel, a square of 1 mm with l = 0.02 mm, pulled by 1 %
  CaseScales
  sound_case()
  {
    MaterialRange steel{};
    steel.lambda                       = {121153.8, 121153.8};
    steel.mu                           = {80769.2, 80769.2}; // E = 210000
    steel.critical_energy_release_rate = {2.7, 2.7};
    CaseScales scales;
    scales.length_scale   = 0.02;
    scales.cell_size      = 0.01;
    scales.width          = 1.;
    scales.strength       = implied_strength("AT1", "quadratic", steel, 0.02);
    scales.onset_step     = 1e-3;
    scales.first.strain   = 1e-5;
    scales.largest.strain = 1e-2;
    return scales;
  }

  bool
  says(const std::vector<std::string> &sentences, const std::string &words)
  {
    for (const std::string &sentence : sentences)
      if (sentence.find(words) != std::string::npos)
        return true;
    return false;
  }
} // namespace



// peak of the even response, worked out by hand from the table of (M1)
TEST(Strength, IsThatOfTheClosedFormulas)
{
  const auto strength = [](const std::string &name) {
    return relative_strength(*all_crack_densities().make(name),
                             *all_degradations().make("quadratic", 0.));
  };
  EXPECT_NEAR(strength("AT1").stress, std::sqrt(3. / 8.), 1e-6);
  EXPECT_NEAR(strength("AT1").strain, std::sqrt(3. / 8.), 1e-3);
  EXPECT_NEAR(strength("AT2").stress, 3. * std::sqrt(3.) / 16., 1e-6);
  EXPECT_NEAR(strength("AT2").strain, std::sqrt(1. / 3.), 1e-3);
  EXPECT_NEAR(strength("Wu").stress, std::sqrt(2. / dealii::numbers::PI), 1e-6);
  EXPECT_NEAR(strength("Wu").strain, std::sqrt(2. / dealii::numbers::PI), 1e-3);
}



TEST(Strength, OfTheMaterialIsAsWideAsItsConstants)
{
  const CaseScales scales = sound_case();
  EXPECT_NEAR(scales.strength.stress.smallest,
              std::sqrt(3. / 8. * 210000. * 2.7 / 0.02),
              1.);
  EXPECT_FALSE(scales.strength.stress.varies());
  MaterialRange varied{};
  varied.lambda                       = {0., 0.}; // E = 2 mu
  varied.mu                           = {50., 200.};
  varied.critical_energy_release_rate = {1., 4.};
  const ImpliedStrength strength =
    implied_strength("AT1", "quadratic", varied, 1.);
  EXPECT_NEAR(strength.stress.smallest, std::sqrt(3. / 8. * 100.), 1e-3);
  EXPECT_NEAR(strength.stress.largest, std::sqrt(3. / 8. * 1600.), 1e-3);
  EXPECT_NEAR(strength.strain.smallest, std::sqrt(3. / 8. / 400.), 1e-3);
  EXPECT_NEAR(strength.strain.largest, std::sqrt(3. / 8. * 4. / 100.), 1e-3);
}



TEST(Plausibility, ASoundCaseIsNotWarnedOf)
{
  const CaseScales scales = sound_case();
  EXPECT_TRUE(warnings_about(scales).empty());
  EXPECT_EQ(remark_about(scales), "");
}



TEST(Plausibility, LengthScalesThatDoNotFitAreNamed)
{
  CaseScales scales   = sound_case();
  scales.length_scale = 10.; // 1000 h
  const auto found    = warnings_about(scales);
  EXPECT_TRUE(says(found, "l = 10 mm in a body 1 mm wide"));
  EXPECT_TRUE(says(found, "l/h = 1000"));
}



TEST(Plausibility, AMaterialThatBearsNothingIsNamed)
{
  CaseScales   scales    = sound_case();
  const double factor    = std::sqrt(1e-9 / 2.7); // G_c = 1e-9
  scales.strength.stress = {factor * scales.strength.stress.smallest,
                            factor * scales.strength.stress.largest};
  scales.strength.strain = {factor * scales.strength.strain.smallest,
                            factor * scales.strength.strain.largest};
  EXPECT_TRUE(says(warnings_about(scales), "less than any material bears"));
  EXPECT_TRUE(says(warnings_about(scales), "after one onset step of 0.001 s"));
  // fine steps do not help
  scales.first.strain = 0.;
  EXPECT_TRUE(says(warnings_about(scales), "until the end time"));
}



TEST(Plausibility, LoadsFarBeyondTheStrengthAreNamed)
{
  CaseScales   scales     = sound_case();
  const double strength   = scales.strength.stress.largest;
  scales.largest.traction = 99. * strength;
  EXPECT_TRUE(warnings_about(scales).empty());
  scales.largest.traction = 101. * strength;
  EXPECT_TRUE(
    says(warnings_about(scales), "101 times what the material bears"));
  scales.largest.traction = 0.;
  scales.largest.fluid    = 2. * strength;
  EXPECT_TRUE(warnings_about(scales).empty());
  scales.largest.fluid = 4. * strength;
  EXPECT_TRUE(says(warnings_about(scales), "Fluid/Pressure reaches 4 times"));
}



// who makes a material far too tough to break wants an elastic answer
TEST(Plausibility, ABodyThatWillNotBreakIsRemarkedOnOnly)
{
  CaseScales scales      = sound_case();
  scales.strength.stress = {1e12, 1e12};
  scales.strength.strain = {1e5, 1e5};
  EXPECT_TRUE(warnings_about(scales).empty());
  EXPECT_NE(remark_about(scales).find("nothing will break"), std::string::npos);
  // unless it is pulled that far, or something pulls that is not looked at
  scales.largest.is_known = false;
  EXPECT_EQ(remark_about(scales), "");
  scales.largest.strain = 1e3;
  EXPECT_TRUE(says(warnings_about(scales), "far beyond small strains"));
}



// an expression needs no value outside of its boundary
TEST(Plausibility, ALoadIsKnownWhereItHasAValueAnywhere)
{
  const auto size = [](const std::string &displacement,
                       const std::string &traction) {
    Parameters<2>            parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    prm.enter_subsection("Boundary conditions");
    prm.set("Displacement", displacement);
    prm.set("Traction", traction);
    prm.leave_subsection();
    const dealii::BoundingBox<2> body({{0., 0.}, {4., 1.}});
    return load_size(parameters, body, /*time=*/1.);
  };
  const LoadSize partly = size("top : y : t*sqrt(x-1)", "left : x : 3");
  EXPECT_TRUE(partly.is_known);
  EXPECT_NEAR(partly.strain, std::sqrt(3.) / 4., 1e-14);
  EXPECT_EQ(partly.traction, 3.);
  const LoadSize nowhere = size("top : y : t*sqrt(x-1)", "left : x : 1/(1-t)");
  EXPECT_FALSE(nowhere.is_known);
  EXPECT_EQ(nowhere.traction, 0.);
}



TEST(Plausibility, DamageOfTheWholeBodyIsThatOfTheFirstStepWithIt)
{
  const auto density = all_crack_densities().make("AT1");
  // phi = 0 all over a body of 3 mm^2 with l = 0.1: 3/8 / l * 3
  EXPECT_NEAR(damaged_share(3. / 8. / 0.1 * 3., 3., 0.1, *density), 1., 1e-14);
  EXPECT_EQ(damage_in_words({}, 1.), "");
  EXPECT_EQ(damage_in_words({0.1, 0.2, 0.4}, 1.), "");
  EXPECT_NE(damage_in_words({0.9, 0.95}, 1.).find("90 % of the body in step 0"),
            std::string::npos);
  EXPECT_NE(damage_in_words({0.1, 0.12, 0.97, 0.98}, 1.)
              .find("97 % of the body after step 2, 12 % before"),
            std::string::npos);
}



TEST(Plausibility, NoSentenceNamesANumberThatHasOverflown)
{
  MaterialRange stiff{};
  stiff.lambda                       = {1e300, 1e300};
  stiff.mu                           = {1e300, 1e300};
  stiff.critical_energy_release_rate = {1e300, 1e300};
  CaseScales scales                  = sound_case();
  scales.strength       = implied_strength("Wu", "quadratic", stiff, 1e-300);
  scales.length_scale   = 1e300;
  scales.cell_size      = 1e-300;
  scales.largest.strain = std::numeric_limits<double>::infinity();
  std::vector<std::string> sentences = warnings_about(scales);
  sentences.push_back(in_words(scales.strength));
  scales.strength = implied_strength("Wu", "quadratic", stiff, 1.);
  EXPECT_TRUE(std::isfinite(scales.strength.stress.largest));
  sentences.push_back(in_words(scales.strength));
  for (const char *const nonsense : {"inf", "nan"})
    EXPECT_FALSE(says(sentences, nonsense)) << nonsense;
}
