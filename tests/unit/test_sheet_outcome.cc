// SPDX-License-Identifier: GPL-2.0-or-later
// What cracks in space have done to the body: the boundaries they join, where
// they began, whether there are two parts.
#include "imposed_sheets.h"
#include "slit_mesh.h"

#include <cracks/sheet_outcome.h>

#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr double l = 0.2, h = 0.1;

  // to the part of the plane y = 0.52 with x < end
  Distance
  to_half_plane(const double end)
  {
    return [end](const Point<3> &x) {
      return std::hypot(x[1] - 0.52, std::max(0., x[0] - end));
    };
  }

  // With doubled nodes at y = 0.5, x < tip, that are broken, and a crack from
  // there to x = end
  struct SlitBody
  {
    SlitBody(const double tip, const double end)
      : mesh(MPI_COMM_WORLD)
      , fields(mesh, {false, 1})
      , observer(fields,
                 {{0, "left"},
                  {1, "right"},
                  {2, "bottom"},
                  {3, "top"},
                  {4, "back"},
                  {5, "front"},
                  {6, "slit"}})
    {
      const auto is_on_slit = [&](const Point<3> &x) {
        return std::abs(x[1] - 0.5) < 1e-9 && x[0] < tip - 1e-9;
      };
      dealii::Triangulation<3> serial;
      dealii::GridGenerator::subdivided_hyper_rectangle(
        serial, {12, 10, 6}, Point<3>(), Point<3>(1.2, 1., 0.6), true);
      auto [vertices, cells, faces] =
        dealii::GridTools::get_coarse_mesh_description(serial);
      open_slit<3>(0.5, is_on_slit, vertices, cells);
      mesh.create_triangulation(vertices, cells, {});
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            cell->face(f)->set_boundary_id(
              std::abs(cell->face(f)->center()[1] - 0.5) < 1e-9 ? 6 : f);
      fields.distribute();
      LinearAlgebra::Vector owned =
        fields.owned_vector(fields.phase_field_dofs);
      dealii::VectorTools::interpolate(
        fields.mapping,
        fields.phase_field,
        dealii::ScalarFunctionFromFunctionObject<3>([&](const Point<3> &x) {
          return profile("AT2",
                         std::hypot(x[1] - 0.5, std::max(0., x[0] - end)) / l);
        }),
        owned);
      state.phase_field = fields.ghosted_vector(fields.phase_field_dofs);
      state.phase_field = owned;
      state.damage_origins.reach = 3. * l;
      observer.reinit(l);
    }

    TracedCracks
    trace() const
    {
      return observer.trace(state);
    }

    dealii::parallel::distributed::Triangulation<3> mesh;
    Fields<3>                                       fields;
    State                                           state;
    CrackObserver<3>                                observer;
  };

  Outcome
  outcome_of(const Distance &distance, const std::vector<Point<3>> &nuclei = {})
  {
    ImposedSheet body({{1.2, 1., 0.6}}, h, l, "AT2", distance);
    body.state.damage_origins.nuclei = nuclei;
    const TracedCracks cracks        = body.trace();
    EXPECT_EQ(is_first_rank() && cracks.separate_body,
              separates(cracks.outcome));
    return cracks.outcome;
  }
} // namespace



TEST(SheetOutcome, NoCrack)
{
  const Outcome outcome = outcome_of([](const Point<3> &) { return 10. * l; });
  EXPECT_EQ(path_in_words(outcome), "none");
  EXPECT_EQ(outcome.start, "none");
}



TEST(SheetOutcome, ACrackFromOneSideIsArrested)
{
  ImposedSheet body({{1.2, 1., 0.6}}, h, l, "AT2", to_half_plane(0.63));
  body.state.damage_origins.nuclei = {{0., 0.5, 0.3}};
  const TracedCracks cracks        = body.trace();
  EXPECT_FALSE(cracks.separate_body);
  if (!is_first_rank())
    return;
  EXPECT_EQ(path_in_words(cracks.outcome), "arrested");
  EXPECT_EQ(cracks.outcome.start, "left");
  ASSERT_EQ(cracks.sheets.size(), 1u);
  const CrackSheet &sheet = cracks.sheets[0];
  EXPECT_EQ(sheet.start, "left");
  EXPECT_EQ(sheet.joins(), "left to back to front to tip");
  EXPECT_NEAR(sheet.area, 0.63 * 0.6, 0.5 * h * 0.6);
  // in alphabetical order; the middle of each line on the boundary comes first,
  // but for half a side: points are middles of sides
  const std::vector<Point<3>> middles{
    {0.5 * 0.63, 0.52, 0.}, {0.5 * 0.63, 0.52, 0.6}, {0., 0.52, 0.3}};
  ASSERT_EQ(sheet.contacts.size(), middles.size());
  for (std::size_t b = 0; b < middles.size(); ++b)
  {
    EXPECT_LT(sheet.contacts[b][0].distance(middles[b]), 0.75 * h) << b;
    EXPECT_GT(sheet.contacts[b].size(), 5u);
  }
  ASSERT_EQ(sheet.fronts.size(), 1u);
  EXPECT_FALSE(sheet.fronts[0].is_closed);
  EXPECT_NEAR(sheet.fronts[0].length, 0.6, 0.1 * h);
  for (const FrontPoint &point : sheet.fronts[0].points)
  {
    EXPECT_NEAR(point.position[0], 0.63, 0.5 * h);
    EXPECT_NEAR(point.position[1], 0.52, 0.1 * h);
    EXPECT_GT(point.ahead[0], 0.98);
  }
}



TEST(SheetOutcome, ACrackThroughTheBodySeparates)
{
  const Outcome outcome = outcome_of(to_half_plane(9.), {{1.2, 0.5, 0.3}});
  if (!is_first_rank())
    return;
  EXPECT_EQ(path_in_words(outcome), "other");
  EXPECT_EQ(outcome.start, "right");
  ASSERT_EQ(outcome.joins.size(), 1u);
  EXPECT_EQ(outcome.joins[0], "right to back to front to left");
}



// the ligament is 0.6 l wide: phi is below 0.5 in all of it
TEST(SheetOutcome, AFrontNearTheSideHasReachedIt)
{
  const Outcome outcome = outcome_of(to_half_plane(1.2 - 0.6 * l));
  EXPECT_EQ(separates(outcome), is_first_rank());
}



TEST(SheetOutcome, APennyBeganInTheMaterial)
{
  const Point<3> middle(0.6, 0.52, 0.3);
  const Distance penny = [&](const Point<3> &x) {
    return std::hypot(
      x[1] - middle[1],
      std::max(0., std::hypot(x[0] - middle[0], x[2] - middle[2]) - 0.25));
  };
  EXPECT_EQ(outcome_of(penny).start, is_first_rank() ? "elsewhere" : "none");
  // in a larger body, away from its sides
  const Distance far = [&](const Point<3> &x) {
    return penny(x - Tensor<1, 3>({0.5, 0.5, 0.8}));
  };
  ImposedSheet body({{2.2, 2.1, 2.2}}, h, l, "AT2", far);
  body.state.damage_origins.nuclei = {
    Point<3>(middle + Tensor<1, 3>({0.5, 0.5, 0.8}))};
  const TracedCracks cracks = body.trace();
  EXPECT_FALSE(cracks.separate_body);
  if (!is_first_rank())
    return;
  EXPECT_EQ(cracks.outcome.start, "interior");
  ASSERT_EQ(cracks.sheets.size(), 1u);
  EXPECT_EQ(cracks.sheets[0].joins(), "tip");
}



// A slit of doubled nodes up to x = 0.4 is none, a crack ahead of it is one.
TEST(SheetOutcome, ACrackBeginsAtTheTipOfASlit)
{
  for (const double end : {0.4, 0.83})
  {
    const SlitBody     body(0.4, end);
    const TracedCracks cracks = body.trace();
    EXPECT_FALSE(cracks.separate_body);
    EXPECT_EQ(cracks.sheets.size(), is_first_rank() && end > 0.4 ? 1u : 0u);
    for (const CrackSheet &sheet : cracks.sheets)
    {
      EXPECT_EQ(sheet.joins(), "slit to back to front to tip");
      EXPECT_NEAR(sheet.area, 0.43 * 0.6, 0.5 * h * 0.6);
    }
  }
}



// damage in a band along the top is no sheet, and leaves one part
TEST(SheetOutcome, DamageAlongABoundaryIsNoCrack)
{
  const Outcome outcome =
    outcome_of([](const Point<3> &x) { return 1. - x[1]; });
  EXPECT_EQ(path_in_words(outcome), "none");
}



TEST(SheetOutcome, TwoCracksAreTwoSheets)
{
  const Distance lower = to_half_plane(0.5);
  ImposedSheet   body({{1.2, 1.8, 0.6}}, h, l, "AT2", [&](const Point<3> &x) {
    return std::min(lower(x),
                    std::hypot(x[1] - 1.32, std::max(0., 0.5 - x[0])));
  });
  const TracedCracks cracks = body.trace();
  EXPECT_FALSE(cracks.separate_body);
  if (!is_first_rank())
    return;
  ASSERT_EQ(cracks.sheets.size(), 2u);
  EXPECT_EQ(cracks.sheets[0].joins(), "back to front to right to tip");
  EXPECT_EQ(cracks.sheets[1].joins(), "back to front to left to tip");
}



// the crack goes from fine cells into coarse ones
TEST(SheetOutcome, HangingNodesDoNotBreakASheet)
{
  const ImposedSheet body(
    {{1.2, 1., 0.6}}, h, l, "AT2", to_half_plane(0.83), [](const Point<3> &x) {
      return x[0] > 0.5;
    });
  const TracedCracks cracks = body.trace();
  EXPECT_FALSE(cracks.separate_body);
  if (!is_first_rank())
    return;
  ASSERT_EQ(cracks.sheets.size(), 1u);
  const CrackSheet &sheet = cracks.sheets[0];
  EXPECT_EQ(sheet.joins(), "back to front to left to tip");
  EXPECT_NEAR(sheet.area, 0.83 * 0.6, 0.05);
  ASSERT_EQ(sheet.fronts.size(), 1u);
  EXPECT_NEAR(sheet.fronts[0].length, 0.6, 0.1 * h);
}



TEST(SheetOutcome, PartsAreCountedByVolumeAndSides)
{
  const ImposedSheet body({{1.2, 1., 0.6}}, h, l, "AT2", to_half_plane(9.));
  const auto         parts = intact_parts(body.fields, body.state.phase_field);
  ASSERT_EQ(parts.size(), 2u);
  // nodes above and below the band
  for (const IntactPart &part : parts)
  {
    EXPECT_GT(part.volume, 0.2);
    EXPECT_LT(part.volume, 0.36);
    EXPECT_EQ(part.boundaries.size(), 5u);
  }
  const auto names = ImposedSheet::names();
  EXPECT_TRUE(are_separate(parts, names, l));
  EXPECT_FALSE(are_separate(parts, names, 0.4)); // parts that are crumbs
  // a piece that comes to one side only
  EXPECT_FALSE(are_separate({parts[0], {0.3, {3}}}, names, l));
}



TEST(SheetOutcome, TheWayPastAHole)
{
  CrackSheet left, right, across;
  for (CrackSheet *const sheet : {&left, &right, &across})
    sheet->triangles = {{{0, 1, 2}}};
  left.vertices     = {{0., 5., 0.}, {4., 5., 0.}, {4., 5., 1.}};
  right.vertices    = {{6., 5., 0.}, {9., 5., 0.}, {9., 5., 1.}};
  across.vertices   = {{0., 3., 0.}, {9., 3., 0.}, {9., 3., 1.}};
  left.boundaries   = {"back", "front", "hole", "left"};
  right.boundaries  = {"back", "front", "hole", "right"};
  across.boundaries = {"back", "front", "left", "right"};
  const HoleInSpace hole{"hole", {5., 5., 0.5}};
  EXPECT_EQ(path_in_words(classify({left, right}, true, hole, {}, 1.)),
            "through hole");
  EXPECT_EQ(path_in_words(classify({across, left}, true, hole, {}, 1.)),
            "below hole");
  EXPECT_EQ(path_in_words(classify({left}, false, hole, {}, 1.)), "arrested");
  EXPECT_EQ(path_in_words(classify({across}, true, {}, {}, 1.)), "other");
}
