// SPDX-License-Identifier: GPL-2.0-or-later
#include <model/crack_density.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace MixedCracks
{
  namespace
  {
    using dealii::numbers::PI;

    // a = (1-phi)^2/2, b = 1/2: damage from the first load on
    class AT2 : public CrackDensity
    {
    public:
      double
      local(const double phi) const override
      {
        return 0.5 * (1. - phi) * (1. - phi);
      }

      double
      local_derivative(const double phi) const override
      {
        return phi - 1.;
      }

      double
      local_second_derivative(const double) const override
      {
        return 1.;
      }

      Curvature
      curvature() const override
      {
        return {1., 1.};
      }

      double
      gradient_coefficient() const override
      {
        return 0.5;
      }

      double
      optimal_profile(const double distance_over_length) const override
      {
        return -std::expm1(-std::abs(distance_over_length));
      }

      double
      half_width() const override
      {
        return std::numeric_limits<double>::infinity();
      }
    };



    // a = 3/8 (1-phi), b = 3/8
    class AT1 : public CrackDensity
    {
    public:
      double
      local(const double phi) const override
      {
        return 0.375 * (1. - phi);
      }

      double
      local_derivative(const double) const override
      {
        return -0.375;
      }

      double
      local_second_derivative(const double) const override
      {
        return 0.;
      }

      Curvature
      curvature() const override
      {
        return {0., 0.};
      }

      double
      gradient_coefficient() const override
      {
        return 0.375;
      }

      double
      optimal_profile(const double distance_over_length) const override
      {
        const double to_edge =
          1. - std::min(std::abs(distance_over_length) / half_width(), 1.);
        return 1. - to_edge * to_edge;
      }

      double
      half_width() const override
      {
        return 2.;
      }
    };



    // a = (1-phi^2)/pi, b = 1/pi [Wu17]; a is concave
    class Wu : public CrackDensity
    {
    public:
      double
      local(const double phi) const override
      {
        return (1. - phi * phi) / PI;
      }

      double
      local_derivative(const double phi) const override
      {
        return -2. * phi / PI;
      }

      double
      local_second_derivative(const double) const override
      {
        return -2. / PI;
      }

      Curvature
      curvature() const override
      {
        return {-2. / PI, -2. / PI};
      }

      double
      gradient_coefficient() const override
      {
        return 1. / PI;
      }

      double
      optimal_profile(const double distance_over_length) const override
      {
        return std::sin(std::min(std::abs(distance_over_length), half_width()));
      }

      double
      half_width() const override
      {
        return 0.5 * PI;
      }
    };



    template <typename Density>
    std::unique_ptr<CrackDensity>
    make()
    {
      return std::make_unique<Density>();
    }
  } // namespace



  const Registry<CrackDensity> &
  all_crack_densities()
  {
    static const Registry<CrackDensity> list(
      "crack density",
      {{"Wu",
        "(2 (1-phi) - (1-phi)^2) / (pi l) + l/pi |grad phi|^2, with an "
        "elastic stage; band of half width pi l / 2",
        make<Wu>},
       {"AT1",
        "3/8 ((1-phi)/l + l |grad phi|^2), with an elastic stage; band of "
        "half width 2 l",
        make<AT1>},
       {"AT2",
        "(1-phi)^2 / (2 l) + l/2 |grad phi|^2, damage from the first load "
        "on; band without an edge",
        make<AT2>}});
    return list;
  }
} // namespace MixedCracks
