// SPDX-License-Identifier: GPL-2.0-or-later
// How few numbers a tangent is kept by, and that they are those it was set to.
#include <assembly/lane_tangents_templates.h>

#include <deal.II/base/vectorization.h>

#include <gtest/gtest.h>

#include <functional>

using namespace MixedCracks;

namespace
{
  using Lanes     = dealii::VectorizedArray<double, 1>;
  using Responses = std::vector<ElasticResponse<3>>;

  constexpr unsigned int n_points = 27;

  // C = 2 g 1 + (b0 + b1 g) I (x) I, s = t = 1, c = - 1 - 1/g
  Responses
  graded(const std::function<double(unsigned int)> &g,
         const std::function<double(unsigned int)> &b1)
  {
    Responses result(n_points);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      result[q].stress_by_strain =
        2. * g(q) * dealii::identity_tensor<3>() +
        (0.3 + b1(q) * g(q)) *
          outer_product(dealii::unit_symmetric_tensor<3>(),
                        dealii::unit_symmetric_tensor<3>());
      result[q].stress_by_pressure     = 1.;
      result[q].constraint_by_trace    = 1.;
      result[q].constraint_by_pressure = -1. - 1. / g(q);
    }
    return result;
  }

  LaneTangents<3, Lanes>
  kept(const Responses &responses)
  {
    LaneTangents<3, Lanes> tangents;
    tangents.reinit(1, n_points, {{0, 0}});
    tangents.set(0, responses);
    return tangents;
  }

  void
  expect_read(const LaneTangents<3, Lanes> &tangents,
              const Responses              &responses)
  {
    IsotropicCell expected, found;
    ASSERT_TRUE(expected.read(responses));
    ASSERT_TRUE(tangents.read_isotropic(0, found));
    for (unsigned int q = 0; q < n_points; ++q)
    {
      EXPECT_NEAR(found.identity[q], expected.identity[q], 1e-14);
      EXPECT_NEAR(found.volume[q], expected.volume[q], 1e-14);
      EXPECT_NEAR(
        found.stress_by_pressure[q], expected.stress_by_pressure[q], 1e-14);
      EXPECT_NEAR(
        found.constraint_by_trace[q], expected.constraint_by_trace[q], 1e-14);
      EXPECT_NEAR(found.constraint_by_pressure[q],
                  expected.constraint_by_pressure[q],
                  1e-13);
    }
  }
} // namespace



TEST(LaneTangents, KeepTwoNumbersOfAPointInOneRegime)
{
  const Responses responses = graded([](unsigned int q) { return 0.1 + q; },
                                     [](unsigned int) { return -0.7; });
  const auto      tangents  = kept(responses);
  EXPECT_EQ(tangents.kind(0), TangentKind::graded);
  EXPECT_EQ(tangents.stride(0), 2u);
  expect_read(tangents, responses);
}



TEST(LaneTangents, KeepOnePointWhereAllAreTheSame)
{
  const Responses responses =
    graded([](unsigned int q) { return 1. + 1e-16 * (q % 4); },
           [](unsigned int) { return -0.7; });
  const auto tangents = kept(responses);
  EXPECT_EQ(tangents.stride(0), 0u);
  expect_read(tangents, responses);
}



// the split changes its regime within the cell
TEST(LaneTangents, KeepAllNumbersInTwoRegimes)
{
  const Responses responses =
    graded([](unsigned int q) { return 0.1 + q; },
           [](unsigned int q) { return q < 13 ? 0. : -0.7; });
  const auto tangents = kept(responses);
  EXPECT_EQ(tangents.kind(0), TangentKind::isotropic);
  EXPECT_EQ(tangents.stride(0), 5u);
  expect_read(tangents, responses);
}



TEST(LaneTangents, KeepTheTriangleOfOneThatIsNotIsotropic)
{
  Responses responses =
    graded([](unsigned int) { return 1.; }, [](unsigned int) { return 0.; });
  responses[4].stress_by_strain[0][0][0][0] += 1.;
  const auto    tangents = kept(responses);
  IsotropicCell cell;
  EXPECT_EQ(tangents.kind(0), TangentKind::symmetric);
  EXPECT_FALSE(tangents.read_isotropic(0, cell));
}



// An evaluation that failed has set some cells of a batch only (the two are in
// one lane here).
TEST(LaneTangents, BeginAnewAfterAnUpdateThatDidNotEnd)
{
  LaneTangents<3, Lanes> tangents;
  tangents.reinit(1, n_points, {{0, 0}, {0, 0}});
  const Responses usual       = graded([](unsigned int q) { return 1. + q; },
                                 [](unsigned int) { return 0.; });
  Responses       anisotropic = usual;
  anisotropic[4].stress_by_strain[0][0][0][0] += 1.;
  tangents.set(0, anisotropic);
  tangents.set(0, usual);
  tangents.set(1, usual);
  EXPECT_EQ(tangents.kind(0), TangentKind::graded);
  expect_read(tangents, usual);
}
