// SPDX-License-Identifier: GPL-2.0-or-later
// Opening and volume of cracks on imposed fields, and the entries that ask for
// them.
#include "imposed_opening.h"

#include <base/errors.h>

#include <output/crack_opening.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  template <int dim>
  CrackOpeningParameters<dim>
  parameters(const std::string &lines)
  {
    CrackOpeningParameters<dim> result;
    result.lines_text = lines;
    return result;
  }

  template <int dim>
  std::string
  problem(const std::string &lines)
  {
    try
    {
      parameters<dim>(lines).check();
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }

  // a crack in y = 0 whose faces part by 2 (1 + x), within |y| < 0.5
  template <int dim>
  void
  open_crack(OpenedBody<dim> &body)
  {
    body.set_phase_field([](const dealii::Point<dim> &x) {
      return std::min(1., 2. * std::abs(x[1]));
    });
    body.set_displacement([](const dealii::Point<dim> &x) {
      dealii::Tensor<1, dim> u;
      u[0] = 5.; // a rigid motion opens nothing
      u[1] = (1. + x[0]) * std::clamp(4. * x[1], -1., 1.);
      return u;
    });
  }

  // of the displacement above: 4 y up to y = 1/4, the size of the cells, and
  // 1 up to 1/2, where the coarse cells with half the resolution have 2 y
  double
  integral_of_profile(const bool coarse)
  {
    return coarse ? 2. * 2. * (0.5 * 2. * 0.25)
                  : 2. * 2. * (0.5 * 4. * 0.0625 + 0.25);
  }
} // namespace

template <typename Dimension>
class CrackOpeningOf : public ::testing::Test
{};
TYPED_TEST_SUITE(CrackOpeningOf, Dimensions, );



TYPED_TEST(CrackOpeningOf, IsTheJumpOfTheNormalDisplacement)
{
  // At x = -0.75, -0.25 the cells are coarse, at 0.25, 0.75 fine and at the
  // latter points two of them meet. The line of integration leaves the body.
  constexpr int   dim = TypeParam::value;
  OpenedBody<dim> body(/*mixed=*/false);
  open_crack(body);
  CrackOpening<dim> opening(
    body.fields,
    parameters<dim>(dim == 2 ? "-0.75,0 : 0.75,0 : 4 ; 0.5,0 : 0.5,0 : 0,-1 : 1"
                             : "-0.75,0,0.3 : 0.75,0,0.3 : 0,1,0 : 4 ; "
                               "0.5,0,0 : 0.5,0,0 : 0,-1,0 : 1")
      .lines());
  opening.reinit(1.5);
  const std::vector<double> found =
    opening.evaluate(body.elastic, body.phase_field);
  ASSERT_EQ(found.size(), 5u);
  const double positions[] = {-0.75, -0.25, 0.25, 0.75, 0.5};
  for (unsigned int i = 0; i < 5; ++i)
    EXPECT_NEAR(found[i],
                (1. + positions[i]) * integral_of_profile(positions[i] < 0.),
                1e-10)
      << "at x = " << positions[i];
}



TYPED_TEST(CrackOpeningOf, VolumeIsTheIntegralOfTheOpening)
{
  // of 1 + x over the coarse half; over the fine one but for the cells between
  // the two, across which the opening is linear
  constexpr int   dim = TypeParam::value;
  OpenedBody<dim> body(/*mixed=*/false);
  open_crack(body);
  const double coarse = integral_of_profile(true);
  const double fine   = integral_of_profile(false);
  EXPECT_NEAR(
    crack_volume(body.fields, body.elastic, body.phase_field),
    std::pow(2., dim - 2) *
      (0.5 * coarse + 0.125 * (coarse + 1.25 * fine) + 1.21875 * fine),
    1e-11);
  body.set_phase_field([](const dealii::Point<dim> &) { return 1.; });
  EXPECT_NEAR(
    crack_volume(body.fields, body.elastic, body.phase_field), 0., 1e-12);
}



TEST(CrackOpeningEntries, AreReadAndRefused)
{
  const auto lines = parameters<2>("-1,0 : 1,2 : 5").lines();
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(lines[0].normal[0], -lines[0].normal[1], 1e-14);
  EXPECT_NEAR(lines[0].position(1).distance({-0.5, 0.5}), 0., 1e-14);
  EXPECT_EQ(problem<2>(""), "");
  EXPECT_NE(problem<2>("-1,0 : 1,2").find("begin : end"), std::string::npos);
  EXPECT_NE(problem<2>("0,0 : 0,0 : 3").find("normal"), std::string::npos);
  EXPECT_NE(problem<2>("0,0 : 1,0 : 0").find("'0' positions"),
            std::string::npos);
  EXPECT_NE(problem<2>("0 : 1,0 : 3").find("2 numbers"), std::string::npos);
  EXPECT_NE(problem<3>("0,0,0 : 1,0,0 : 3").find("normal"), std::string::npos);
}
