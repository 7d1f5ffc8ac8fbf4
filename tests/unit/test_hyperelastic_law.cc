// SPDX-License-Identifier: GPL-2.0-or-later
// Laws of rubber: published stresses of homogeneous states, derivatives,
// small strains, and the continuation beyond the stretch of use.
#include "hyperelastic_constants.h"

#include <gtest/gtest.h>

#include <functional>

using namespace MixedCracks;
using namespace MixedCracks::Testing;
using dealii::Tensor;

namespace
{
  using Law       = const HyperelasticLaw &;
  using Constants = const HyperelasticConstants &;

  void
  for_all_laws(
    const std::function<void(const std::string &, Law, Constants)> &test,
    const double largest_stretch = 5.)
  {
    for (const auto &[name, constants] : rubber_constants())
      for (const bool isochoric : {false, true})
      {
        SCOPED_TRACE(name + (isochoric ? ", isochoric" : ""));
        const auto law =
          all_hyperelastic_laws().make(name, {largest_stretch, isochoric});
        ASSERT_EQ(law->problem(constants), "");
        test(isochoric ? "isochoric " + name : name, *law, constants);
      }
  }

  double
  energy(Law law, Constants constants, const Tensor<2, 3> &F)
  {
    return law.energy(Deformation(F), constants);
  }

  // P_11 where the third direction is free of stress and J = 1: what is left
  // when the pressure of an incompressible body is eliminated
  double
  nominal_stress(Law law, Constants constants, const Tensor<2, 3> &F)
  {
    const auto P = law.response(Deformation(F), constants, false).stress;
    return P[0][0] - P[2][2] * F[2][2] / F[0][0];
  }

  // largest difference between a tangent and central differences of the stress
  double
  tangent_error(Law law, Constants constants, const Tensor<2, 3> &F)
  {
    const double h     = 1e-6;
    const auto tangent = law.response(Deformation(F), constants, true).tangent;
    double     error   = 0.;
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int l = 0; l < 3; ++l)
      {
        Tensor<2, 3> plus = F, minus = F;
        plus[k][l] += h;
        minus[k][l] -= h;
        const auto quotient =
          (law.response(Deformation(plus), constants, false).stress -
           law.response(Deformation(minus), constants, false).stress) /
          (2. * h);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            error =
              std::max(error, std::abs(quotient[i][j] - tangent[i][j][k][l]));
      }
    return error;
  }

  double
  asymmetry(const Tensor<4, 3> &tangent)
  {
    double largest = 0.;
    for (unsigned int i = 0; i < 81; ++i)
    {
      const unsigned int a = i / 27, b = i / 9 % 3, c = i / 3 % 3, d = i % 3;
      largest =
        std::max(largest, std::abs(tangent[a][b][c][d] - tangent[c][d][a][b]));
    }
    return largest;
  }
} // namespace



// else none of the tests would see it
TEST(HyperelasticLaw, EveryOneHasConstantsToBeTestedWith)
{
  for (const std::string &name : all_hyperelastic_laws().names())
  {
    EXPECT_EQ(rubber_constants().count(name), 1u) << name;
    EXPECT_EQ(nominal_stresses().count(name), 1u) << name;
  }
}



// the form does not matter where J = 1
TEST(HyperelasticLaw, MeetsTheNominalStressesOfHomogeneousStates)
{
  const double root = std::sqrt(0.5);
  for_all_laws([&](const std::string &name, Law law, Constants constants) {
    const auto &stress = nominal_stresses().at(name.substr(name.find(' ') + 1));
    const std::vector<Tensor<2, 3>> states = {
      diagonal(2., root, root), diagonal(2., 1., 0.5), diagonal(2., 2., 0.25)};
    for (unsigned int i = 0; i < 3; ++i)
      EXPECT_NEAR(
        nominal_stress(law, constants, states[i]) / stress[i], 1., 1e-6);
  });
}



TEST(HyperelasticLaw, DerivativesMatchSacado)
{
  for_all_laws([](const std::string &name, Law law, Constants constants) {
    const bool        isochoric = name.rfind("isochoric", 0) == 0;
    const std::string plain     = name.substr(isochoric ? 10 : 0);
    for (const auto &F : random_deformations(4, 0.6))
    {
      const auto exact = differentiate(
        [&](const std::vector<Active> &x) {
          return active_energy(plain, constants, isochoric, x, F);
        },
        entries(F));
      const auto found = law.response(Deformation(F), constants, true);
      EXPECT_NEAR(found.energy, exact.value, 1e-12);
      EXPECT_NEAR(energy(law, constants, F), exact.value, 1e-12);
      for (unsigned int i = 0; i < 9; ++i)
      {
        EXPECT_NEAR(found.stress[i / 3][i % 3], exact.first[i], 1e-10);
        for (unsigned int k = 0; k < 9; ++k)
          EXPECT_NEAR(found.tangent[i / 3][i % 3][k / 3][k % 3],
                      exact.second[i][k],
                      1e-8);
      }
      EXPECT_LT(asymmetry(found.tangent), 1e-12);
    }
  });
}



// Ogden's quotients: equal stretches, nearly equal ones, far beyond the
// stretch of use, and across it
TEST(HyperelasticLaw, TangentsMatchDifferencesAtRepeatedStretches)
{
  const Tensor<2, 3>              Q      = rotation(0.7);
  const std::vector<Tensor<2, 3>> states = {
    diagonal(1., 1., 1.),
    diagonal(1., 1. + 1e-9, 1.),
    diagonal(1.4, 1.4, 1.4),
    diagonal(2., 2., 0.25),
    Q * diagonal(2., 2. * (1. + 1e-12), 0.25),
    diagonal(2., 2. * (1. + 1e-5), 0.3) * Q,
    Q * diagonal(0.7, 2., 0.7) * rotation(-0.3),
    diagonal(7., 7., 0.4),
    diagonal(7., 4.9, 0.4),
    diagonal(5.1, 4.9, 0.4) * Q};
  for_all_laws([&](const std::string &, Law law, Constants constants) {
    for (const auto &F : states)
    {
      const auto tangent =
        law.response(Deformation(F), constants, true).tangent;
      EXPECT_LT(tangent_error(law, constants, F), 2e-8 * (1. + tangent.norm()));
      EXPECT_LT(asymmetry(tangent), 1e-13 * (1. + tangent.norm()));
    }
  });
}



TEST(HyperelasticLaw, OutOfPlaneDerivativesAreThoseOfTheResponse)
{
  for_all_laws([](const std::string &, Law law, Constants constants) {
    for (const auto &F : random_deformations(10, 0.7, true))
    {
      const Deformation here(F);
      const auto        all = law.response(here, constants, true);
      const auto        out = law.out_of_plane(here, constants);
      EXPECT_NEAR(out.first, all.stress[2][2], 1e-12);
      EXPECT_NEAR(out.second, all.tangent[2][2][2][2], 1e-11);
    }
  });
}



// d2W~/dF dF at F = I: lambda_W d_iJ d_kL + mu (d_ik d_JL + d_iL d_Jk), and no
// stress
TEST(HyperelasticLaw, IsLinearElasticityAtSmallStrains)
{
  for_all_laws([](const std::string &, Law law, Constants constants) {
    const auto found =
      law.response(Deformation(diagonal(1., 1., 1.)), constants, true);
    EXPECT_LT(found.stress.norm(), 1e-15);
    EXPECT_EQ(found.energy, 0.);
    EXPECT_NEAR(found.tangent[0][0][0][0],
                law.lambda(constants) + 2. * law.mu(constants),
                1e-14);
    EXPECT_NEAR(found.tangent[0][0][1][1], law.lambda(constants), 1e-14);
    EXPECT_NEAR(found.tangent[0][1][0][1], law.mu(constants), 1e-14);
    EXPECT_NEAR(found.tangent[0][1][1][0], law.mu(constants), 1e-14);
    // the energy of a tiny shear has its digits
    Tensor<2, 3> shear = diagonal(1., 1., 1.);
    shear[0][1]        = 1e-6;
    EXPECT_NEAR(
      energy(law, constants, shear) / law.mu(constants), 0.5e-12, 1e-18);
  });
}



// beyond the stretch of use energy, stress and slope of P are those of
// neo-Hooke: no barrier, and P/lambda heads for a constant
TEST(HyperelasticLaw, GoesOnAsNeoHookeBeyondTheStretchOfUse)
{
  const auto uniaxial = [](const double stretch) {
    return diagonal(stretch, 1. / std::sqrt(stretch), 1. / std::sqrt(stretch));
  };
  for_all_laws([&](const std::string &name, Law law, Constants constants) {
    const auto stress = [&](const double stretch) {
      return law.response(Deformation(uniaxial(stretch)), constants, false)
        .stress[0][0];
    };
    EXPECT_NEAR(stress(5. + 1e-9), stress(5. - 1e-9), 1e-7);
    EXPECT_NEAR(energy(law, constants, uniaxial(5. + 1e-9)),
                energy(law, constants, uniaxial(5. - 1e-9)),
                1e-6);
    EXPECT_NEAR(stress(200.) / stress(100.), 2., 0.02);
    const auto equibiaxial = [&](const double stretch) {
      return energy(
        law, constants, diagonal(stretch, stretch, 1. / (stretch * stretch)));
    };
    // Ogden's negative alpha still count in the third, compressed direction
    if (name.find("Ogden") == std::string::npos)
    {
      EXPECT_NEAR(equibiaxial(200.) / equibiaxial(100.), 4., 0.3);
    }
    double last = 0.;
    for (double stretch = 1.01; stretch < 60.; stretch *= 1.05)
    {
      EXPECT_GT(stress(stretch), last);
      last = stress(stretch);
      const auto tangent =
        law.response(Deformation(uniaxial(stretch)), constants, true).tangent;
      EXPECT_LT(tangent_error(law, constants, uniaxial(stretch)),
                1e-6 * tangent.norm());
    }
  });
}



TEST(HyperelasticLaw, IsTheSameForRotatedStates)
{
  const Tensor<2, 3> Q = rotation(1.1), R = rotation(-0.4);
  for_all_laws([&](const std::string &, Law law, Constants constants) {
    for (const auto &F : random_deformations(6, 0.6))
    {
      const auto P = law.response(Deformation(F), constants, false);
      const auto turned =
        law.response(Deformation(Q * F * R), constants, false);
      EXPECT_NEAR(turned.energy, P.energy, 1e-13);
      EXPECT_LT((turned.stress - Q * P.stress * R).norm(), 1e-12);
    }
  });
}



TEST(HyperelasticLaw, TensileEnergyIsAllOfItWhereAllStretchesAreAboveOne)
{
  for_all_laws([](const std::string &name, Law law, Constants constants) {
    EXPECT_EQ(law.is_sum_over_stretches(),
              name.find("Ogden") != std::string::npos ||
                name.find("neo-Hooke") != std::string::npos);
    if (!law.is_sum_over_stretches() || name.find(' ') != std::string::npos)
      return;
    const auto tensile = [&](const double a, const double b, const double c) {
      return law.tensile_energy(Deformation(diagonal(a, b, c)), constants);
    };
    EXPECT_NEAR(tensile(2., 1.5, 1.1),
                energy(law, constants, diagonal(2., 1.5, 1.1)),
                1e-14);
    EXPECT_EQ(tensile(0.5, 0.8, 0.9), 0.);
    EXPECT_NEAR(tensile(2., 0.8, 0.9),
                energy(law, constants, diagonal(2., 1., 1.)),
                1e-14);
  });
}



TEST(HyperelasticLaw, NamesWhatIsWrongWithConstants)
{
  const auto problem = [](const std::string           &name,
                          const HyperelasticConstants &constants) {
    return all_hyperelastic_laws().make(name, {5., false})->problem(constants);
  };
  EXPECT_NE(problem("neo-Hooke", {{0.}}).find("mu"), std::string::npos);
  EXPECT_NE(problem("Mooney-Rivlin", {{0.5, -0.1}}), "");
  EXPECT_NE(problem("Mooney-Rivlin", {{0., 0.}}), "");
  EXPECT_NE(problem("Yeoh", {{-1.}}).find("C10"), std::string::npos);
  EXPECT_NE(problem("Yeoh", {{0.5, -0.2, 0.002}}), "");
  EXPECT_NE(problem("Gent", {{1., 0.}}).find("Jm"), std::string::npos);
  EXPECT_NE(problem("Ogden", {{1., 0.}}).find("alpha1"), std::string::npos);
  EXPECT_NE(problem("Ogden", {{-1., 2.}}), "");
  EXPECT_NE(problem("Ogden", {{-1., -2.}}), "");
  EXPECT_EQ(problem("Gent", {{1., 5.}}), "");
}
