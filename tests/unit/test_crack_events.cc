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

  // The same in space: a body of 10 x 4 x 4 with a slit that runs through it
  // from the side x = 0, a crack from the slit to x. Sheets touch boundaries in
  // lines, of which the middle of the crack is the first point.
  TracedCracks
  sheet_to(const double x)
  {
    TracedCracks traced;
    if (x <= 0.)
      return traced;
    CrackSheet sheet;
    sheet.area       = 4. * x;
    sheet.start      = "slit";
    sheet.boundaries = {"back", "front", "slit"};
    for (const double z : {0., 4.})
    {
      sheet.contacts.push_back({{0.5 * x, 2., z}});
      for (double s = 0.1; s < x; s += 0.2)
        sheet.contacts.back().emplace_back(s, 2., z);
    }
    sheet.contacts.push_back({{0., 2., 2.}});
    if (x >= 10.)
    {
      sheet.boundaries.insert(sheet.boundaries.begin() + 2, "right");
      sheet.contacts.insert(sheet.contacts.begin() + 2,
                            {{10., 2., 2.}, {10., 2., 1.}});
    }
    traced.sheets        = {sheet};
    traced.separate_body = x >= 10.;
    return traced;
  }

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
  CrackEvents events(2, event_kinds(2), 2.);
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
  CrackEvents  events(2, event_kinds(2), 2.);
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
  CrackEvents events(2, {"boundary"}, 1.);
  step(events, crack_to(0.), nothing);
  TracedCracks cracks = crack_to(10.);
  // from right to the notch, from the middle, and a second one to the right
  EXPECT_EQ(step(events, cracks, origins_of({Point<2>(10., 0.)})),
            "boundary notch;");
  CrackEvents others(2, {"boundary"}, 1.);
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
  CrackEvents events(2, {"separation"}, 1.);
  EXPECT_EQ(step(events, crack_to(0.), nothing), "start;");
  EXPECT_EQ(step(events, crack_to(5.), at_tip), "");
  EXPECT_EQ(step(events, crack_to(10.), at_tip), "separation;");
}



// Wherever a run is continued from its rows, the rest is the same.
TEST(CrackEvents, GoOnFromWhatIsRemembered)
{
  const std::vector<double> lengths{0., 0.3, 1.1, 2.00000000004, 2.2, 6., 10.};
  for (const int dim : {2, 3})
  {
    const CrackEvents anew(dim, event_kinds(dim), dim == 2 ? 1. : 4.);
    const auto        look = [&](const std::size_t n, CrackEvents &events) {
      return step(events,
                  dim == 2 ? crack_to(lengths[n]) : sheet_to(lengths[n]),
                  n > 0 ? at_tip : nothing);
    };
    const auto all_from = [&](const std::size_t begin, CrackEvents events) {
      std::string words;
      for (std::size_t n = begin; n < lengths.size(); ++n)
        words += look(n, events) + '|';
      return words;
    };
    CrackEvents             live = anew;
    std::vector<CrackEvent> rows;
    for (std::size_t n = 0; n < lengths.size(); ++n)
    {
      CrackEvents resumed = anew;
      for (const CrackEvent &row : rows)
        resumed.remember(row);
      EXPECT_EQ(all_from(n, resumed), all_from(n, live)) << dim << ' ' << n;
      for (const CrackEvent &event :
           live.look(dim == 2 ? crack_to(lengths[n]) : sheet_to(lengths[n]),
                     n > 0 ? at_tip : nothing))
      {
        live.remember(event);
        rows.push_back(event);
      }
    }
    EXPECT_EQ(rows.size(), dim == 2 ? 8u : 10u);
  }
}



TEST(CrackEvents, OfASheetThatRunsThroughABody)
{
  CrackEvents events(3, event_kinds(3), 8.); // mm^2, 2 mm
  EXPECT_EQ(step(events, sheet_to(0.), nothing), "start;");
  EXPECT_EQ(step(events, sheet_to(0.5), at_tip),
            "onset;boundary back;boundary front;");
  // lines on sides that have been met grow
  EXPECT_EQ(step(events, sheet_to(1.9), at_tip), "");
  EXPECT_EQ(step(events, sheet_to(2.), at_tip), "crack area;");
  EXPECT_EQ(step(events, sheet_to(7.), at_tip), "crack area;");
  EXPECT_EQ(step(events, sheet_to(10.), at_tip),
            "crack area;boundary right;separation;");
  EXPECT_EQ(step(events, sheet_to(10.), at_tip), "");
}



TEST(CrackEvents, EachSheetMeetsABoundary)
{
  CrackEvents  events(3, {"boundary"}, 1.);
  TracedCracks cracks = sheet_to(3.);
  cracks.sheets[0].start.clear(); // an initial crack
  EXPECT_EQ(step(events, cracks, nothing),
            "start;start back;start front;start slit;");
  TracedCracks other = sheet_to(3.);
  for (auto &line : other.sheets[0].contacts)
    for (dealii::Point<3> &point : line)
      point[1] = 3.;
  cracks.sheets.push_back(other.sheets[0]);
  EXPECT_EQ(step(events, cracks, nothing), "boundary back;boundary front;");
  EXPECT_EQ(step(events, cracks, nothing), "");
}



TEST(CrackEvents, HaveAPlaceAndASizeInSpace)
{
  CrackEvents events(3, event_kinds(3), 8.);
  step(events, sheet_to(0.), nothing);
  DamageOrigins origins               = at_tip;
  origins.nuclei[0][2]                = 1.5;
  const std::vector<CrackEvent> found = events.look(sheet_to(3.), origins);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].place.value(), Point<3>(0., 0., 1.5));
  EXPECT_EQ(found[1].kind, "crack area");
  EXPECT_EQ(found[1].growth, 12.);
  EXPECT_FALSE(found[1].place);
  EXPECT_EQ(found[2].place.value(), Point<3>(1.5, 2., 0.));
  EXPECT_EQ(found[3].place.value(), Point<3>(1.5, 2., 4.));
}
