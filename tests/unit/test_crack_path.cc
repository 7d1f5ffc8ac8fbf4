// SPDX-License-Identifier: GPL-2.0-or-later
// Crack paths found in phase fields imposed around known curves.
#include "imposed_cracks.h"

#include <cracks/crack_path_parts.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  using Profile = double (*)(double);
  using End     = CrackEnd::Kind;

  std::vector<Crack>
  trace(const Imposed &body)
  {
    return trace_cracks(body.cells(), sides(body), options(body));
  }

  // One crack, within @p path of the curve (in h), and the curve within
  // @p cover of it, which is more where it ends in the material. For all
  // optimal profiles and two cell sizes.
  void
  expect_curve(Imposed body, const double path = 0.5, const double cover = 1.)
  {
    for (const Profile profile : {wu, at1, at2})
      for (const double ratio : {0.5, 0.25})
      {
        SCOPED_TRACE("h/l = " + std::to_string(ratio));
        body.profile      = profile;
        body.h            = ratio * body.l;
        const auto cracks = trace(body);
        ASSERT_EQ(cracks.size(), 1u);
        const auto &points = cracks[0].points;
        EXPECT_LT(largest_distance(points, body.curves[0]), path * body.h);
        EXPECT_LT(largest_distance(body.curves[0], points), cover * body.h);
        double length = 0.;
        for (std::size_t i = 1; i < points.size(); ++i)
          length += points[i].distance(points[i - 1]);
        EXPECT_NEAR(cracks[0].length, length, 1e-12);
      }
  }

  Curve
  s_curve()
  {
    return curve([](const double s) {
      return Point<2>(12. * s, 3. + 1.2 * std::sin(2. * M_PI * s));
    });
  }

  Curve
  arc_of_radius_3()
  {
    return curve([](const double s) {
      const double angle = -0.3 + 2.8 * s;
      return Point<2>(6. + 3. * std::cos(angle), 2. + 3. * std::sin(angle));
    });
  }

  // a slit from the left side to the middle
  struct Notched
  {
    Imposed                   body;
    std::vector<BoundaryEdge> edges;
    const Point<2>            mouth{0., 3.}, tip{3., 3.};

    Notched()
    {
      edges = sides(body);
      add_slit(mouth, tip, body.h, edges);
      body.curves = {straight(mouth, tip)};
    }

    std::vector<Crack>
    trace() const
    {
      return trace_cracks(body.cells(), edges, options(body));
    }
  };

  const Point<2>   hole_center(7., 3.);
  constexpr double hole_radius = 1.;

  void
  drill(Notched &plate)
  {
    add_hole(hole_center, hole_radius, plate.edges);
    plate.body.is_void = [](const Point<2> &point) {
      return point.distance(hole_center) < hole_radius;
    };
  }

  Curve
  rim()
  {
    return curve([](const double s) {
      const Tensor<1, 2> direction(
        {std::cos(2. * M_PI * s), std::sin(2. * M_PI * s)});
      return hole_center + hole_radius * direction;
    });
  }
} // namespace



TEST(CrackPath, FollowsLinesOfAnyDirection)
{
  Imposed body;
  body.curves = {straight({2., 3.075}, {9., 3.075})}; // midway between nodes
  expect_curve(body);
  body.curves = {straight({0., 2.8}, {12., 3.3})};
  expect_curve(body);
  body.curves = {straight({2., 1.}, {6.1, 5.2})};
  expect_curve(body);
}



TEST(CrackPath, FollowsCurves)
{
  Imposed body;
  body.curves = {s_curve()};
  expect_curve(body);
  body.curves = {arc_of_radius_3()};
  expect_curve(body);
}



TEST(CrackPath, FollowsCurvesInDistortedAndHangingCells)
{
  Imposed body;
  body.curves     = {s_curve()};
  body.distortion = 0.3;
  expect_curve(body);
  body.distortion    = 0.;
  body.coarse_beyond = 0.8;
  expect_curve(body);
  body.curves        = {arc_of_radius_3()};
  body.coarse_beyond = 1.2;
  expect_curve(body);
}



// Where the band is one node wider on one side over three cells, its middle is
// h/2 beside the curve: more than that is not to be had.
TEST(CrackPath, FollowsWideIrregularBandsWithinACell)
{
  Imposed body;
  body.wide   = true;
  body.curves = {s_curve()};
  expect_curve(body, 1., 1.);
  body.curves = {straight({2., 0.}, {8., 6.})};
  expect_curve(body, 1., 1.);
  body.curves = {straight({0., 2.8}, {12., 3.3})};
  expect_curve(body, 1., 1.);
}



TEST(CrackPath, ClosesAGapInTheBrokenBand)
{
  Imposed body;
  body.h      = 0.075;
  body.curves = {straight({0., 3.}, {5., 3.1}),
                 straight({5.25, 3.1}, {12., 3.2})};
  // the gap has phi = 0.4 in its middle, more than broken nodes have
  const auto cracks = trace(body);
  ASSERT_EQ(cracks.size(), 1u);
  EXPECT_NEAR(cracks[0].length, 12., 0.05);
}



TEST(CrackPath, EndsExactlyOnTheBoundaryOrAtATip)
{
  Imposed body;
  body.curves       = {straight({7., 2.6}, {12., 3.})};
  const auto cracks = trace(body);
  ASSERT_EQ(cracks.size(), 1u);
  const Crack &crack = cracks[0];
  // the boundary is the start, though its x is larger
  EXPECT_EQ(crack.start.kind, End::boundary);
  EXPECT_EQ(crack.start_name(), "right");
  EXPECT_NEAR(crack.points.front()[0], 12., 1e-12);
  EXPECT_EQ(crack.end.kind, End::tip);
  EXPECT_EQ(crack.end.name, "");
  EXPECT_LT(crack.points.back().distance(Point<2>(7., 2.6)), 0.5 * body.h);
}



TEST(CrackPath, IsNoneWithoutDamage)
{
  EXPECT_TRUE(trace(Imposed()).empty());
  EXPECT_TRUE(trace_cracks({}, {}, CrackPathOptions()).empty());
}



TEST(CrackPath, ASlitIsNoCrack)
{
  Notched plate;
  for (const bool wide : {false, true})
    for (const double h : {0.15, 0.075})
    {
      plate.body.wide = wide;
      plate.body.h    = h;
      EXPECT_TRUE(plate.trace().empty());
    }
  plate.body.wide = false;
  // less than 2 l beyond it, and more
  plate.body.curves = {straight(plate.mouth, {3.4, 3.})};
  EXPECT_TRUE(plate.trace().empty());
  plate.body.curves = {straight(plate.mouth, {3.9, 3.})};
  const auto cracks = plate.trace();
  ASSERT_EQ(cracks.size(), 1u);
  EXPECT_EQ(cracks[0].start_name(), "notch");
  EXPECT_NEAR(cracks[0].length, 0.9, plate.body.h);
}



TEST(CrackPath, StartsAtTheTipOfTheNotchWithItsAngle)
{
  Notched plate;
  for (const double angle : {30., 0., -50.})
  {
    SCOPED_TRACE(angle);
    const double       radians = angle * M_PI / 180.;
    const Tensor<1, 2> direction({std::cos(radians), std::sin(radians)});
    plate.body.curves = {straight(plate.tip, plate.tip + 2.5 * direction),
                         straight(plate.mouth, plate.tip)};
    const auto cracks = plate.trace();
    ASSERT_EQ(cracks.size(), 1u);
    EXPECT_EQ(cracks[0].start_name(), "notch");
    EXPECT_LT(cracks[0].points.front().distance(plate.tip), 1e-12);
    EXPECT_NEAR(cracks[0].kink_angle, angle, 2.);
    EXPECT_NEAR(cracks[0].length, 2.5, 0.5 * plate.body.h);
    EXPECT_LT(largest_distance(cracks[0].points, plate.body.curves[0]),
              0.5 * plate.body.h);
  }
}



TEST(CrackPath, StartsAtASharpOrABluntNotch)
{
  for (const bool is_sharp : {true, false})
  {
    SCOPED_TRACE(is_sharp);
    Imposed                   body;
    std::vector<BoundaryEdge> edges;
    add_edges({0., 2.4}, {0., 0.}, "left", body.h, edges);
    add_edges({0., 0.}, {12., 0.}, "bottom", body.h, edges);
    add_edges({12., 0.}, {12., 6.}, "right", body.h, edges);
    add_edges({12., 6.}, {0., 6.}, "top", body.h, edges);
    add_edges({0., 6.}, {0., 3.6}, "left", body.h, edges);
    const double width = is_sharp ? 0. : 0.6; // half of it, at the far end
    add_edges({0., 3.6}, {3., 3. + width}, "notch", body.h, edges);
    if (!is_sharp)
      add_edges({3., 3.6}, {3., 2.4}, "notch", body.h, edges);
    add_edges({3., 3. - width}, {0., 2.4}, "notch", body.h, edges);
    body.is_void = [is_sharp](const Point<2> &point) {
      return point[0] < 3. && std::abs(point[1] - 3.) <
                                0.6 * (is_sharp ? 1. - point[0] / 3. : 1.);
    };
    body.curves       = {straight({3., 3.}, {12., 4.})};
    const auto cracks = trace_cracks(body.cells(), edges, options(body));
    ASSERT_EQ(cracks.size(), 1u);
    EXPECT_EQ(cracks[0].start_name(), "notch");
    EXPECT_EQ(cracks[0].end.name, "right");
    EXPECT_NEAR(cracks[0].kink_angle, 180. / M_PI * std::atan(1. / 9.), 2.);
    EXPECT_LT(largest_distance(cracks[0].points, body.curves[0]), 0.5 * body.h);
    EXPECT_LT(largest_distance(body.curves[0], cracks[0].points), 0.5 * body.h);
  }
}



TEST(CrackPath, MeasuresTheAngleToTheNormalElsewhere)
{
  Imposed body;
  body.curves = {straight({0., 1.}, {4., 1. + 4. * std::tan(M_PI / 6.)})};
  auto cracks = trace(body);
  ASSERT_EQ(cracks.size(), 1u);
  EXPECT_NEAR(cracks[0].kink_angle, 30., 2.);
  body.curves = {straight({2., 2.}, {4., 4.})};
  cracks      = trace(body);
  ASSERT_EQ(cracks.size(), 1u);
  EXPECT_TRUE(std::isnan(cracks[0].kink_angle));
}



TEST(CrackPath, GoesFromTheNotchToTheHoleAndOn)
{
  Notched plate;
  drill(plate);
  for (const bool with_rim : {false, true})
  {
    SCOPED_TRACE(with_rim);
    plate.body.curves = {straight(plate.tip, {6., 3.}),
                         straight({8., 3.}, {12., 3.3}),
                         straight(plate.mouth, plate.tip)};
    if (with_rim)
      plate.body.curves.push_back(rim());
    auto cracks = plate.trace();
    ASSERT_EQ(cracks.size(), 2u);
    if (cracks[0].start_name() != "notch")
      std::swap(cracks[0], cracks[1]);
    EXPECT_EQ(cracks[0].start_name(), "notch");
    EXPECT_EQ(cracks[0].end.name, "hole");
    EXPECT_NEAR(cracks[0].length, 3., 0.5 * plate.body.h);
    EXPECT_EQ(cracks[1].end.name, "right");
    EXPECT_EQ(cracks[1].start_name(), "hole");
    EXPECT_LT(largest_distance(cracks[1].points, plate.body.curves[1]),
              0.5 * plate.body.h);
  }
}



// A path along y = 3 to x = 5 whose last points have been folded back beside
// it; a kink of 60 degrees is none.
TEST(CrackPath, AnEndThatIsFoldedBackIsCut)
{
  Imposed body;
  body.curves = {straight({1., 3.}, {5., 3.})};
  const DamageField      field(body.cells(), options(body).broken);
  const BodyBoundary     boundary(sides(body));
  const CrackPathOptions all = options(body);
  const CrackPathProblem problem{field, boundary, all, field.cell_size()};
  Polyline               path;
  for (double x = 1.; x < 5.01; x += body.h)
    path.emplace_back(x, 3.);
  Polyline folded = path, kinked = path;
  for (unsigned int k = 1; k <= 3; ++k)
  {
    folded.emplace_back(path.back()[0] - k * body.h, 3.1);
    kinked.push_back(path.back() + k * body.h * Point<2>(0.5, std::sqrt(0.75)));
  }
  const auto ahead = [&](const Polyline &points) {
    return points.back()[0] - without_end(points, body.l).back()[0];
  };
  EXPECT_LT(ahead(folded), 0.);
  unfold_end(problem, folded);
  EXPECT_GT(ahead(folded), 0.);
  EXPECT_GT(folded.back()[0], path.back()[0] - 3. * body.l);
  const std::size_t n = kinked.size();
  unfold_end(problem, kinked);
  EXPECT_EQ(kinked.size(), n);
}



TEST(CrackPath, DamageAlongTheBoundaryIsNoCrack)
{
  Notched plate;
  drill(plate);
  for (const bool wide : {false, true})
  {
    plate.body.wide   = wide;
    plate.body.curves = {rim(), straight({0., 0.}, {12., 0.})};
    EXPECT_TRUE(plate.trace().empty());
  }
}



TEST(CrackPath, SwingsAroundTheHole)
{
  Notched plate;
  drill(plate);
  plate.body.curves = {curve([](const double s) {
                         return Point<2>(3. + 9. * s,
                                         3. - 1.8 * std::sin(M_PI * s));
                       }),
                       straight(plate.mouth, plate.tip)};
  const auto cracks = plate.trace();
  ASSERT_EQ(cracks.size(), 1u);
  EXPECT_EQ(cracks[0].start_name(), "notch");
  EXPECT_EQ(cracks[0].end.name, "right");
  const Curve &points = cracks[0].points;
  EXPECT_LT(largest_distance(points, plate.body.curves[0]), 0.5 * plate.body.h);
  EXPECT_LT(largest_distance(plate.body.curves[0], points), 0.5 * plate.body.h);
}



TEST(CrackPath, ABranchIsACrackOfItsOwn)
{
  Imposed body;
  body.curves = {straight({0., 3.}, {12., 3.}), straight({5., 3.}, {9., 5.})};
  const auto cracks = trace(body);
  ASSERT_EQ(cracks.size(), 2u);
  EXPECT_EQ(cracks[0].start_name(), "left");
  EXPECT_EQ(cracks[0].end.name, "right");
  EXPECT_EQ(cracks[1].start.kind, End::crack);
  EXPECT_EQ(cracks[1].start_name(), "crack");
  // exactly on the other one; where they part the bands are one
  EXPECT_LT(nearest(cracks[0].points, cracks[1].points.front()).distance,
            0.02 * body.h);
  EXPECT_LT(largest_distance(cracks[1].points, body.curves[1]), 1.5 * body.h);
  EXPECT_LT(cracks[1].points.back().distance(Point<2>(9., 5.)), body.h);
  EXPECT_LT(nearest(cracks[1].points, {7., 4.}).distance, 0.5 * body.h);
}



TEST(CrackPath, StartsAtTheNucleus)
{
  Imposed body;
  body.curves            = {straight({0., 2.8}, {12., 3.3})};
  CrackPathOptions hints = options(body);
  const auto       start = [&]() {
    const auto cracks = trace_cracks(body.cells(), sides(body), hints);
    return cracks.size() == 1 ? cracks[0].start_name() : "?";
  };
  EXPECT_EQ(start(), "left");
  hints.nuclei = {{11.5, 3.3}};
  EXPECT_EQ(start(), "right");
  hints.nuclei = {{6., 3.}};
  EXPECT_EQ(start(), "interior");
}
