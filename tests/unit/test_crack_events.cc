// SPDX-License-Identifier: GPL-2.0-or-later
// What is new in the cracks of a step, and that a memory of rows is enough.
#include <cracks/crack_events.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using dealii::Point;

namespace
{
  // along y = 0 from the notch at x = 0; at 10 is the boundary "right"
  TracedCracks
  crack_to(const double x)
  {
    TracedCracks traced;
    if (x <= 0.)
      return traced;
    Crack crack;
    crack.points = {Point<2>(0., 0.), Point<2>(x, 0.)};
    crack.length = x;
    crack.start  = {CrackEnd::Kind::boundary, "notch"};
    if (x >= 10.)
      crack.end = {CrackEnd::Kind::boundary, "right"};
    traced.paths         = {crack};
    traced.separate_body = x >= 10.;
    return traced;
  }

  DamageOrigins
  origins_of(const std::vector<Point<2>> &nuclei)
  {
    DamageOrigins origins;
    origins.reach = 0.3;
    for (const Point<2> &nucleus : nuclei)
      origins.nuclei.push_back(in_space(nucleus));
    return origins;
  }

  const DamageOrigins nothing = origins_of({});
  const DamageOrigins at_tip  = origins_of({Point<2>(0., 0.)});

  // "kind boundary; ..." of a step, which is remembered
  std::string
  step(CrackEvents         &events,
       const TracedCracks  &cracks,
       const DamageOrigins &origins)
  {
    std::string words;
    for (const CrackEvent &event : events.look(cracks, origins))
    {
      events.remember(event);
      words +=
        event.kind + (event.boundary.empty() ? "" : " " + event.boundary) + ";";
    }
    return words;
  }
} // namespace



TEST(CrackEvents, OfACrackThatRunsThroughABody)
{
  CrackEvents events(event_kinds(), 2.);
  EXPECT_EQ(step(events, crack_to(0.), nothing), "start;");
  EXPECT_EQ(step(events, crack_to(0.), nothing), "");
  EXPECT_EQ(step(events, crack_to(0.5), at_tip), "onset;");
  EXPECT_EQ(step(events, crack_to(1.9), at_tip), "");
  EXPECT_EQ(step(events, crack_to(2.), at_tip), "crack length;");
  EXPECT_EQ(step(events, crack_to(1.8), at_tip), ""); // its tip is found anew
  EXPECT_EQ(step(events, crack_to(2.1), at_tip), "");
  EXPECT_EQ(step(events, crack_to(7.), at_tip), "crack length;");
  EXPECT_EQ(step(events, crack_to(10.), at_tip),
            "crack length;boundary right;separation;");
  EXPECT_EQ(step(events, crack_to(10.), at_tip), "");
}



TEST(CrackEvents, WhatIsThereAtTheStartIsNoEvent)
{
  CrackEvents  events(event_kinds(), 2.);
  TracedCracks cracks        = crack_to(3.);
  cracks.paths[0].start.name = "left";
  EXPECT_EQ(step(events, cracks, nothing), "start;start left;");
  EXPECT_EQ(step(events, cracks, nothing), "");
  cracks.paths[0].points.back() = Point<2>(4.9, 0.);
  cracks.paths[0].length        = 4.9;
  EXPECT_EQ(step(events, cracks, origins_of({Point<2>(3., 0.)})), "onset;");
  cracks.paths[0].length = 5.;
  EXPECT_EQ(step(events, cracks, origins_of({Point<2>(3., 0.)})),
            "crack length;");
}



TEST(CrackEvents, ACrackHasNotMetTheBoundaryItBeganAt)
{
  CrackEvents events({"boundary"}, 1.);
  step(events, crack_to(0.), nothing);
  TracedCracks cracks = crack_to(10.);
  // from right to the notch, from the middle, and a second one to the right
  EXPECT_EQ(step(events, cracks, origins_of({Point<2>(10., 0.)})),
            "boundary notch;");
  CrackEvents others({"boundary"}, 1.);
  step(others, crack_to(0.), nothing);
  const DamageOrigins middle = origins_of({Point<2>(5., 0.)});
  EXPECT_EQ(step(others, cracks, middle), "boundary notch;boundary right;");
  cracks.paths.push_back(cracks.paths[0]);
  cracks.paths[1].points = {Point<2>(5., 0.), Point<2>(10., 2.)};
  cracks.paths[1].start  = {CrackEnd::Kind::crack, "crack"};
  EXPECT_EQ(step(others, cracks, middle), "boundary right;");
}



TEST(CrackEvents, OnlyWhatIsWatched)
{
  CrackEvents events({"separation"}, 1.);
  EXPECT_EQ(step(events, crack_to(0.), nothing), "start;");
  EXPECT_EQ(step(events, crack_to(5.), at_tip), "");
  EXPECT_EQ(step(events, crack_to(10.), at_tip), "separation;");
}



// Wherever a run is continued from its rows, the rest is the same.
TEST(CrackEvents, GoOnFromWhatIsRemembered)
{
  const std::vector<double> lengths{0., 0.3, 1.1, 2.00000000004, 2.2, 6., 10.};
  const auto all_from = [&](const std::size_t begin, CrackEvents events) {
    std::string words;
    for (std::size_t n = begin; n < lengths.size(); ++n)
      words +=
        step(events, crack_to(lengths[n]), n > 0 ? at_tip : nothing) + '|';
    return words;
  };
  CrackEvents             live(event_kinds(), 1.);
  std::vector<CrackEvent> rows;
  for (std::size_t n = 0; n < lengths.size(); ++n)
  {
    CrackEvents resumed(event_kinds(), 1.);
    for (const CrackEvent &row : rows)
      resumed.remember(row);
    EXPECT_EQ(all_from(n, resumed), all_from(n, live)) << n;
    for (const CrackEvent &event :
         live.look(crack_to(lengths[n]), n > 0 ? at_tip : nothing))
    {
      live.remember(event);
      rows.push_back(event);
    }
  }
  EXPECT_EQ(rows.size(), 8u);
}
