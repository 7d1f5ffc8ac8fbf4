// SPDX-License-Identifier: GPL-2.0-or-later
// Distances from flat pieces against the smallest of many.
#include <base/flat_piece.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace MixedCracks;
using dealii::Point;

namespace
{
  // on a fine grid over the piece
  double
  smallest_sampled_distance(const Point<3> &point, const FlatPiece<3> &piece)
  {
    constexpr unsigned int n       = 400;
    const auto            &corners = piece.corners;
    double                 result  = 1e300;
    for (unsigned int i = 0; i <= n; ++i)
      for (unsigned int j = 0; j <= n; ++j)
      {
        const double   s = 1. * i / n, t = 1. * j / n;
        const Point<3> on_piece = Point<3>(
          (1. - s) * (1. - t) * corners[0] + s * (1. - t) * corners[1] +
          (1. - s) * t * corners[2] + s * t * corners[3]);
        result = std::min(result, on_piece.distance(point));
      }
    return result;
  }
} // namespace



TEST(FlatPiece, DistanceFromASegmentInThePlane)
{
  const auto segment = FlatPiece<2>::segment({1., 1.}, {3., 1.});
  EXPECT_DOUBLE_EQ(distance<2>({2., 3.}, segment), 2.);
  EXPECT_DOUBLE_EQ(distance<2>({2.5, 1.}, segment), 0.);
  EXPECT_DOUBLE_EQ(distance<2>({0., 1.}, segment), 1.);
  EXPECT_DOUBLE_EQ(distance<2>({6., 5.}, segment), 5.);
  EXPECT_DOUBLE_EQ(distance<2>({4., 5.}, FlatPiece<2>::point({1., 1.})), 5.);
}



TEST(FlatPiece, DistanceFromARectangle)
{
  // 2 x 1 in the plane x = 1
  const FlatPiece<3> rectangle{{{Point<3>(1., 0., 0.),
                                 Point<3>(1., 2., 0.),
                                 Point<3>(1., 0., 1.),
                                 Point<3>(1., 2., 1.)}}};
  // above its inside, both sides, in both triangles and on the diagonal
  EXPECT_DOUBLE_EQ(distance<3>({4., 0.2, 0.2}, rectangle), 3.);
  EXPECT_DOUBLE_EQ(distance<3>({-1., 1.8, 0.8}, rectangle), 2.);
  EXPECT_DOUBLE_EQ(distance<3>({2., 1., 0.5}, rectangle), 1.);
  EXPECT_DOUBLE_EQ(distance<3>({1., 1.3, 0.6}, rectangle), 0.);
  // beside its edges and corners
  EXPECT_DOUBLE_EQ(distance<3>({1., 1., -3.}, rectangle), 3.);
  EXPECT_DOUBLE_EQ(distance<3>({4., 6., 0.5}, rectangle), 5.);
  EXPECT_DOUBLE_EQ(distance<3>({2., 4., 3.}, rectangle), 3.);
}



TEST(FlatPiece, DistanceFromAnyPlaneQuadrilateral)
{
  std::mt19937                           generator(7);
  std::uniform_real_distribution<double> random(-1., 1.);
  const auto                             any = [&]() {
    return dealii::Tensor<1, 3>(
      {random(generator), random(generator), random(generator)});
  };
  for (unsigned int n = 0; n < 20; ++n)
  {
    // a plane one, convex, of two arbitrary directions
    const Point<3>             origin(any());
    const dealii::Tensor<1, 3> a = any(), b = any();
    const FlatPiece<3>         piece{{{origin,
                                       Point<3>(origin + 1.5 * a),
                                       Point<3>(origin + b),
                                       Point<3>(origin + a + 0.8 * b)}}};
    const Point<3>             point(2. * any());
    EXPECT_NEAR(
      distance(point, piece), smallest_sampled_distance(point, piece), 1e-2);
    EXPECT_LE(distance(point, piece),
              smallest_sampled_distance(point, piece) + 1e-14);
  }
}



TEST(FlatPiece, DistanceFromWhatHasNoArea)
{
  const auto segment = FlatPiece<3>::segment({0., 0., 0.}, {0., 0., 2.});
  EXPECT_DOUBLE_EQ(distance<3>({3., 4., 1.}, segment), 5.);
  EXPECT_DOUBLE_EQ(distance<3>({0., 0., 5.}, segment), 3.);
  EXPECT_DOUBLE_EQ(distance<3>({0., 0., 0.5}, segment), 0.);
  const auto point = FlatPiece<3>::point({1., 1., 1.});
  EXPECT_DOUBLE_EQ(distance<3>({2., 3., 3.}, point), 3.);
}
