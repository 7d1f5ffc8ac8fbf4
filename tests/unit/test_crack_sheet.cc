// SPDX-License-Identifier: GPL-2.0-or-later
// Sheets of imposed cracks in space against the surfaces that were imposed: all
// densities, h = l/2 and l/4, on one rank and on two.
#include "imposed_sheets.h"

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr double  l           = 0.2;
  const std::string densities[] = {"AT1", "AT2", "Wu"};
  constexpr double  pi          = dealii::numbers::PI;

  struct Surface
  {
    std::string name;
    Distance    distance;
    double      area; // in the unit cube
  };

  // y = 0.52 - 0.3 (x - 0.51) - 0.2 (z - 0.47)
  double
  to_plane(const Point<3> &x)
  {
    const Tensor<1, 3> normal({0.3, 1., 0.2});
    return std::abs((x - Point<3>(0.51, 0.52, 0.47)) * normal) / normal.norm();
  }

  // of radius 1 around an axis along z below the body
  double
  to_cylinder(const Point<3> &x)
  {
    return std::abs(std::hypot(x[0] - 0.43, x[1] + 0.51) - 1.);
  }

  // of radius 1.4 around a point below the body
  const Point<3> center(0.43, -0.91, 0.55);
  double
  to_sphere(const Point<3> &x)
  {
    return std::abs(x.distance(center) - 1.4);
  }

  // dA = R / sqrt(R^2 - r^2) dx dz, by the midpoint rule
  double
  area_of_sphere()
  {
    constexpr unsigned int n   = 400;
    double                 sum = 0.;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        const double x = (i + 0.5) / n - center[0],
                     z = (j + 0.5) / n - center[2];
        sum += 1.4 / std::sqrt(1.96 - x * x - z * z) / (n * n);
      }
    return sum;
  }

  std::vector<Surface>
  surfaces()
  {
    return {{"plane", to_plane, std::sqrt(1.13)},
            {"cylinder", to_cylinder, std::asin(0.57) + std::asin(0.43)},
            {"sphere", to_sphere, area_of_sphere()}};
  }

  const Tensor<1, 3> normal = Tensor<1, 3>({0.3, 1., 0.2}) / std::sqrt(1.13);
  const Point<3>     middle(0.81, 0.8, 0.78);

  // a penny, within a cube of edge 1.6
  constexpr double radius = 0.5;
  double
  to_penny(const Point<3> &x)
  {
    const double z = (x - middle) * normal;
    const double r = (x - middle - z * normal).norm();
    return std::hypot(z, std::max(0., r - radius));
  }

  // a cap of a sphere of radius 0.8, 45 degrees around the same axis
  const Point<3>   center_of_cap = middle - 0.6 * normal;
  constexpr double radius_of_cap = 0.8, rim = pi / 4.;
  double
  to_cap(const Point<3> &x)
  {
    const Tensor<1, 3> away  = x - center_of_cap;
    const double       up    = away * normal;
    const double       out   = (away - up * normal).norm();
    const double       angle = std::atan2(out, up);
    return angle < rim ? std::abs(away.norm() - radius_of_cap)
                       : std::hypot(up - radius_of_cap * std::cos(rim),
                                    out - radius_of_cap * std::sin(rim));
  }
} // namespace



TEST(CrackSheet, LiesOnSurfacesThroughTheBody)
{
  for (const Surface &surface : surfaces())
    for (const std::string &density : densities)
    {
      for (const unsigned int i : {0, 1})
      {
        SCOPED_TRACE(surface.name + ' ' + density);
        const double       h = l / (2 << i);
        const ImposedSheet body(
          {{1., 1., 1.}}, h, l, density, surface.distance);
        const TracedCracks cracks = body.trace();
        EXPECT_TRUE(cracks.separate_body);
        EXPECT_EQ(cracks.sheets.size(), is_first_rank() ? 1u : 0u);
        if (cracks.sheets.size() != 1)
          continue;
        const CrackSheet &sheet = cracks.sheets[0];
        EXPECT_LT(largest_distance(sheet, surface.distance), 0.5 * h);
        EXPECT_TRUE(sheet.fronts.empty());
        EXPECT_EQ(sheet.joins(), "back to front to left to right");
        for (const Tensor<1, 3> &own : sheet.normals)
          EXPECT_GT(own[1], 0.5);
        EXPECT_NEAR(sheet.area, surface.area, 0.02 * surface.area);
      }
    }
}



// with l = 2 h
TEST(CrackSheet, HasAnAreaThatConverges)
{
  for (const Surface &surface : surfaces())
  {
    SCOPED_TRACE(surface.name);
    double errors[2] = {};
    for (const unsigned int i : {0, 1})
    {
      const double       h = 0.1 / (1 << i);
      const ImposedSheet body(
        {{1., 1., 1.}}, h, 2. * h, "Wu", surface.distance);
      for (const CrackSheet &sheet : body.trace().sheets)
        errors[i] = std::abs(sheet.area / surface.area - 1.);
    }
    EXPECT_LE(errors[1], 0.55 * errors[0]);
  }
}



// As running cracks leave it: phi = 0 at two or three nodes across.
TEST(CrackSheet, LiesInTheMiddleOfWideBands)
{
  for (const Surface &surface : surfaces())
    for (const double width : {1., 1.7})
    {
      SCOPED_TRACE(surface.name);
      const double       h = l / 2.;
      const ImposedSheet body(
        {{1., 1., 1.}}, h, l, "Wu", [&](const Point<3> &x) {
          return std::max(0., surface.distance(x) - width * h);
        });
      for (const CrackSheet &sheet : body.trace().sheets)
      {
        EXPECT_LT(largest_distance(sheet, surface.distance), 0.5 * h);
        EXPECT_NEAR(sheet.area, surface.area, 0.02);
      }
    }
}



TEST(CrackSheet, AndItsFrontAreThoseOfAPenny)
{
  for (const std::string &density : densities)
  {
    double errors[2] = {};
    for (const unsigned int i : {0, 1})
    {
      SCOPED_TRACE(density);
      const double       h = l / (2 << i);
      const ImposedSheet body({{1.6, 1.6, 1.6}}, h, l, density, to_penny);
      const TracedCracks cracks = body.trace();
      EXPECT_FALSE(cracks.separate_body);
      EXPECT_EQ(cracks.sheets.size(), is_first_rank() ? 1u : 0u);
      if (cracks.sheets.size() != 1)
        continue;
      const CrackSheet &sheet = cracks.sheets[0];
      EXPECT_LT(largest_distance(sheet, to_penny), 0.5 * h);
      EXPECT_EQ(sheet.joins(), "tip");
      ASSERT_EQ(sheet.fronts.size(), 1u);
      EXPECT_TRUE(sheet.fronts[0].is_closed);
      for (const FrontPoint &point : sheet.fronts[0].points)
      {
        const Tensor<1, 3> out = point.position - middle;
        EXPECT_NEAR(out.norm(), radius, 0.25 * h);
        EXPECT_LT(std::abs(out * normal), 0.1 * h);
        EXPECT_GT(point.ahead * out / out.norm(), 0.9);
        EXPECT_GT(point.normal * normal, 0.97);
      }
      EXPECT_NEAR(sheet.front_length(), 2. * pi * radius, 4. * h);
      errors[i] = std::abs(sheet.area / (pi * radius * radius) - 1.);
    }
    EXPECT_LT(errors[0], 0.05);
    EXPECT_LE(errors[1], 0.4 * errors[0]);
  }
}



TEST(CrackSheet, IsThatOfASphericalCap)
{
  const double area =
    2. * pi * radius_of_cap * radius_of_cap * (1. - std::cos(rim));
  for (const unsigned int i : {0, 1})
  {
    const double       h = l / (2 << i);
    const ImposedSheet body({{1.6, 1.6, 1.6}}, h, l, "AT1", to_cap);
    for (const CrackSheet &sheet : body.trace().sheets)
    {
      EXPECT_LT(largest_distance(sheet, to_cap), 0.5 * h);
      EXPECT_NEAR(sheet.area, area, (i == 0 ? 0.08 : 0.04) * area);
      ASSERT_EQ(sheet.fronts.size(), 1u);
      for (const FrontPoint &point : sheet.fronts[0].points)
        EXPECT_NEAR((point.position - middle).norm(),
                    std::hypot(radius_of_cap * std::sin(rim),
                               radius_of_cap * std::cos(rim) - 0.6),
                    0.5 * h);
    }
  }
}
