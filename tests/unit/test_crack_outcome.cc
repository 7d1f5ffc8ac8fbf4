// SPDX-License-Identifier: GPL-2.0-or-later
// How a body has broken, from given cracks.
#include "imposed_cracks.h"

#include <cracks/crack_outcome.h>

#include <gtest/gtest.h>

#include <set>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr double     l = 0.3;
  const Point<2>       center(7., 3.);
  const CrackEnd::Kind on_boundary = CrackEnd::Kind::boundary;

  // 12 x 6, with a slit from the left side to (3, 3)
  std::vector<BoundaryEdge>
  plate(const bool with_hole)
  {
    std::vector<BoundaryEdge> edges = sides(Imposed());
    add_slit({0., 3.}, {3., 3.}, 0.15, edges);
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
  EXPECT_EQ(path_in_words(outcome({})), "none");
  EXPECT_EQ(path_in_words(outcome({to_hole, onward})), "through hole");
  EXPECT_EQ(path_in_words(outcome({below})), "below hole");
  EXPECT_EQ(path_in_words(outcome({across})), "above hole");
  EXPECT_EQ(path_in_words(outcome({to_hole})), "arrested");
  EXPECT_EQ(path_in_words(outcome({onward})), "arrested");
  EXPECT_EQ(path_in_words(outcome({crack("left", "", {{0., 3.}, {4., 3.}})})),
            "arrested");
  EXPECT_EQ(path_in_words(outcome({across}, false)), "other");
  // two sides to the left of the hole
  EXPECT_EQ(
    path_in_words(outcome({crack("left", "top", {{0., 3.}, {3., 6.}})})),
    "other");
}



TEST(CrackOutcome, IsMadeOfTheNamesOfBoundaries)
{
  using Names = std::vector<std::string>;
  EXPECT_EQ(outcome({to_hole, onward}).joins,
            Names({"notch to hole", "hole to right"}));
  EXPECT_EQ(outcome({to_hole, onward}).hole, "hole");
  EXPECT_EQ(outcome({across}, false).joins, Names({"left to right"}));
  EXPECT_TRUE(outcome({across}, false).hole.empty());
  EXPECT_TRUE(outcome({to_hole}).joins.empty());
  EXPECT_EQ(role_of_boundary("left"), BoundaryRole::side);
  EXPECT_EQ(role_of_boundary("slit"), BoundaryRole::notch);
}



// Every pair that classify() makes has a word of its own.
TEST(CrackOutcome, HasAWordForEverything)
{
  std::set<std::string> words;
  Outcome               separated;
  separated.kind = Outcome::Kind::separated;
  separated.hole = "bore";
  for (const Outcome::Way way : {Outcome::Way::elsewhere,
                                 Outcome::Way::through,
                                 Outcome::Way::below,
                                 Outcome::Way::above})
  {
    separated.way = way;
    words.insert(path_in_words(separated));
  }
  const std::set<std::string> expected = {
    "other", "through bore", "below bore", "above bore"};
  EXPECT_EQ(words, expected);
}



TEST(CrackOutcome, TwoSidesByWayOfTheHole)
{
  const Crack from_left = crack("left", "hole", {{0., 3.}, {6., 3.}});
  EXPECT_EQ(path_in_words(outcome({from_left, onward})), "through hole");
  // the same side twice is no connection
  const Crack again = crack("left", "hole", {{0., 2.5}, {6.1, 2.5}});
  EXPECT_EQ(path_in_words(outcome({from_left, again})), "arrested");
}



TEST(CrackOutcome, ABranchBelongsToWhatItLeaves)
{
  const Crack trunk  = crack("left", "", {{0., 5.}, {9., 5.}});
  const Crack branch = crack("crack", "right", {{8., 5.}, {12., 4.}});
  const Crack apart  = crack("crack", "right", {{8., 4.}, {12., 4.}});
  EXPECT_EQ(path_in_words(outcome({trunk, branch})), "above hole");
  EXPECT_EQ(path_in_words(outcome({trunk, apart})), "arrested");
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
}



// The ligament beyond its other tip holds.
TEST(CrackOutcome, ASlitWithinTheBodyIsNoSide)
{
  std::vector<BoundaryEdge> edges = sides(Imposed());
  add_slit({4., 3.}, {7., 3.}, 0.15, edges);
  const Crack to_right = crack("notch", "right", {{7., 3.}, {12., 3.}});
  const Crack again    = crack("notch", "right", {{7., 3.}, {12., 4.}});
  const Crack to_left  = crack("notch", "left", {{4., 3.}, {0., 3.}});
  const auto  found    = [&edges](const std::vector<Crack> &cracks) {
    return path_in_words(classify(cracks, edges, {}, l));
  };
  EXPECT_EQ(found({to_right}), "arrested");
  EXPECT_EQ(found({to_right, again}), "arrested");
  EXPECT_EQ(found({to_right, to_left}), "other");
  // by way of the slit, not of the hole
  add_hole({9., 1.5}, 0.5, edges);
  EXPECT_EQ(found({to_right}), "arrested");
  EXPECT_EQ(found({to_right, to_left}), "above hole");
}



TEST(CrackOutcome, ANotchBelongsToTheSideAtWhichItOpens)
{
  // a piece spalls off beside it
  EXPECT_EQ(path_in_words(
              outcome({crack("notch", "left", {{3., 3.}, {0., 4.}})}, false)),
            "arrested");
  EXPECT_EQ(path_in_words(
              outcome({crack("notch", "top", {{3., 3.}, {3., 6.}})}, false)),
            "other");
  // two of one name, at two sides
  std::vector<BoundaryEdge> edges = plate(false);
  add_slit({12., 3.}, {9., 3.}, 0.15, edges);
  EXPECT_TRUE(separates(
    classify({crack("notch", "notch", {{3., 3.}, {9., 3.}})}, edges, {}, l)));
}



TEST(CrackOutcome, OnlyTheOutlineHasSides)
{
  // a hole that the mesh calls otherwise
  std::vector<BoundaryEdge> edges = plate(true);
  for (BoundaryEdge &edge : edges)
    if (edge.name == "hole")
      edge.name = "pin";
  const Crack to_pin = crack("notch", "pin", {{3., 3.}, {6., 3.}});
  const Crack beyond = crack("pin", "right", {{8., 3.}, {12., 3.}});
  EXPECT_FALSE(separates(classify({to_pin}, edges, {}, l)));
  EXPECT_TRUE(separates(classify({to_pin, beyond}, edges, {}, l)));
}



TEST(CrackOutcome, CracksAtTwoHolesAreNotJoined)
{
  std::vector<BoundaryEdge> edges = plate(true);
  add_hole({10.5, 3.}, 0.5, edges);
  const Crack far     = crack("hole", "right", {{11., 3.}, {12., 3.}});
  const Crack between = crack("hole", "hole", {{8., 3.}, {10., 3.}});
  EXPECT_FALSE(separates(classify({to_hole, far}, edges, {}, l)));
  EXPECT_EQ(path_in_words(classify({to_hole, between, far}, edges, {}, l)),
            "through hole");
}
