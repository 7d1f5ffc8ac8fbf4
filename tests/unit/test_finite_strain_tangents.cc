// SPDX-License-Identifier: GPL-2.0-or-later
// Stress, constraint and tangents at finite strain against automatic
// differentiation of the potential of (M13) and (M13b), for every law, form,
// pressure law, split, kinematics and formulation. F_33 and an eliminated p
// are condensed out of the Hessian here.
#include "finite_materials.h"

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;
using dealii::Tensor;

namespace
{
  using Matrix = std::vector<std::vector<double>>;

  struct Coefficients
  {
    double distortion, volume, compliance;
  };

  // (M13), (M13b) of the pressure of the undamaged part: p/g, p/b
  Coefficients
  coefficients(const MaterialDescription &material,
               const double               volumetric,
               const double               g,
               const bool                 tension)
  {
    const bool fades = tension || material.energy_split != "volumetric";
    if (!fades)
      return {g, 1., 1. / volumetric};
    if (material.pressure_law == "cubic")
    {
      const double phi = std::sqrt((g - rubber_kappa) / (1. - rubber_kappa));
      const double b   = (1. - rubber_kappa) * std::pow(phi, 3) + rubber_kappa;
      return {g, b * b, b * b / volumetric};
    }
    return {g,
            g,
            g * g / volumetric +
              g * (1. - g) / (rubber_relaxation * material.constants->mu)};
  }

  // the potential as a function of the nine entries of F and p
  Active
  potential(const MaterialDescription &material,
            const Coefficients        &c,
            const std::vector<Active> &x,
            const Tensor<2, 3>        &F)
  {
    const bool   isochoric = material.volumetric_form != "coupled";
    const Active W         = active_energy(material.hyperelastic_law,
                                   material.constants->hyperelastic,
                                   isochoric,
                                   x,
                                   F);
    const Active J         = ActiveDeformation(x).J;
    Active       theta     = J - 1.;
    if (material.volumetric_form.find("ln") != std::string::npos)
    {
      theta = std::sqrt(Active(0.5 * (J * J - 1.) - std::log(J)));
      if (determinant(F) < 1.)
        theta = Active(-theta);
    }
    return c.distortion * W + c.volume * x[9] * theta -
           0.5 * c.compliance * x[9] * x[9];
  }

  double
  volumetric_stiffness(const MaterialDescription &material)
  {
    const HyperelasticForm form{5., material.volumetric_form != "coupled"};
    return material.constants->lambda -
           all_hyperelastic_laws()
             .make(material.hyperelastic_law, form)
             ->lambda(material.constants->hyperelastic);
  }

  void
  eliminate(Matrix &hessian, const unsigned int index)
  {
    const Matrix before = hessian;
    for (unsigned int i = 0; i < 10; ++i)
      for (unsigned int j = 0; j < 10; ++j)
        hessian[i][j] -=
          before[i][index] * before[index][j] / before[index][index];
  }

  Derivatives
  exact_derivatives(const MaterialDescription &material,
                    const Tensor<2, 3>        &F,
                    const double               p,
                    const double               g)
  {
    const Coefficients c =
      coefficients(material, volumetric_stiffness(material), g, p > 0.);
    std::vector<double> point = entries(F);
    point.push_back(p);
    return differentiate(
      [&](const std::vector<Active> &x) {
        return potential(material, c, x, F);
      },
      point);
  }

  template <int dim>
  void
  expect_derivatives(const ElasticResponse<dim> &found,
                     const Derivatives          &exact,
                     const Matrix               &hessian,
                     const bool                  mixed,
                     const double                rounding)
  {
    const double size = 1. + found.finite->stress_by_gradient.norm();
    for (unsigned int i = 0; i < dim * dim; ++i)
    {
      const unsigned int a = i / dim, b = i % dim, row = 3 * a + b;
      EXPECT_NEAR(found.stress[a][b], exact.first[row], rounding * size);
      EXPECT_NEAR(found.finite->coupling[a][b],
                  mixed ? hessian[row][9] : 0.,
                  10. * rounding);
      for (unsigned int k = 0; k < dim * dim; ++k)
      {
        const unsigned int c = k / dim, d = k % dim;
        EXPECT_NEAR(found.finite->stress_by_gradient[a][b][c][d],
                    hessian[row][3 * c + d],
                    10. * rounding * size);
        EXPECT_NEAR(found.finite->stress_by_gradient[a][b][c][d],
                    found.finite->stress_by_gradient[c][d][a][b],
                    1e-13 * size);
      }
    }
    EXPECT_NEAR(found.constraint, mixed ? exact.first[9] : 0., rounding);
    EXPECT_NEAR(found.constraint_by_pressure,
                mixed ? hessian[9][9] : 0.,
                rounding * (1. + std::abs(hessian[9][9])));
  }

  template <int dim>
  void
  test_both_formulations(const MaterialDescription &material)
  {
    const FiniteStrain<dim> law(material);
    const PointConstants   &at = *material.constants;
    const double            g  = 0.3;
    // the exact stretches come from a cubic equation, which loses digits
    const double rounding = material.hyperelastic_law == "Ogden" ? 1e-8 : 1e-10;
    for (const auto &gradient : random_gradients<dim>(2, 0.4))
    {
      // within the stretch of use, which F_33 leaves soon if p compresses
      for (const double p : {-0.15 * at.mu, 0.3 * at.mu})
      {
        const auto F       = law.deformation_gradient(gradient, p, g, at);
        const auto exact   = exact_derivatives(material, F, p, g);
        Matrix     hessian = exact.second;
        if (material.plane_stress)
        {
          EXPECT_NEAR(exact.first[8], 0., 1e-2 * rounding);
          eliminate(hessian, 8);
        }
        expect_derivatives<dim>(
          law.mixed(gradient, p, g, at, true), exact, hessian, true, rounding);
      }
      const double p       = law.pressure(gradient, g, at);
      const auto   F       = law.deformation_gradient(gradient, p, g, at);
      const auto   exact   = exact_derivatives(material, F, p, g);
      Matrix       hessian = exact.second;
      EXPECT_NEAR(exact.first[9], 0., rounding);
      eliminate(hessian, 9);
      if (material.plane_stress)
        eliminate(hessian, 8);
      expect_derivatives<dim>(
        law.eliminated(gradient, g, at, true), exact, hessian, false, rounding);
    }
  }
} // namespace



TEST(FiniteStrainTangents, MatchSacadoInThePlane)
{
  for_all_rubbers<2>(20., test_both_formulations<2>);
}



TEST(FiniteStrainTangents, MatchSacadoInSpace)
{
  for_all_rubbers<3>(20., test_both_formulations<3>);
}



// without tangents the stresses are the same
TEST(FiniteStrainTangents, DoNotChangeTheStress)
{
  for_all_rubbers<2>(20., [](const MaterialDescription &material) {
    const FiniteStrain<2> law(material);
    const PointConstants &at = *material.constants;
    for (const auto &gradient : random_gradients<2>(3, 0.5))
    {
      const auto with    = law.mixed(gradient, 0.2, 0.4, at, true);
      const auto without = law.mixed(gradient, 0.2, 0.4, at, false);
      EXPECT_EQ(with.stress, without.stress);
      EXPECT_EQ(with.constraint, without.constraint);
      EXPECT_EQ(law.eliminated(gradient, 0.4, at, true).stress,
                law.eliminated(gradient, 0.4, at, false).stress);
    }
  });
}
