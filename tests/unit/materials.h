// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_tests_unit_materials_h
#define mixed_cracks_tests_unit_materials_h

#include <model/material.h>

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <vector>

namespace MixedCracks
{
  namespace Testing
  {
    constexpr double lambda = 47.;
    constexpr double mu     = 2.4;

    const std::vector<double> degradations = {1e-3, 0.2, 0.9, 1.};

    using Dimensions = ::testing::Types<std::integral_constant<int, 2>,
                                        std::integral_constant<int, 3>>;

    inline MaterialDescription
    description(const std::string &split, const std::string &law, const int n)
    {
      return {
        PointConstants{lambda, mu, 17.}, 0.3, 1e-3, 0.7, n, "Wu", split, law};
    }

    /// Call test(material) for every split, pressure law and n.
    template <int dim, typename Test>
    void
    for_all_materials(const Test &test)
    {
      for (const std::string &split : all_energy_splits<dim>().names())
        for (const std::string &law : all_pressure_laws().names())
          for (int n = dim; n <= 3; ++n)
          {
            SCOPED_TRACE(split + ", " + law + ", n = " + std::to_string(n));
            test(Material<dim>(description(split, law, n)));
          }
    }
  } // namespace Testing
} // namespace MixedCracks

#endif
