// SPDX-License-Identifier: GPL-2.0-or-later
// Which cells of the elastic matrix are out of date, and whether it is worth
// correcting them.
#include <assembly/elastic_tangent.h>

#include <gtest/gtest.h>

using namespace MixedCracks;

namespace
{
  constexpr unsigned int n_cells = 10, n_points = 4;

  using Points = std::vector<ElasticPoint<2>>;

  Points
  points(const double degradation, const int regime)
  {
    return Points(n_points, {{}, 0., degradation, regime});
  }

  ElasticTangent<2>
  tangent_with_matrix()
  {
    ElasticTangent<2> tangent;
    tangent.reinit(n_cells, n_points);
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      tangent.set_present(cell, points(1., 0));
    tangent.note_matrix(/*was_corrected=*/false);
    return tangent;
  }

  TEST(ElasticTangent, WithoutAMatrixAllCellsAreNew)
  {
    ElasticTangent<2> tangent;
    tangent.reinit(n_cells, n_points);
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      tangent.set_present(cell, points(1., 0));
    EXPECT_EQ(tangent.changed_cells().size(), n_cells);
    EXPECT_FALSE(tangent.is_to_be_corrected(1., n_cells));
  }

  TEST(ElasticTangent, OnePointOfACellIsEnough)
  {
    ElasticTangent<2> tangent = tangent_with_matrix();
    EXPECT_TRUE(tangent.changed_cells().empty());

    Points changed             = points(1., 0);
    changed.back().degradation = 0.5;
    tangent.set_present(3, changed);
    EXPECT_EQ(tangent.changed_cells(), std::vector<unsigned int>{3});
    TangentDistance distance;
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      tangent.compare(cell, distance);
    EXPECT_DOUBLE_EQ(distance.degradation, 1.);
    EXPECT_EQ(distance.regime_changes, 0.);

    changed.front().tangent_regime = 1;
    tangent.set_present(3, changed);
    tangent.compare(3, distance);
    EXPECT_EQ(distance.regime_changes, 1.);
  }

  // a tangent that depends on the strain within its regime
  TEST(ElasticTangent, NegativeBranchesAlwaysDiffer)
  {
    ElasticTangent<2> tangent = tangent_with_matrix();
    tangent.set_present(7, points(1., -1));
    tangent.note_matrix(/*was_corrected=*/true);
    EXPECT_EQ(tangent.changed_cells(), std::vector<unsigned int>{7});
    TangentDistance distance;
    tangent.compare(7, distance);
    EXPECT_EQ(distance.regime_changes, n_points);
  }

  TEST(ElasticTangent, FewChangesAreCorrectedButNotForEver)
  {
    ElasticTangent<2> tangent = tangent_with_matrix();
    EXPECT_TRUE(tangent.is_to_be_corrected(2., n_cells));
    EXPECT_FALSE(tangent.is_to_be_corrected(3., n_cells));
    for (unsigned int i = 0; i < 50; ++i)
    {
      EXPECT_TRUE(tangent.is_to_be_corrected(1., n_cells));
      tangent.note_matrix(/*was_corrected=*/true);
    }
    EXPECT_FALSE(tangent.is_to_be_corrected(1., n_cells));
    tangent.note_matrix(/*was_corrected=*/false);
    EXPECT_TRUE(tangent.is_to_be_corrected(1., n_cells));
  }
} // namespace
