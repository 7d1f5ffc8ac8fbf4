// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>

#include <problem/initial_cracks.h>

#include <gtest/gtest.h>

using namespace MixedCracks;

namespace
{
  constexpr double h = 0.1;

  template <int dim>
  std::string
  problem(const InitialCracks<dim> &cracks)
  {
    try
    {
      cracks.check();
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }

  void
  expect_in(const std::string &message, const std::string &part)
  {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
} // namespace



TEST(InitialCracks, BreakTheNodesWithinHalfACellOfASegment)
{
  InitialCracks<2> cracks;
  cracks.text = "0,0 : 1,0";
  const InitialPhaseField<2> phi(cracks);
  EXPECT_EQ(phi.value({0.5, 0.05}, h), 0.);
  EXPECT_EQ(phi.value({0.5, 0.051}, h), 1.);
  EXPECT_EQ(phi.value({1.05, 0.}, h), 0.);
  EXPECT_EQ(phi.value({1.051, 0.}, h), 1.);
  EXPECT_EQ(phi.value({1.04, 0.04}, h), 1.); // a round end
}



TEST(InitialCracks, AreNotLongerWhenTheirBandIsWider)
{
  InitialCracks<2> cracks;
  cracks.text            = "0,0 : 1,0";
  cracks.half_width_text = "2*h";
  const InitialPhaseField<2> phi(cracks);
  EXPECT_EQ(phi.value({1., 0.2}, h), 0.);
  EXPECT_EQ(phi.value({0.3, 0.201}, h), 1.);
  EXPECT_EQ(phi.value({1.05, 0.}, h), 0.);
  EXPECT_EQ(phi.value({1.06, 0.}, h), 1.);
}



TEST(InitialCracks, DiscsAreBrokenCirclesInThePlane)
{
  InitialCracks<2> cracks;
  cracks.discs_text = "1,2 : 0.5";
  const InitialPhaseField<2> phi(cracks);
  EXPECT_EQ(phi.value({1.3, 2.3}, h), 0.);
  EXPECT_EQ(phi.value({1., 2.5}, h), 0.);
  EXPECT_EQ(phi.value({1., 2.51}, h), 1.);
}



TEST(InitialCracks, DiscsArePenniesInSpace)
{
  InitialCracks<3> cracks;
  cracks.discs_text      = "1,0,0 : 0,0,2 : 0.5";
  cracks.half_width_text = "h";
  const InitialPhaseField<3> phi(cracks);
  EXPECT_EQ(phi.value({1.3, 0.3, 0.1}, h), 0.);
  EXPECT_EQ(phi.value({1.3, 0.3, -0.101}, h), 1.);
  EXPECT_EQ(phi.value({1.55, 0., 0.}, h), 0.);
  EXPECT_EQ(phi.value({1., 0.56, 0.}, h), 1.);
}



TEST(InitialCracks, ExpressionIsClippedAndCannotHeal)
{
  InitialCracks<3> cracks;
  cracks.discs_text       = "0,0,0 : 0,0,1 : 1";
  cracks.phase_field_text = "x - z + 5*h";
  const InitialPhaseField<3> phi(cracks);
  EXPECT_EQ(phi.value({3., 0., 0.}, h), 1.);
  EXPECT_EQ(phi.value({-3., 0., 0.}, h), 0.);
  EXPECT_NEAR(phi.value({0., 4., 0.2}, h), 0.3, 1e-14);
  EXPECT_EQ(phi.value({0.5, 0., 0.}, h), 0.);
}



TEST(InitialCracks, RefuseWhatCannotBeRead)
{
  InitialCracks<2> flat;
  flat.discs_text = "0,0 : 0,1 : 1";
  expect_in(problem(flat), "center : radius");
  flat.discs_text = "0,0 : 0";
  expect_in(problem(flat), "greater than 0");
  flat.discs_text       = "";
  flat.phase_field_text = "x + w";
  expect_in(problem(flat), "Initial cracks/Phase field");
  InitialCracks<3> penny;
  penny.discs_text = "0,0,0 : 0,0,0 : 1";
  expect_in(problem(penny), "normal '0,0,0'");
}



TEST(InitialCracks, AWidthInHIsLookedAtOnTheMesh)
{
  InitialCracks<2> cracks;
  cracks.text            = "0,0 : 1,0";
  cracks.half_width_text = "0.3-h"; // negative for h = 1
  EXPECT_EQ(problem(cracks), "");
  const InitialPhaseField<2> phi(cracks);
  EXPECT_EQ(phi.value({0.5, 0.19}, h), 0.);
  EXPECT_THROW(phi.value({0.5, 0.}, 0.5), InputError);
  cracks.half_width_text = "-h";
  EXPECT_THROW(InitialPhaseField<2>(cracks).value({0.5, 0.}, h), InputError);
  cracks.half_width_text = "-1";
  expect_in(problem(cracks), "must not be negative");
}



TEST(InitialCracks, KnowWhichOfThemBreakANode)
{
  InitialCracks<2> cracks;
  cracks.text       = "0,0 : 1,0 ; 5,5 : 6,6";
  cracks.discs_text = "1,2 : 0.5 ; 0,3 : 0.1";
  const InitialPhaseField<2> phi(cracks);
  ASSERT_EQ(phi.names().size(), 4u);
  expect_in(phi.names()[1], "Initial cracks/Cracks: found '5,5 : 6,6'");
  expect_in(phi.names()[3], "Initial cracks/Discs: found '0,3 : 0.1'");
  std::vector<int> breaks(4, 0);
  phi.note_broken({0.5, 0.}, h, breaks);
  phi.note_broken({1.2, 2.2}, h, breaks);
  EXPECT_EQ(breaks, (std::vector<int>{1, 0, 1, 0}));
}
