// SPDX-License-Identifier: GPL-2.0-or-later
// Rubber at a small strain is the material of (M1) to (M8), and how a damaged
// one opens.
#include "finite_materials.h"
#include "strains.h"

#include <model/material.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace MixedCracks;
using namespace MixedCracks::Testing;
using dealii::SymmetricTensor;
using dealii::Tensor;

namespace
{
  // (M13): the material of small strains that has the same limit. In plane
  // stress its lambda is reduced, and 1/c is larger by 1/2.
  MaterialDescription
  small_counterpart(const MaterialDescription &finite)
  {
    MaterialDescription small = finite;
    small.strains             = Strains::small;
    if (finite.energy_split == "volumetric")
      small.energy_split = "volumetric-deviatoric";
    if (finite.plane_stress)
    {
      double      &lambda = small.constants->lambda;
      const double mu     = small.constants->mu;
      lambda              = 2. * lambda * mu / (lambda + 2. * mu);
      small.relaxation    = 1. / (1. / finite.relaxation + 0.5);
    }
    return small;
  }

  double
  relative(const double a, const double b)
  {
    return std::abs(a / b - 1.);
  }

  // largest relative difference of what two materials say in the displacement
  // formulation, each with the pressure of its own
  template <int dim>
  double
  difference(const Material<dim>           &finite,
             const Material<dim>           &small,
             const SymmetricTensor<2, dim> &strain,
             const double                   g)
  {
    const auto   stress = small.eliminated(strain, g).stress;
    const double p      = small.pressure(strain, g);
    const double own    = finite.pressure(strain, g);
    return std::max(
      {(finite.eliminated(strain, g).stress - stress).norm() / stress.norm(),
       relative(finite.driving_force(strain, own, g),
                small.driving_force(strain, p, g)),
       relative(finite.elastic_energy(strain, own, g),
                small.elastic_energy(strain, p, g))});
  }

  // the same of pressure, and of stress and constraint of the mixed
  // formulation
  template <int dim>
  double
  mixed_difference(const Material<dim>           &finite,
                   const Material<dim>           &small,
                   const SymmetricTensor<2, dim> &strain,
                   const double                   g)
  {
    // the transmitted pressure is g times that of finite strain, as it fades
    const double p = 0.7 * finite.uniform_constants().mu * trace(strain);
    const auto   a = finite.mixed(strain, p / g, g);
    const auto   b = small.mixed(strain, p, g);
    return std::max(
      {(a.stress - b.stress).norm() / b.stress.norm(),
       std::abs(a.constraint / g - b.constraint) /
         (strain.norm() + std::abs(p * b.constraint_by_pressure)),
       relative(g * finite.pressure(strain, g), small.pressure(strain, g))});
  }

  // p is lambda' tr eps, and lambda_W fades with the shear stiffness: where
  // the law has a lambda_W, only intact material is the same, as a whole
  bool
  has_lambda(const MaterialDescription &description)
  {
    return all_hyperelastic_laws()
             .make(description.hyperelastic_law, HyperelasticForm())
             ->lambda(description.constants->hyperelastic) != 0.;
  }

  template <int dim>
  void
  expect_limit(const MaterialDescription &description)
  {
    const bool comparable = description.volumetric_form == "coupled" &&
                            description.pressure_law == "relaxed bulk" &&
                            description.energy_split != "principal stretches";
    if (!comparable)
      return;
    const Material<dim> finite(description);
    const Material<dim> small(small_counterpart(description));
    for (auto strain : random_strains<dim>(8))
    {
      // in compression the volumetric splits differ: only small strains leave
      // the volume's part of 2 mu eps undegraded
      if (description.energy_split == "volumetric" && trace(strain) < 0.)
        strain *= -1.;
      // a change of volume that is no difference of larger strains
      if (std::abs(trace(strain)) < 0.5 * strain.norm())
        continue;
      strain /= strain.norm();
      for (const double g : {0.3, 1.})
      {
        const bool whole = has_lambda(description);
        if (whole && g < 1.)
          continue;
        const auto at_size = [&](const double size) {
          const double alone = difference<dim>(finite, small, size * strain, g);
          return whole ? alone
                       : std::max(alone,
                                  mixed_difference<dim>(
                                    finite, small, size * strain, g));
        };
        const double coarse = at_size(1e-4), fine = at_size(1e-5);
        EXPECT_LT(coarse, 1e-3);
        EXPECT_LT(fine, 1e-4);
        EXPECT_NEAR(coarse / fine, 10., 0.5);
      }
    }
  }
} // namespace



TEST(FiniteStrainLimits, SmallStrainsInThePlane)
{
  for_all_rubbers<2>(20., expect_limit<2>);
}



TEST(FiniteStrainLimits, SmallStrainsInSpace)
{
  for_all_rubbers<3>(20., expect_limit<3>);
}



// P_11 of damaged material over that of intact one, at F_11 = 1.01 and 1.5,
// F_22 = 1 (a band between two halves of a body), neo-Hooke, K = 1000 mu,
// kappa = 1e-4, c = 1; the figures are of a separate calculation with the
// closed forms of (M14). From phi = 0.2 on the stress is g mu (F_11 - 1).
TEST(FiniteStrainLimits, DamagedMaterialOpens)
{
  const auto ratio = [](const std::string &pressure_law,
                        const bool         plane_stress,
                        const double       stretch,
                        const double       phi) {
    MaterialDescription description = rubber("neo-Hooke", 1000.);
    description.residual_stiffness  = 1e-4;
    description.relaxation          = 1.;
    description.pressure_law        = pressure_law;
    description.plane_stress        = plane_stress;
    const FiniteStrain<2> law(description);
    const auto            stress = [&](const double g) {
      return law
        .eliminated(stretched(stretch, 1.), g, *description.constants, false)
        .stress[0][0];
    };
    return stress((1. - 1e-4) * phi * phi + 1e-4) / stress(1.);
  };
  struct Row
  {
    std::string         pressure_law;
    bool                plane_stress;
    double              stretch;
    std::vector<double> ratios; // phi = 0.9, 0.5
  };
  const double           phi[2] = {0.9, 0.5};
  const std::vector<Row> rows   = {
      {"relaxed bulk", false, 1.01, {0.00585, 0.0008299}},
      {"relaxed bulk", false, 1.5, {0.00559, 0.0007494}},
      {"relaxed bulk", true, 1.01, {0.7016, 0.1766}},
      {"relaxed bulk", true, 1.5, {0.7753, 0.221}},
      {"cubic", false, 1.01, {0.532, 0.01611}},
      {"cubic", false, 1.5, {0.5319, 0.01604}},
      {"cubic", true, 1.01, {0.8096, 0.2466}},
      {"cubic", true, 1.5, {0.8099, 0.2491}}};
  for (const Row &row : rows)
    for (unsigned int i = 0; i < 2; ++i)
      EXPECT_NEAR(
        ratio(row.pressure_law, row.plane_stress, row.stretch, phi[i]) /
          row.ratios[i],
        1.,
        1e-3)
        << row.pressure_law << row.plane_stress << row.stretch << phi[i];
}
