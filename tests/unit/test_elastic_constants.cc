// SPDX-License-Identifier: GPL-2.0-or-later
// Elastic constants: every pair gives Lame's pair back, everything else is
// refused by name.
#include <base/errors.h>

#include <model/elastic_constants.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace MixedCracks;

namespace
{
  struct Constant
  {
    std::optional<double> GivenElasticConstants::*entry;
    std::string                                   name;
    double                                        value;
  };

  std::vector<Constant>
  all_constants(const ElasticConstants &elastic)
  {
    using Given = GivenElasticConstants;
    return {
      {&Given::lame_lambda, "Material/Lame lambda", elastic.lambda},
      {&Given::shear_modulus, "Material/Shear modulus", elastic.mu},
      {&Given::youngs_modulus,
       "Material/Young's modulus",
       elastic.youngs_modulus()},
      {&Given::poisson_ratio,
       "Material/Poisson ratio",
       elastic.poisson_ratio()},
      {&Given::bulk_modulus, "Material/Bulk modulus", elastic.bulk_modulus()}};
  }

  // The message of the refusal, or "accepted"
  std::string
  refusal(const GivenElasticConstants &given)
  {
    try
    {
      elastic_constants(given);
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "accepted";
  }

  void
  expect_contains(const std::string &text, const std::string &part)
  {
    EXPECT_NE(text.find(part), std::string::npos)
      << "'" << part << "' is missing in: " << text;
  }
} // namespace



TEST(ElasticConstants, EveryPairGoesRound)
{
  for (const double ratio : {1e-3, 0.4, 1., 7., 1080., 1e6})
  {
    const ElasticConstants elastic{2.4 * ratio, 2.4};
    const auto             constants = all_constants(elastic);
    for (std::size_t i = 0; i < constants.size(); ++i)
      for (std::size_t j = i + 1; j < constants.size(); ++j)
      {
        SCOPED_TRACE(constants[i].name + " and " + constants[j].name +
                     ", lambda/mu = " + std::to_string(ratio));
        GivenElasticConstants given;
        given.*constants[i].entry   = constants[i].value;
        given.*constants[j].entry   = constants[j].value;
        const ElasticConstants back = elastic_constants(given);
        // E and nu say little about lambda near incompressibility, and
        // lambda and K little about mu
        const double tolerance = 1e-14 * (10. + ratio + 1. / ratio);
        EXPECT_NEAR(back.lambda / elastic.lambda, 1., tolerance);
        EXPECT_NEAR(back.mu / elastic.mu, 1., tolerance);
      }
  }
}



// the root formula loses all digits of mu here unless it is rearranged
TEST(ElasticConstants, LambdaAndYoungsModulusKeepTheShearModulus)
{
  for (const double ratio : {1e-6, 1e6, 1e9})
  {
    const ElasticConstants elastic{2.4 * ratio, 2.4};
    GivenElasticConstants  given;
    given.lame_lambda    = elastic.lambda;
    given.youngs_modulus = elastic.youngs_modulus();
    EXPECT_NEAR(elastic_constants(given).mu / elastic.mu, 1., 1e-14);
  }
}



TEST(ElasticConstants, TextbookValues)
{
  const ElasticConstants elastic{3., 2.};
  EXPECT_DOUBLE_EQ(elastic.youngs_modulus(), 5.2);
  EXPECT_DOUBLE_EQ(elastic.poisson_ratio(), 0.3);
  EXPECT_DOUBLE_EQ(elastic.bulk_modulus(), 13. / 3.);
}



// the two materials of [Mang21], as printed there
TEST(ElasticConstants, PrintedMaterialsAreReproduced)
{
  GivenElasticConstants neo_hooke;
  neo_hooke.youngs_modulus = 7.20;
  neo_hooke.bulk_modulus   = 2595.;
  EXPECT_NEAR(elastic_constants(neo_hooke).lambda, 2593.40, 0.005);
  EXPECT_NEAR(elastic_constants(neo_hooke).mu, 2.40, 0.005);

  GivenElasticConstants fit;
  fit.youngs_modulus = 3.54;
  fit.bulk_modulus   = 2595.;
  EXPECT_NEAR(elastic_constants(fit).lambda, 2594.21, 0.005);
  EXPECT_NEAR(elastic_constants(fit).mu, 1.18, 0.005);
}



TEST(ElasticConstants, OnlyExactlyTwoAreAccepted)
{
  const auto constants = all_constants({3., 2.});
  for (unsigned int selection = 0; selection < 32; ++selection)
  {
    GivenElasticConstants given;
    std::vector<Constant> chosen;
    for (unsigned int i = 0; i < constants.size(); ++i)
      if (selection & (1U << i))
      {
        given.*constants[i].entry = constants[i].value;
        chosen.push_back(constants[i]);
      }
    const std::string message = refusal(given);
    if (chosen.size() == 2)
    {
      EXPECT_EQ(message, "accepted");
      continue;
    }
    for (const Constant &constant : constants)
      expect_contains(message, constant.name);
    for (const Constant &constant : chosen)
      expect_contains(message, constant.name + " = ");
    expect_contains(message, "exactly two");
  }
}



TEST(ElasticConstants, ImpossibleValuesAreRefusedByName)
{
  const double infinity  = std::numeric_limits<double>::infinity();
  const auto   constants = all_constants({3., 2.});
  for (std::size_t i = 0; i < constants.size(); ++i)
    for (const double value : {0., -1., infinity, -infinity, std::nan("")})
    {
      GivenElasticConstants given;
      given.*constants[i].entry = value;
      const Constant &other     = constants[i == 0 ? 1 : 0];
      given.*other.entry        = other.value;
      const std::string message = refusal(given);
      expect_contains(message, constants[i].name + " = ");
      // refused for itself, not for what would follow from it
      expect_contains(message, "it must be");
    }
  for (const double ratio : {0.5, 0.7, 30.})
  {
    GivenElasticConstants given;
    given.poisson_ratio  = ratio;
    given.youngs_modulus = 1.;
    expect_contains(refusal(given), "smaller than 0.5");
  }
}



TEST(ElasticConstants, PairsWithoutAMaterialAreRefused)
{
  GivenElasticConstants incompressible; // E = 3 mu, up to rounding
  incompressible.shear_modulus  = 2.4;
  incompressible.youngs_modulus = 7.2;
  expect_contains(refusal(incompressible), "Material/Shear modulus = 2.4");
  expect_contains(refusal(incompressible), "Material/Young's modulus = 7.2");

  // ... and on the other side of it, where lambda comes out as 1e15
  incompressible.youngs_modulus = 7.2 * (1. - 1e-15);
  EXPECT_NE(refusal(incompressible), "accepted");

  GivenElasticConstants negative_lambda;
  negative_lambda.shear_modulus = 3.;
  negative_lambda.bulk_modulus  = 2.;
  EXPECT_NE(refusal(negative_lambda), "accepted");

  GivenElasticConstants negative_mu;
  negative_mu.lame_lambda  = 3.;
  negative_mu.bulk_modulus = 2.;
  EXPECT_NE(refusal(negative_mu), "accepted");

  GivenElasticConstants auxetic;
  auxetic.youngs_modulus = 9.;
  auxetic.bulk_modulus   = 1.;
  EXPECT_NE(refusal(auxetic), "accepted");
}



// (M6): a plate that is free to contract, E/(1-nu^2) in its plane
TEST(ElasticConstants, PlaneStressHasThePlateModulus)
{
  for (const double lambda : {0.1, 3., 2593.4})
  {
    const ElasticConstants elastic{lambda, 2.4};
    const ElasticConstants plane = plane_stress(elastic);
    const double           nu    = elastic.poisson_ratio();
    EXPECT_NEAR((plane.lambda + 2 * plane.mu) /
                  (elastic.youngs_modulus() / (1 - nu * nu)),
                1.,
                1e-13);
    EXPECT_EQ(plane.mu, elastic.mu);
  }
}
