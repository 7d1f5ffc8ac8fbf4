// SPDX-License-Identifier: GPL-2.0-or-later
// Rubber at one point: figures of homogeneous states, F_33 of plane stress,
// the onset of damage, the limit of small strains, objectivity, energies and
// their derivatives, and what is left of broken material.
#include "finite_materials.h"
#include "strains.h"

#include <model/energy_interpolation.h>
#include <model/material.h>
#include <model/plane_stress.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;
using namespace MixedCracks::Testing;
using dealii::Tensor;

namespace
{
  // lateral stretch in the plane for which P_22 = 0, by bisection
  double
  uniaxial_lateral(const FiniteStrain<2> &law,
                   const PointConstants  &at,
                   const double           stretch)
  {
    double lower = 0.01, upper = 2.;
    for (int i = 0; i < 200; ++i)
    {
      const double middle = 0.5 * (lower + upper);
      const double P_22 =
        law.eliminated(stretched(stretch, middle), 1., at, false).stress[1][1];
      (P_22 > 0. ? upper : lower) = middle;
    }
    return 0.5 * (lower + upper);
  }

  // stretch of a homogeneous uniaxial state at which phi = 1 stops being the
  // solution
  double
  damage_threshold(const double mu)
  {
    MaterialDescription description = rubber("neo-Hooke", 1e6 * mu);
    description.constants           = PointConstants{1e6 * mu, mu, 17.};
    description.residual_stiffness  = 1e-4;
    description.plane_stress        = true;
    const Material<2>     material(description);
    const PointConstants &at  = material.uniform_constants();
    double                low = 1., high = 10.;
    for (int i = 0; i < 60; ++i)
    {
      const double middle = 0.5 * (low + high);
      const auto   gradient =
        stretched(middle, uniaxial_lateral(material.finite(), at, middle));
      const double D =
        material.driving_force(gradient, material.pressure(gradient, 1.), 1.);
      (material.phase_field_force(1., D, at) > 0. ? high : low) = middle;
    }
    return high;
  }
} // namespace



TEST(FiniteStrain, MeetsNominalStressesInPlaneStress)
{
  for_all_rubbers<2>(1e6, [&](const MaterialDescription &material) {
    if (!material.plane_stress)
      return;
    const FiniteStrain<2> law(material);
    const PointConstants &at = *material.constants;
    const auto  &stress      = nominal_stresses().at(material.hyperelastic_law);
    const double lateral[3]  = {uniaxial_lateral(law, at, 2.), 1., 2.};
    for (unsigned int i = 0; i < 3; ++i)
      EXPECT_NEAR(
        law.eliminated(stretched(2., lateral[i]), 1., at, false).stress[0][0] /
          stress[i],
        1.,
        1e-5);
  });
}



// (M14): cubic, lambda' = 1000, mu = 1, J_2 = 2, kappa = 0
TEST(FiniteStrain, MeetsTheThicknessesOfTheCubicLaw)
{
  MaterialDescription description = rubber("neo-Hooke", 1000. + 2. / 3.);
  description.residual_stiffness  = 0.;
  description.pressure_law        = "cubic";
  description.plane_stress        = true;
  const FiniteStrain<2>                        law(description);
  const PointConstants                        &at = *description.constants;
  const auto                                   gradient = stretched(2., 1.);
  const std::vector<std::pair<double, double>> expected = {
    {1., 0.5003745}, {0.5, 0.5058834}, {0.1, 0.9195959}, {0.01, 0.9999900}};
  for (const auto &[phi, stretch] : expected)
  {
    const double g = phi * phi, b = std::pow(phi, 3);
    const double p = law.pressure(gradient, g, at);
    EXPECT_NEAR(neo_hooke_thickness(g, 1000. * b * b, 2.), stretch, 1e-6);
    // what is broken further has gamma < 1
    if (phi >= 0.5)
    {
      EXPECT_NEAR(
        law.deformation_gradient(gradient, p, g, at)[2][2], stretch, 1e-6);
    }
  }
}



// Broken material is linear, convex and finite for every deformation, but not
// where a split makes it resist closure.
TEST(FiniteStrain, BrokenMaterialIsLinear)
{
  for_all_rubbers<2>(200., [](const MaterialDescription &material) {
    const FiniteStrain<2> law(material);
    const PointConstants &at       = *material.constants;
    const auto            gradient = stretched(-2., 3.);
    const double          g        = 0.02;
    const auto            found    = law.eliminated(gradient, g, at, true);
    if (material.energy_split == "volumetric")
    {
      EXPECT_TRUE(std::isnan(found.stress[0][0]));
      EXPECT_LT(law.determinant(gradient, g), 0.);
      return;
    }
    const double modulus = linear_modulus(
      *all_hyperelastic_laws().make(
        material.hyperelastic_law,
        {material.largest_stretch, material.volumetric_form != "coupled"}),
      at.hyperelastic);
    if (material.hyperelastic_law == "neo-Hooke")
    {
      EXPECT_NEAR(modulus, at.mu, 1e-13);
    }
    const double stiffness = g * modulus;
    EXPECT_EQ(law.determinant(gradient, g), 1.);
    EXPECT_LT((found.stress - stiffness * gradient).norm(), 1e-13);
    EXPECT_NEAR(law.eliminated_energy(gradient, g, at),
                0.5 * stiffness * gradient.norm_square(),
                1e-13);
    EXPECT_NEAR(law.driving_force(gradient, 0., g, at),
                modulus * gradient.norm_square(),
                1e-12);
    EXPECT_NEAR(found.finite->stress_by_gradient[0][1][0][1], stiffness, 1e-13);
    EXPECT_NEAR(found.finite->stress_by_gradient[0][0][1][1], 0., 1e-13);
    // from there to the law without a jump
    for (const double edge : {0.04, 0.25})
    {
      const auto mild = stretched(1.1, 0.95);
      EXPECT_LT((law.eliminated(mild, edge + 1e-9, at, true).stress -
                 law.eliminated(mild, edge - 1e-9, at, true).stress)
                  .norm(),
                1e-6);
    }
  });
}



TEST(FiniteStrain, MeetsTheOnsetOfDamage)
{
  EXPECT_NEAR(damage_threshold(2.40), 4.190, 4.190e-3);
  EXPECT_NEAR(damage_threshold(1.18), 5.764, 5.764e-3);
}



// without tension there is no end to the search, nor a crash
TEST(FiniteStrain, IsNotDefinedWhereMaterialIsInsideOut)
{
  for_all_rubbers<2>(20., [](const MaterialDescription &material) {
    const FiniteStrain<2> law(material);
    const PointConstants &at       = *material.constants;
    const auto            gradient = stretched(-0.3, 1.);
    EXPECT_TRUE(
      std::isnan(law.mixed(gradient, 0.1, 0.5, at, true).stress[0][0]));
    EXPECT_TRUE(
      std::isnan(law.eliminated(gradient, 0.5, at, true).stress[0][0]));
    EXPECT_EQ(law.eliminated_energy(gradient, 0.5, at),
              std::numeric_limits<double>::infinity());
    EXPECT_LT(law.determinant(gradient, 1.), 0.);
  });
}



TEST(FiniteStrain, StaysFiniteWithoutResidualStiffness)
{
  for_all_rubbers<2>(2000., [](MaterialDescription material) {
    material.residual_stiffness = 0.;
    const FiniteStrain<2> law(material);
    const PointConstants &at = *material.constants;
    for (const double stretch : {0.3, 1., 3., 100.})
    {
      const auto   gradient = stretched(stretch, 1.);
      const double p        = law.pressure(gradient, 0., at);
      const auto   response = law.eliminated(gradient, 0., at, true);
      EXPECT_TRUE(std::isfinite(p));
      EXPECT_TRUE(std::isfinite(response.finite->stress_by_gradient.norm()));
      EXPECT_TRUE(std::isfinite(law.mixed(gradient, p, 0., at, true)
                                  .finite->stress_by_gradient.norm()));
      EXPECT_TRUE(std::isfinite(law.driving_force(gradient, p, 0., at)));
      EXPECT_TRUE(std::isfinite(law.elastic_energy(gradient, p, 0., at)));
      if (stretch > 1. || material.energy_split != "volumetric")
      {
        EXPECT_LT(response.stress.norm(), 1e-6);
      }
    }
  });
}



// P(QF) = Q P(F), and a rotation changes no energy
TEST(FiniteStrain, IsFrameIndifferent)
{
  Tensor<2, 2> Q;
  Q[0][0] = Q[1][1] = std::cos(1.3);
  Q[0][1]           = -std::sin(1.3);
  Q[1][0]           = std::sin(1.3);
  for_all_rubbers<2>(20., [&](const MaterialDescription &material) {
    const FiniteStrain<2> law(material);
    const PointConstants &at = *material.constants;
    for (const auto &gradient : random_gradients<2>(3, 0.5))
    {
      const auto   I      = stretched(2., 2.);
      const auto   turned = Q * (gradient + I) - I;
      const double p      = law.pressure(gradient, 0.4, at);
      const auto   here   = law.eliminated(gradient, 0.4, at, false);
      EXPECT_NEAR(law.pressure(turned, 0.4, at), p, 1e-12);
      EXPECT_LT(
        (law.eliminated(turned, 0.4, at, false).stress - Q * here.stress)
          .norm(),
        1e-11);
      EXPECT_LT((law.mixed(turned, 0.2, 0.4, at, false).stress -
                 Q * law.mixed(gradient, 0.2, 0.4, at, false).stress)
                  .norm(),
                1e-11);
      EXPECT_NEAR(law.eliminated_energy(turned, 0.4, at),
                  law.eliminated_energy(gradient, 0.4, at),
                  1e-12);
      EXPECT_NEAR(law.driving_force(turned, p, 0.4, at),
                  law.driving_force(gradient, p, 0.4, at),
                  1e-11);
    }
  });
}



// the potential's derivatives are stress and constraint, those of the
// eliminated energy the stress
TEST(FiniteStrain, DerivesFromItsPotential)
{
  const double h = 1e-5;
  for_all_rubbers<2>(20., [&](const MaterialDescription &material) {
    for (const double g : {0.1, 0.4})
    {
      const FiniteStrain<2> law(material);
      const PointConstants &at = *material.constants;
      const auto potential     = [&](const auto &gradient, const double p) {
        const auto parts = law.potential(gradient, p, g, at);
        return parts.distortion + p * parts.volume_change -
               0.5 * parts.compliance * p * p;
      };
      for (const auto &gradient : random_gradients<2>(2, 0.4))
        for (const double p : {-0.4, 0.3})
        {
          const auto found = law.mixed(gradient, p, g, at, false);
          const auto alone = law.eliminated(gradient, g, at, false);
          EXPECT_NEAR(
            (potential(gradient, p + h) - potential(gradient, p - h)) /
              (2. * h),
            found.constraint,
            1e-8 * (1. + found.constraint * found.constraint));
          for (unsigned int i = 0; i < 2; ++i)
            for (unsigned int j = 0; j < 2; ++j)
            {
              Tensor<2, 2> step;
              step[i][j] = h;
              EXPECT_NEAR((potential(gradient + step, p) -
                           potential(gradient - step, p)) /
                            (2. * h),
                          found.stress[i][j],
                          1e-7 * (1. + std::abs(found.stress[i][j])));
              EXPECT_NEAR((law.eliminated_energy(gradient + step, g, at) -
                           law.eliminated_energy(gradient - step, g, at)) /
                            (2. * h),
                          alone.stress[i][j],
                          1e-7);
            }
        }
    }
  });
}



// at the pressure of the constraint the formulations are one material
TEST(FiniteStrain, EliminationAgreesWithTheMixedForm)
{
  for_all_rubbers<3>(200., [](const MaterialDescription &material) {
    const FiniteStrain<3> law(material);
    const PointConstants &at = *material.constants;
    for (const auto &gradient : random_gradients<3>(3, 0.4))
      for (const double g : {0.01, 0.1, 0.5, 1.})
      {
        const double p     = law.pressure(gradient, g, at);
        const auto   mixed = law.mixed(gradient, p, g, at, false);
        EXPECT_NEAR(mixed.constraint, 0., 1e-13);
        EXPECT_LT(
          (mixed.stress - law.eliminated(gradient, g, at, false).stress).norm(),
          1e-11);
        EXPECT_NEAR(law.elastic_energy(gradient, p, g, at),
                    law.eliminated_energy(gradient, g, at),
                    1e-11);
        // that of linear material is not Cauchy's
        if (g < 0.25)
          continue;
        EXPECT_NEAR(law.pressure_after(p, g, 0.3, at, gradient),
                    law.pressure(gradient, 0.3, at),
                    1e-11);
        const auto F = law.deformation_gradient(gradient, p, g, at);
        EXPECT_LT((Tensor<2, 3>(law.cauchy_stress(gradient, p, g, at)) -
                   mixed.stress * transpose(F) / determinant(F))
                    .norm(),
                  1e-11);
      }
  });
}



// in plane stress p follows g and F_33, not lambda_d alone
TEST(FiniteStrain, PressureAfterIsThatOfTheNewDegradation)
{
  for_all_rubbers<2>(2000., [](const MaterialDescription &material) {
    const FiniteStrain<2> law(material);
    const PointConstants &at       = *material.constants;
    const auto            gradient = stretched(1.8, 0.9);
    const double          p        = law.pressure(gradient, 0.9, at);
    EXPECT_NEAR(law.pressure_after(p, 0.9, 0.3, at, gradient) /
                  law.pressure(gradient, 0.3, at),
                1.,
                1e-9);
    EXPECT_EQ(law.pressure_after(p, 0.9, 0.9, at, gradient), p);
    EXPECT_EQ(law.pressure_after(0., 0.9, 0.3, at, gradient), 0.);
  });
}



TEST(FiniteStrain, OnlyStretchesAboveOneDriveWithPrincipalStretches)
{
  MaterialDescription   description = rubber("Ogden", 20.);
  const FiniteStrain<3> whole(description);
  description.energy_split = "principal stretches";
  const FiniteStrain<3> part(description);
  const PointConstants &at = *description.constants;
  for (const auto &gradient : random_gradients<3>(5, 0.4))
  {
    EXPECT_EQ(part.eliminated(gradient, 0.5, at, true).stress,
              whole.eliminated(gradient, 0.5, at, true).stress);
    EXPECT_LT(part.driving_force(gradient, 0.1, 0.5, at),
              whole.driving_force(gradient, 0.1, 0.5, at));
    EXPECT_GE(part.driving_force(gradient, -0.1, 0.5, at), 0.);
  }
  description.hyperelastic_law        = "Yeoh";
  description.constants->hyperelastic = rubber_constants().at("Yeoh");
  EXPECT_THROW(FiniteStrain<3>{description}, InputError);
}



TEST(FiniteStrain, RefusesWhatItDoesNotKnow)
{
  MaterialDescription description = rubber("neo-Hooke", 20.);
  description.pressure_law        = "degraded bulk";
  EXPECT_THROW(FiniteStrain<2>{description}, InputError);
  description              = rubber("neo-Hooke", 20.);
  description.energy_split = "spectral";
  EXPECT_THROW(FiniteStrain<2>{description}, InputError);
  description                   = rubber("Mooney-Rivlin", 20.);
  description.constants->lambda = 0.3;
  EXPECT_THROW(FiniteStrain<2>{description}, InputError);
  description                 = rubber("neo-Hooke", 20.);
  description.largest_stretch = 1.;
  EXPECT_THROW(FiniteStrain<2>{description}, InputError);
}



TEST(FiniteStrain, MaterialPassesOn)
{
  const MaterialDescription description = rubber("Gent", 20.);
  const Material<2>         material(description);
  const FiniteStrain<2>     law(description);
  const PointConstants     &at       = *description.constants;
  const auto                gradient = stretched(1.5, 0.9);
  EXPECT_TRUE(material.is_finite());
  EXPECT_TRUE(material.mixed_is_symmetric());
  EXPECT_FALSE(material.is_linear_when_intact());
  EXPECT_EQ(material.tangent_regime(gradient, 0.1), -1);
  EXPECT_EQ(material.mixed(gradient, 0.1, 0.5).stress,
            law.mixed(gradient, 0.1, 0.5, at, true).stress);
  EXPECT_EQ(material.eliminated(gradient, 0.5).finite->stress_by_gradient,
            law.eliminated(gradient, 0.5, at, true).finite->stress_by_gradient);
  EXPECT_EQ(material.pressure(gradient, 0.5), law.pressure(gradient, 0.5, at));
  EXPECT_EQ(material.elastic_energy(gradient, 0.1, 0.5),
            law.elastic_energy(gradient, 0.1, 0.5, at));
}
