// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_tests_unit_finite_materials_h
#define mixed_cracks_tests_unit_finite_materials_h

#include "hyperelastic_constants.h"

#include <model/finite_strain.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  namespace Testing
  {
    constexpr double rubber_kappa      = 1e-3;
    constexpr double rubber_relaxation = 0.7;

    /// A law with the constants of rubber_constants() and a bulk modulus;
    /// MPa.
    inline MaterialDescription
    rubber(const std::string &law, const double bulk_modulus)
    {
      const HyperelasticConstants &constants = rubber_constants().at(law);
      const double                 mu =
        all_hyperelastic_laws().make(law, HyperelasticForm())->mu(constants);
      MaterialDescription result{
        PointConstants{bulk_modulus - 2. / 3. * mu, mu, 17., constants},
        0.3,
        rubber_kappa,
        rubber_relaxation,
        3,
        "Wu",
        "none",
        "relaxed bulk"};
      result.strains          = Strains::finite;
      result.hyperelastic_law = law;
      return result;
    }

    /// Call test(description) for every law, form, pressure law, split and, in
    /// 2-d, kinematics that go together.
    template <int dim, typename Test>
    void
    for_all_rubbers(const double bulk_modulus, const Test &test)
    {
      for (const auto &[law, constants] : rubber_constants())
        for (const std::string &form : all_volumetric_forms().names())
          for (const std::string &pressure_law :
               all_finite_pressure_laws().names())
            for (const std::string &split : all_finite_splits().names())
              for (const bool plane_stress : {false, true})
              {
                const bool is_sum = all_hyperelastic_laws()
                                      .make(law, HyperelasticForm())
                                      ->is_sum_over_stretches();
                if ((dim == 3 && plane_stress) ||
                    (split == "principal stretches" && !is_sum))
                  continue;
                SCOPED_TRACE(law + ", " + form + ", " + pressure_law + ", " +
                             split + (plane_stress ? ", plane stress" : ""));
                MaterialDescription material = rubber(law, bulk_modulus);
                material.volumetric_form     = form;
                material.pressure_law        = pressure_law;
                material.energy_split        = split;
                material.plane_stress        = plane_stress;
                test(material);
              }
    }

    template <int dim>
    std::vector<dealii::Tensor<2, dim>>
    random_gradients(const unsigned int n, const double size)
    {
      std::vector<dealii::Tensor<2, dim>> result;
      for (const auto &F : random_deformations(n, size, dim == 2))
      {
        dealii::Tensor<2, dim> gradient;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            gradient[i][j] = F[i][j] - (i == j ? 1. : 0.);
        if (determinant(F) > 0.2)
          result.push_back(gradient);
      }
      return result;
    }

    /// F - I in the plane.
    inline dealii::Tensor<2, 2>
    stretched(const double first, const double second)
    {
      dealii::Tensor<2, 2> gradient;
      gradient[0][0] = first - 1.;
      gradient[1][1] = second - 1.;
      return gradient;
    }
  } // namespace Testing
} // namespace MixedCracks

#endif
