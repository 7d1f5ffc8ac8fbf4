// SPDX-License-Identifier: GPL-2.0-or-later
// Constants of hyperelastic laws: what the .prm says against the values at
// points, for a pair, for a law, for material ids, and what is refused.
#include <base/errors.h>

#include <problem/material_field.h>

#include <gtest/gtest.h>

using namespace MixedCracks;

namespace
{
  using dealii::Point;

  StrainParameters
  finite(const std::string &law)
  {
    StrainParameters strains;
    strains.strains_name = "finite";
    strains.law          = law;
    return strains;
  }

  // K = 1000 beside constants of a law
  MaterialParameters
  rubber(const StrainParameters &strains, const std::string &constants)
  {
    MaterialParameters parameters;
    parameters.take_strains_from(strains);
    parameters.bulk_modulus           = "1000";
    parameters.hyperelastic_constants = constants;
    return parameters;
  }

  std::string
  refusal(const MaterialParameters &parameters)
  {
    try
    {
      parameters.check();
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }
} // namespace



TEST(LawConstants, OfALawSayWhatMuIs)
{
  const StrainParameters   yeoh = finite("Yeoh");
  const MaterialParameters given =
    rubber(yeoh, "C30 = 0.001, C10 = 2*0.5, C20=-0.01");
  given.check();
  EXPECT_FALSE(given.varies());
  const MaterialValues values = given.uniform_values();
  EXPECT_DOUBLE_EQ(values.elastic.mu, 2.);
  EXPECT_NEAR(values.elastic.bulk_modulus(), 1000., 1e-9);
  EXPECT_EQ(values.hyperelastic,
            (HyperelasticConstants{{1., -0.01, 0.001, 0., 0., 0.}}));
}



TEST(LawConstants, NeoHookeTakesAPairOrMu)
{
  const StrainParameters neo_hooke = finite("neo-Hooke");
  const MaterialValues   by_mu = rubber(neo_hooke, "mu=2.4").uniform_values();
  MaterialParameters     pair  = rubber(neo_hooke, "");
  pair.shear_modulus           = "2.4";
  pair.check();
  const MaterialValues by_pair = pair.uniform_values();
  EXPECT_DOUBLE_EQ(by_mu.elastic.mu, 2.4);
  EXPECT_DOUBLE_EQ(by_mu.elastic.lambda, by_pair.elastic.lambda);
  pair.hyperelastic_constants = "mu=2.4";
  EXPECT_NE(refusal(pair).find("Shear modulus"), std::string::npos);
}



TEST(LawConstants, TermsOfOgdenThatAreNotGivenAreNothing)
{
  const StrainParameters ogden = finite("Ogden");
  const MaterialValues   values =
    rubber(ogden, "mu1=1.5, alpha1=2").uniform_values();
  EXPECT_DOUBLE_EQ(values.elastic.mu, 1.5);
  EXPECT_EQ(values.hyperelastic[2], 0.);
  EXPECT_EQ(values.hyperelastic[4], 0.);
  EXPECT_NE(refusal(rubber(ogden, "mu1=1, alpha1=2, alpha3=1")).find("mu3"),
            std::string::npos);
}



TEST(LawConstants, VaryAndAreReplacedByMaterialIds)
{
  const StrainParameters yeoh  = finite("Yeoh");
  MaterialParameters     given = rubber(yeoh, "C10 = 1 + x, C20 = 0, C30 = 0");
  given.by_material_id = "3 : C10 = 5 ; 4 : Poisson ratio = 0.25, C10 = 2";
  given.check();
  EXPECT_TRUE(given.varies());
  const MaterialField<2> field(given, nullptr);
  EXPECT_DOUBLE_EQ(field(Point<2>(2., 0.), 0).elastic.mu, 6.);
  EXPECT_DOUBLE_EQ(field(Point<2>(2., 0.), 3).elastic.mu, 10.);
  EXPECT_NEAR(field(Point<2>(2., 0.), 4).elastic.lambda, 4., 1e-12);
}



TEST(LawConstants, ThatMakeNoMaterialAreRefused)
{
  const auto expect = [](const std::string &law,
                         const std::string &constants,
                         const std::string &part) {
    const StrainParameters strains = finite(law);
    const std::string      message = refusal(rubber(strains, constants));
    EXPECT_NE(message.find(part), std::string::npos)
      << "'" << part << "' is not in: " << message;
  };
  expect("Yeoh", "", "C10, C20, C30");
  expect("Yeoh", "C10=1, C20=0", "C30 is missing");
  expect("Yeoh", "C10=1, C01=0", "unknown 'C01'");
  expect("Yeoh", "C10=-1, C20=0, C30=0", "C10");
  expect("Gent", "mu=1, Jm=20", "Model/Largest stretch");
  EXPECT_NE(
    refusal(rubber(StrainParameters(), "C10=1")).find("Strains = small"),
    std::string::npos);
}



TEST(StrainParameters, AllowWhatTheStrainsHave)
{
  const StrainParameters small, yeoh = finite("Yeoh"), ogden = finite("Ogden");
  EXPECT_NO_THROW(small.check("spectral", "degraded divergence"));
  EXPECT_NO_THROW(yeoh.check("none", "cubic"));
  EXPECT_NO_THROW(ogden.check("principal stretches", "relaxed bulk"));
  EXPECT_THROW(small.check("volumetric", "relaxed bulk"), InputError);
  EXPECT_THROW(small.check("none", "cubic"), InputError);
  EXPECT_THROW(yeoh.check("spectral", "relaxed bulk"), InputError);
  EXPECT_THROW(yeoh.check("none", "degraded bulk"), InputError);
  EXPECT_THROW(yeoh.check("principal stretches", "relaxed bulk"), InputError);
}
