// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>

#include <problem/rotation.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;

namespace
{
  const std::string entry = "Some/Entry";

  template <int dim>
  std::string
  refusal(const std::string &words)
  {
    try
    {
      Rotation<dim>::read(words, entry);
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }
} // namespace



TEST(Rotation, InThePlaneIsCounterClockwise)
{
  const auto rotation = Rotation<2>::read("rotation about 1, 2", entry);
  ASSERT_TRUE(rotation);
  EXPECT_EQ(rotation->components(), (std::vector<unsigned int>{0, 1}));
  const dealii::Point<2> point(4., 2.);
  const auto quarter = rotation->displacement(point, 0.5 * dealii::numbers::PI);
  EXPECT_NEAR(quarter[0], -3., 1e-14);
  EXPECT_NEAR(quarter[1], 3., 1e-14);
  // all digits of small angles: (-angle^2/2, angle) times the arm
  const auto small = rotation->displacement(point, 1e-9);
  EXPECT_NEAR(small[0], -1.5e-18, 1e-30);
  EXPECT_NEAR(small[1], 3e-9, 1e-24);
}



// Arms keep their length and their part along the axis; three turns by a third
// are none.
TEST(Rotation, AboutAnyAxisIsExact)
{
  const auto rotation =
    Rotation<3>::read("rotation about 1, 0, 2 axis 1, 1, 1", entry);
  ASSERT_TRUE(rotation);
  EXPECT_EQ(rotation->components(), (std::vector<unsigned int>{0, 1, 2}));
  const dealii::Point<3>     centre(1., 0., 2.);
  const dealii::Tensor<1, 3> axis({1., 1., 1.});
  const dealii::Point<3>     start(3., -1., 0.5);
  dealii::Point<3>           point = start;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const dealii::Point<3> next =
      point + rotation->displacement(point, 2. * dealii::numbers::PI / 3.);
    EXPECT_NEAR((next - centre).norm(), (start - centre).norm(), 1e-14);
    EXPECT_NEAR((next - centre) * axis, (start - centre) * axis, 1e-14);
    // a third of a turn about (1, 1, 1) permutes the axes
    EXPECT_NEAR((next - centre)[1], (point - centre)[0], 1e-14);
    point = next;
  }
  EXPECT_LT(point.distance(start), 1e-14);
}



TEST(Rotation, ATwistLeavesTheAxisFree)
{
  const auto twist = Rotation<3>::read("twist about 0,0,0 axis 0,-2,0", entry);
  ASSERT_TRUE(twist);
  EXPECT_EQ(twist->components(), (std::vector<unsigned int>{0, 2}));
  // clockwise seen from +y is the other way about -y
  const auto u = twist->displacement({1., 5., 0.}, 0.5 * dealii::numbers::PI);
  EXPECT_NEAR(u[2], 1., 1e-14);
  EXPECT_NEAR(u[1], 0., 1e-14);
}



TEST(Rotation, RefusalsSayHow)
{
  EXPECT_EQ(Rotation<2>::read("x", entry), nullptr);
  EXPECT_EQ(Rotation<3>::read("phase field", entry), nullptr);
  for (const char *const words : {"rotation",
                                  "rotation about 0",
                                  "rotation about 0, 0, 0",
                                  "rotation about 0, 0 axis 0, 0, 1",
                                  "rotation around 0, 0"})
  {
    const std::string message = refusal<2>(words);
    EXPECT_NE(message.find(entry), std::string::npos) << message;
    EXPECT_NE(message.find("rotation about 0, 0"), std::string::npos)
      << words << ": " << message;
  }
  EXPECT_NE(refusal<2>("rotation about x, 0").find("'x'"), std::string::npos);
  for (const char *const words : {"rotation about 0, 0, 0",
                                  "rotation about 0, 0 axis 0, 0, 1",
                                  "rotation about 0, 0, 0 axis 1, 1",
                                  "twist about 0, 0, 0"})
    EXPECT_NE(refusal<3>(words).find("axis 0, 0, 1"), std::string::npos)
      << words;
  EXPECT_NE(refusal<3>("rotation about 0,0,0 axis 0,0,0").find("length 0"),
            std::string::npos);
  EXPECT_NE(refusal<3>("twist about 0,0,0 axis 1,1,0").find("along x, y or z"),
            std::string::npos);
}
