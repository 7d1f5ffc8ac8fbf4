// SPDX-License-Identifier: GPL-2.0-or-later
// Constants of the material that vary: what the .prm says against the values
// at points, three ways to say the same, and what is refused.
#include <base/errors.h>

#include <problem/geometries/checks.h>
#include <problem/material_field.h>

#include <gtest/gtest.h>

using namespace MixedCracks;

namespace
{
  using dealii::Point;

  // E = 200 and nu = 0.25 are lambda = mu = 80
  MaterialParameters
  soft()
  {
    MaterialParameters parameters;
    parameters.youngs_modulus               = "200";
    parameters.poisson_ratio                = "0.25";
    parameters.critical_energy_release_rate = "3";
    return parameters;
  }

  template <typename Action>
  std::string
  refusal(const Action &action)
  {
    try
    {
      action();
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }

  void
  expect_contains(const std::string &text, const std::string &part)
  {
    EXPECT_NE(text.find(part), std::string::npos)
      << "'" << part << "' is not in: " << text;
  }

  void
  expect_values(const MaterialValues &values,
                const double          lambda,
                const double          mu,
                const double          critical_energy_release_rate)
  {
    EXPECT_NEAR(values.elastic.lambda, lambda, 1e-12 * lambda);
    EXPECT_NEAR(values.elastic.mu, mu, 1e-12 * mu);
    EXPECT_NEAR(
      values.critical_energy_release_rate, critical_energy_release_rate, 1e-14);
  }
} // namespace



TEST(MaterialField, NumbersAreTheSameEverywhere)
{
  soft().check();
  EXPECT_FALSE(soft().varies());
  expect_values(soft().uniform_values(), 80., 80., 3.);
  // a formula without variables is a number too
  MaterialParameters formula           = soft();
  formula.critical_energy_release_rate = "2*1.5";
  EXPECT_FALSE(formula.varies());
  expect_values(formula.uniform_values(), 80., 80., 3.);
}



TEST(MaterialField, ExpressionsAreEvaluatedAtThePoint)
{
  MaterialParameters parameters           = soft();
  parameters.youngs_modulus               = "200*(1 + x)";
  parameters.critical_energy_release_rate = "1 + y*y + z";
  parameters.check();
  EXPECT_TRUE(parameters.varies());
  const MaterialField<2> plane(parameters, nullptr);
  expect_values(plane(Point<2>(0.5, 2.), 0), 120., 120., 5.);
  const MaterialField<3> space(parameters, nullptr);
  expect_values(space(Point<3>(0., 1., 7.), 0), 80., 80., 9.);
}



TEST(MaterialField, MaterialIdsReplaceWhatTheyName)
{
  MaterialParameters parameters = soft();
  parameters.by_material_id =
    "4 : Young's modulus = 400*max(1, x) ; 2 : Lame lambda = 10, "
    "Shear modulus = 20, Critical energy release rate = 7";
  parameters.check();
  EXPECT_TRUE(parameters.varies());
  const MaterialField<2> field(parameters, nullptr);
  expect_values(field(Point<2>(2., 0.), 0), 80., 80., 3.);
  expect_values(field(Point<2>(2., 0.), 4), 320., 320., 3.);
  expect_values(field(Point<2>(2., 0.), 2), 10., 20., 7.);
  EXPECT_NO_THROW(field.check_ids({0, 2, 4}));
  const std::string message = refusal([&]() { field.check_ids({0, 2}); });
  expect_contains(message, "material id 4 is not in the mesh");
  expect_contains(message, "0, 2");
}



TEST(MaterialField, TheRestOfTheBodyNeedsNoConstantsWhenAllIdsHaveTheirs)
{
  MaterialParameters parameters;
  parameters.by_material_id = "1 : Lame lambda = 10, Shear modulus = 20";
  parameters.check();
  const MaterialField<2> field(parameters, nullptr);
  expect_values(field(Point<2>(), 1), 10., 20., 1.);
  const std::string message = refusal([&]() { field(Point<2>(3., 4.), 0); });
  expect_contains(message, "none of the elastic constants");
  expect_contains(message, "(3, 4), material id 0");
}



TEST(MaterialField, TheMapIsAVariable)
{
  MaterialParameters parameters           = soft();
  parameters.map.file_name                = "some file";
  parameters.critical_energy_release_rate = "1 + 10*map";
  parameters.check();
  const auto map = std::make_shared<GridData>(
    std::array<std::vector<double>, 3>{{{0., 1.}, {0.}, {0.}}},
    std::vector<double>{0.25, 0.5},
    GridData::Interpolation::linear);
  const MaterialField<2> field(parameters, map);
  expect_values(field(Point<2>(0.6, 3.), 0), 80., 80., 5.);
}



TEST(MaterialField, WhatMakesNoMaterialIsRefusedWithThePlace)
{
  MaterialParameters parameters = soft();
  parameters.youngs_modulus     = "200*(1 - x)";
  const MaterialField<2> field(parameters, nullptr);
  expect_values(field(Point<2>(0.5, 0.), 0), 40., 40., 3.);
  std::string message = refusal([&]() { field(Point<2>(1.5, 2.), 0); });
  expect_contains(message, "Material/Young's modulus = -100");
  expect_contains(message, "(1.5, 2)");

  parameters                              = soft();
  parameters.critical_energy_release_rate = "x - 1";
  const MaterialField<2> tough(parameters, nullptr);
  message = refusal([&]() { tough(Point<2>(0.25, 2.), 0); });
  expect_contains(message, "Material/Critical energy release rate");
  expect_contains(message, "-0.75");
  expect_contains(message, "(0.25, 2)");
}



TEST(MaterialField, MistakesAreFoundWithoutAMesh)
{
  const auto message_of = [](const auto &change) {
    MaterialParameters parameters = soft();
    change(parameters);
    return refusal([&]() { parameters.check(); });
  };
  expect_contains(message_of([](auto &p) { p.youngs_modulus = "200*q"; }),
                  "unknown name 'q'");
  expect_contains(
    message_of([](auto &p) { p.critical_energy_release_rate = "-1"; }),
    "found '-1'");
  expect_contains(message_of([](auto &p) { p.shear_modulus = "x"; }), "3 of");
  expect_contains(message_of([](auto &p) { p.youngs_modulus = "200*map"; }),
                  "Material/Map/File name");
  expect_contains(message_of([](auto &p) { p.map.file_name = "a.pgm"; }),
                  "no expression of the material uses 'map'");
  const auto by_id = [&](const std::string &text) {
    return message_of([&](auto &p) { p.by_material_id = text; });
  };
  expect_contains(by_id("1 = 3"), "id : name = value");
  expect_contains(by_id("one : Poisson ratio = 0.3"), "one");
  expect_contains(by_id("1 : Poison ratio = 0.3"), "Poisson ratio");
  expect_contains(by_id("1 : Poisson ratio"), "name = value");
  expect_contains(by_id("1 : Poisson ratio = 0.7"), "smaller than 0.5");
  expect_contains(by_id("1 : Poisson ratio = 0.3 ; 1 : Poisson ratio = 0.4"),
                  "given twice");
  expect_contains(by_id("1 : Bulk modulus = 3"), "3 elastic constants");
  EXPECT_EQ(by_id("1 : Poisson ratio = min(0.3, 0.1 + x)"), "");
}
