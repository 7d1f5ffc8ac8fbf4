// SPDX-License-Identifier: GPL-2.0-or-later
// How a body has broken, from given cracks.
#include "imposed_cracks.h"

#include <cracks/crack_outcome.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr double     l = 0.3;
  const Point<2>       center(7., 3.);
  const CrackEnd::Kind on_boundary = CrackEnd::Kind::boundary;

  std::vector<BoundaryEdge>
  plate(const bool with_hole)
  {
    std::vector<BoundaryEdge> edges = sides(Imposed());
    if (with_hole)
      add_hole(center, 1., edges);
    return edges;
  }

  CrackEnd
  end(const std::string &name)
  {
    if (name.empty())
      return {};
    return {name == "crack" ? CrackEnd::Kind::crack : on_boundary, name};
  }

  Crack
  crack(const std::string           &start,
        const std::string           &end_name,
        const std::vector<Point<2>> &points)
  {
    Crack result;
    result.points = points;
    for (std::size_t i = 1; i < points.size(); ++i)
      result.length += points[i].distance(points[i - 1]);
    result.start = end(start);
    result.end   = end(end_name);
    return result;
  }

  Outcome
  outcome(const std::vector<Crack>    &cracks,
          const bool                   with_hole = true,
          const std::vector<Point<2>> &nuclei    = {})
  {
    return classify(cracks, plate(with_hole), nuclei, l);
  }

  const Crack to_hole = crack("notch", "hole", {{3., 3.}, {6., 3.}});
  const Crack onward  = crack("hole", "right", {{8., 3.}, {12., 3.}});
  const Crack below =
    crack("notch", "right", {{3., 3.}, {6., 1.5}, {8., 1.5}, {12., 3.}});
  const Crack across = crack("left", "right", {{0., 5.}, {12., 5.2}});
} // namespace



TEST(CrackOutcome, NamesThePath)
{
  EXPECT_EQ(outcome({}).path, "none");
  EXPECT_EQ(outcome({to_hole, onward}).path, "through hole");
  EXPECT_EQ(outcome({below}).path, "below hole");
  EXPECT_EQ(outcome({across}).path, "above hole");
  EXPECT_EQ(outcome({to_hole}).path, "arrested");
  EXPECT_EQ(outcome({onward}).path, "arrested");
  EXPECT_EQ(outcome({crack("left", "", {{0., 3.}, {4., 3.}})}).path,
            "arrested");
  EXPECT_EQ(outcome({across}, false).path, "other");
  // two sides to the left of the hole
  EXPECT_EQ(outcome({crack("left", "top", {{0., 3.}, {3., 6.}})}).path,
            "other");
}



TEST(CrackOutcome, TwoSidesByWayOfTheHole)
{
  const Crack from_left = crack("left", "hole", {{0., 3.}, {6., 3.}});
  EXPECT_EQ(outcome({from_left, onward}).path, "through hole");
  // the same side twice is no connection
  const Crack again = crack("left", "hole", {{0., 2.5}, {6.1, 2.5}});
  EXPECT_EQ(outcome({from_left, again}).path, "arrested");
}



TEST(CrackOutcome, ABranchBelongsToWhatItLeaves)
{
  const Crack trunk  = crack("left", "", {{0., 5.}, {9., 5.}});
  const Crack branch = crack("crack", "right", {{8., 5.}, {12., 4.}});
  const Crack apart  = crack("crack", "right", {{8., 4.}, {12., 4.}});
  EXPECT_EQ(outcome({trunk, branch}).path, "above hole");
  EXPECT_EQ(outcome({trunk, apart}).path, "arrested");
}



TEST(CrackOutcome, NamesTheStart)
{
  EXPECT_EQ(outcome({}).start, "none");
  EXPECT_EQ(outcome({onward, to_hole}).start, "notch");
  EXPECT_EQ(outcome({across}).start, "left");
  EXPECT_EQ(outcome({onward}).start, "hole");
  EXPECT_EQ(outcome({crack("", "", {{1., 1.}, {4., 1.}})}).start, "elsewhere");
  EXPECT_EQ(outcome({crack("left", "", {{0., 5.5}, {4., 3.}})}).start,
            "corner top left");
  EXPECT_EQ(outcome({crack("left", "", {{0., 5.}, {4., 3.}})}).start, "left");
  EXPECT_EQ(outcome({crack("bottom", "", {{11.5, 0.}, {9., 3.}})}).start,
            "corner bottom right");
  Crack both_ways         = across;
  both_ways.from_interior = true;
  EXPECT_EQ(outcome({both_ways}).start, "interior");
}



TEST(CrackOutcome, TheFirstNucleusTellsWhichCrackIsTheFirst)
{
  const Crack from_left = crack("left", "hole", {{0., 3.}, {6., 3.}});
  EXPECT_EQ(outcome({onward, from_left}).start, "left"); // the longer one
  EXPECT_EQ(outcome({onward, from_left}, true, {{8.1, 3.}, {0., 3.}}).start,
            "hole");
}



TEST(CrackOutcome, ACrackFromTheHoleMayReachTheNotch)
{
  EXPECT_EQ(outcome({to_hole, onward}, true, {{6., 3.}, {8., 3.}}).start,
            "hole");
  EXPECT_EQ(outcome({to_hole, onward}, true, {{3., 3.}, {8., 3.}}).start,
            "notch");
  // what has become of no crack does not count
  EXPECT_EQ(outcome({to_hole, onward}, true, {{8., 9.}, {3., 3.}}).start,
            "notch");
}



// A crack that stands under the hole separates nothing, however little force is
// left.
TEST(CrackOutcome, OnlyAConnectionSeparates)
{
  EXPECT_FALSE(separates(outcome({})));
  EXPECT_FALSE(separates(outcome({to_hole})));
  EXPECT_TRUE(separates(outcome({onward, to_hole})));
  EXPECT_TRUE(separates(outcome({across})));
  EXPECT_FALSE(separates({not_traced, not_traced}));
}
