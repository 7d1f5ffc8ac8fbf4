// SPDX-License-Identifier: GPL-2.0-or-later
// Crack densities and the degradation: derivatives against difference
// quotients and Sacado, and the optimal profiles, see (M1).
#include "automatic_differentiation.h"

#include <model/crack_density.h>
#include <model/degradation.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace MixedCracks;
using Testing::Active;
using Testing::differentiate;

namespace
{
  const std::vector<double> phase_fields = {0., 0.1, 0.37, 0.5, 0.83, 1.};

  // gamma(phi, phi') for l = 1 in 1-d as the table of (M1) prints it
  using Density = std::function<Active(const std::vector<Active> &)>;
  const std::map<std::string, Density> formulas = {
    {"AT2",
     [](const std::vector<Active> &x) -> Active {
       return (1. - x[0]) * (1. - x[0]) / 2. + x[1] * x[1] / 2.;
     }},
    {"AT1",
     [](const std::vector<Active> &x) -> Active {
       return 3. / 8. * ((1. - x[0]) + x[1] * x[1]);
     }},
    {"Wu", [](const std::vector<Active> &x) -> Active {
       return (2. * (1. - x[0]) - (1. - x[0]) * (1. - x[0]) + x[1] * x[1]) /
              dealii::numbers::PI;
     }}};

  // where the quadrature of a profile may stop; exp(-40) is nothing
  double
  band(const CrackDensity &density)
  {
    return std::min(density.half_width(), 40.);
  }
} // namespace



TEST(CrackDensity, DerivativesMatchDifferenceQuotients)
{
  const double h = 1e-5;
  for (const std::string &name : all_crack_densities().names())
    for (const double phi : phase_fields)
    {
      SCOPED_TRACE(name);
      const auto density = all_crack_densities().make(name);
      EXPECT_NEAR(density->local_derivative(phi),
                  (density->local(phi + h) - density->local(phi - h)) / (2 * h),
                  1e-9);
      EXPECT_NEAR(density->local_second_derivative(phi),
                  (density->local_derivative(phi + h) -
                   density->local_derivative(phi - h)) /
                    (2 * h),
                  1e-9);
    }
}



TEST(CrackDensity, CurvatureIsThatOfAllPhaseFields)
{
  for (const std::string &name : all_crack_densities().names())
  {
    SCOPED_TRACE(name);
    const auto density  = all_crack_densities().make(name);
    const auto range    = density->curvature();
    double     smallest = density->local_second_derivative(0.);
    double     largest  = smallest;
    for (unsigned int i = 1; i <= 1000; ++i)
    {
      const double sample = density->local_second_derivative(i / 1000.);
      smallest            = std::min(smallest, sample);
      largest             = std::max(largest, sample);
    }
    // extremes between two samples may lie beyond both, but not by much
    EXPECT_LE(range.smallest, smallest);
    EXPECT_GE(range.largest, largest);
    EXPECT_NEAR(range.smallest, smallest, 1e-4 * (1. + std::abs(smallest)));
    EXPECT_NEAR(range.largest, largest, 1e-4 * (1. + std::abs(largest)));
  }
}



// what phi = 0.5 does not show: a = (1 - phi)^2 (1 + 2 phi) is convex above
// 0.5 only, its second derivative -6 + 12 phi being 0 there
TEST(CrackDensity, ConcavityIsTheLargestOfAllPhaseFields)
{
  class Cubic : public CrackDensity
  {
  public:
    double
    local(const double phi) const override
    {
      return (1. - phi) * (1. - phi) * (1. + 2. * phi);
    }

    double
    local_derivative(const double phi) const override
    {
      return -6. * phi * (1. - phi);
    }

    double
    local_second_derivative(const double phi) const override
    {
      return -6. + 12. * phi;
    }

    Curvature
    curvature() const override
    {
      return {-6., 6.};
    }

    double
    gradient_coefficient() const override
    {
      return 1.;
    }

    double
    optimal_profile(const double) const override
    {
      return 1.;
    }

    double
    half_width() const override
    {
      return 1.;
    }
  };
  const Cubic density;
  EXPECT_EQ(density.local_second_derivative(0.5), 0.);
  EXPECT_EQ(density.concavity(), 6.);
  EXPECT_FALSE(density.is_quadratic());
  // with it, the derivative never falls
  for (unsigned int i = 0; i < 100; ++i)
  {
    const double phi = i / 100., next = (i + 1) / 100.;
    EXPECT_GE(density.local_derivative(next) + density.concavity() * next,
              density.local_derivative(phi) + density.concavity() * phi);
  }
  for (const auto &[name, concavity] :
       {std::make_pair("AT1", 0.),
        std::make_pair("AT2", 0.),
        std::make_pair("Wu", 2. / dealii::numbers::PI)})
  {
    SCOPED_TRACE(name);
    const auto shipped = all_crack_densities().make(name);
    EXPECT_DOUBLE_EQ(shipped->concavity(), concavity);
    EXPECT_TRUE(shipped->is_quadratic());
  }
}



TEST(CrackDensity, MatchesTheTableThroughSacado)
{
  for (const auto &[name, formula] : formulas)
    for (const double phi : phase_fields)
    {
      SCOPED_TRACE(name);
      const auto   density = all_crack_densities().make(name);
      const double slope   = 0.7;
      const auto   exact   = differentiate(formula, {phi, slope});
      const double b       = density->gradient_coefficient();
      EXPECT_NEAR(density->local(phi) + b * slope * slope, exact.value, 1e-14);
      EXPECT_NEAR(density->local_derivative(phi), exact.first[0], 1e-14);
      EXPECT_NEAR(
        density->local_second_derivative(phi), exact.second[0][0], 1e-14);
      EXPECT_NEAR(2 * b * slope, exact.first[1], 1e-14);
      EXPECT_NEAR(2 * b, exact.second[1][1], 1e-14);
    }
}



TEST(CrackDensity, IsNothingWhereIntact)
{
  for (const std::string &name : all_crack_densities().names())
  {
    SCOPED_TRACE(name);
    const auto density = all_crack_densities().make(name);
    EXPECT_NEAR(density->local(1.), 0., 1e-15);
    EXPECT_LE(density->local_derivative(1.), 0.);
    EXPECT_GT(density->gradient_coefficient(), 0.);
  }
}



TEST(CrackDensity, ProfileRisesFromTheCrackToTheEdgeOfTheBand)
{
  for (const std::string &name : all_crack_densities().names())
  {
    SCOPED_TRACE(name);
    const auto   density = all_crack_densities().make(name);
    const double width   = band(*density);
    EXPECT_EQ(density->optimal_profile(0.), 0.);
    double previous = 0.;
    for (unsigned int i = 1; i < 20; ++i)
    {
      const double x   = i * std::min(width, 4.) / 20;
      const double phi = density->optimal_profile(x);
      EXPECT_GT(phi, previous);
      EXPECT_LT(phi, 1.);
      EXPECT_EQ(phi, density->optimal_profile(-x));
      previous = phi;
    }
    for (const double factor : {1., 1.3, 10., 1e6})
      EXPECT_NEAR(density->optimal_profile(factor * width), 1., 1e-15);
  }
}



TEST(CrackDensity, ProfileCarriesOneUnitOfSurface)
{
  const double            length = 0.3, h = 1e-6;
  const unsigned int      n_cells = 400;
  const dealii::QGauss<1> quadrature(5);
  for (const std::string &name : all_crack_densities().names())
  {
    SCOPED_TRACE(name);
    const auto   density   = all_crack_densities().make(name);
    const double cell_size = length * band(*density) / n_cells;
    const auto   profile   = [&](const double x) {
      return density->optimal_profile(x / length);
    };
    double surface = 0.;
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const double x     = cell_size * (cell + quadrature.point(q)[0]);
        const double slope = (profile(x + h) - profile(x - h)) / (2 * h);
        surface += 2 * cell_size * quadrature.weight(q) *
                   (density->local(profile(x)) / length +
                    density->gradient_coefficient() * length * slope * slope);
      }
    EXPECT_NEAR(surface, 1., 1e-7);
  }
}



TEST(CrackDensity, ProfileSolvesTheEulerEquationWhereDamaged)
{
  const double h = 1e-4;
  for (const std::string &name : all_crack_densities().names())
    for (const double x : {0.05, 0.4, 0.9, 1.5})
    {
      SCOPED_TRACE(name);
      const auto   density   = all_crack_densities().make(name);
      const double phi       = density->optimal_profile(x);
      const double curvature = (density->optimal_profile(x + h) - 2 * phi +
                                density->optimal_profile(x - h)) /
                               (h * h);
      ASSERT_LT(x + h, density->half_width());
      EXPECT_NEAR(density->local_derivative(phi) -
                    2 * density->gradient_coefficient() * curvature,
                  0.,
                  1e-6);
    }
}



TEST(Degradation, QuadraticMatchesTheFormulaThroughSacado)
{
  for (const double kappa : {1e-10, 1e-3, 0.5})
    for (const double phi : phase_fields)
    {
      const auto g     = all_degradations().make("quadratic", kappa);
      const auto exact = differentiate(
        [kappa](const std::vector<Active> &x) -> Active {
          return (1. - kappa) * x[0] * x[0] + kappa;
        },
        {phi});
      EXPECT_NEAR(g->value(phi), exact.value, 1e-15);
      EXPECT_NEAR(g->derivative(phi), exact.first[0], 1e-15);
      EXPECT_NEAR(g->second_derivative(phi), exact.second[0][0], 1e-15);
    }
}



// what the class promises, whatever is in the list
TEST(Degradation, GoesFromResidualStiffnessToOne)
{
  constexpr double h = 1e-6;
  for (const std::string &name : all_degradations().names())
    for (const double kappa : {0., 1e-3, 0.5})
    {
      SCOPED_TRACE(name);
      const auto g = all_degradations().make(name, kappa);
      EXPECT_EQ(g->value(0.), kappa);
      EXPECT_DOUBLE_EQ(g->value(1.), 1.);
      EXPECT_EQ(g->derivative(0.), 0.);
      for (const double phi : phase_fields)
      {
        EXPECT_GE(g->derivative(phi), 0.);
        EXPECT_NEAR(g->derivative(phi),
                    (g->value(phi + h) - g->value(phi - h)) / (2. * h),
                    1e-8);
        EXPECT_NEAR(g->second_derivative(phi),
                    (g->derivative(phi + h) - g->derivative(phi - h)) /
                      (2. * h),
                    1e-8);
        if (g->is_quadratic())
        {
          EXPECT_DOUBLE_EQ(g->second_derivative(phi), g->second_derivative(0.));
        }
      }
    }
}
