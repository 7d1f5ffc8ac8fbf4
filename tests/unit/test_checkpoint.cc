// SPDX-License-Identifier: GPL-2.0-or-later
// A state comes back from a checkpoint with all that was seen of its damage.
#include <cracks/damage_origins.h>

#include <deal.II/grid/grid_generator.h>

#include <output/checkpoint.h>

#include <gtest/gtest.h>

#include <filesystem>

using namespace MixedCracks;
using dealii::Point;

namespace
{
  // a notch from (0, 0) to (1, 0), nodes 0.1 apart
  DamageOrigins
  notched()
  {
    std::vector<Point<3>> nodes;
    for (unsigned int i = 0; i <= 10; ++i)
      nodes.push_back({0.1 * i, 0., 0.});
    return origins_at_start(0.9, nodes);
  }

  State
  with_zero_fields(const Fields<2> &fields)
  {
    State state;
    for (const StateVector &vector : state_vectors)
      state.*vector.member = fields.ghosted_vector(
        vector.dofs == StateDofs::elastic ? fields.elastic_dofs
                                          : fields.phase_field_dofs);
    return state;
  }

  // by way of the disk
  DamageOrigins
  resumed(const DamageOrigins &origins)
  {
    // tests on other numbers of ranks run at the same time
    const std::string directory =
      ::testing::TempDir() + "mixed_cracks_checkpoint_" +
      std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      std::filesystem::remove_all(directory);
      std::filesystem::create_directories(directory);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    RunRecord record;
    record.cell_size = record.next_step = 1.;
    record.rows.resize(1);
    record.rows[0]["step"] = 0;
    const auto make_mesh   = [](auto &mesh) {
      dealii::GridGenerator::subdivided_hyper_cube(mesh, 4);
    };
    {
      dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
      make_mesh(mesh);
      Fields<2> fields(mesh, {false, 1});
      fields.distribute();
      State state          = with_zero_fields(fields);
      state.damage_origins = origins;
      Checkpoint<2>(directory, MPI_COMM_WORLD)
        .write(record, state, fields, mesh);
    }
    dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
    make_mesh(mesh);
    Checkpoint<2> checkpoint(directory, MPI_COMM_WORLD);
    checkpoint.read();
    checkpoint.load_mesh(mesh);
    Fields<2> fields(mesh, {false, 1});
    fields.distribute();
    State state;
    checkpoint.load_fields(fields, mesh, state);
    return state.damage_origins;
  }

  void
  expect_equal(const DamageOrigins &one, const DamageOrigins &other)
  {
    EXPECT_EQ(one.reach, other.reach);
    EXPECT_EQ(one.known, other.known);
    EXPECT_EQ(one.initial, other.initial);
    EXPECT_EQ(one.nuclei, other.nuclei);
    EXPECT_EQ(one.initial_has_grown, other.initial_has_grown);
  }
} // namespace



// Damage elsewhere is broken by then as the notch is, but not one of its nodes:
// where the notch begins to grow is a nucleus still.
TEST(Checkpoint, AResumedRunKnowsWhetherTheNotchHasGrown)
{
  DamageOrigins uninterrupted = notched();
  add_broken_nodes({{8., 3., 0.}, {8.1, 3., 0.}}, uninterrupted);
  DamageOrigins continued = resumed(uninterrupted);
  expect_equal(continued, uninterrupted);
  for (DamageOrigins *origins : {&uninterrupted, &continued})
    add_broken_nodes({{8.5, 3., 0.}, {1.5, 0., 0.}, {1.9, 0., 0.}}, *origins);
  ASSERT_EQ(uninterrupted.nuclei.size(), 2u);
  expect_equal(continued, uninterrupted);
  expect_equal(resumed(uninterrupted), uninterrupted);
}



// What an iteration has seen broken may have more than 0.3 in the end.
TEST(Checkpoint, AResumedRunKnowsNodesThatAreNotBrokenAnyMore)
{
  DamageOrigins uninterrupted = notched();
  add_broken_nodes({{1. / 3., 7.7, 0.4}}, uninterrupted);
  DamageOrigins continued = resumed(uninterrupted);
  EXPECT_TRUE(is_known({1. / 3., 7.7, 0.4}, continued));
  add_broken_nodes({{1. / 3., 7.7, 0.4}}, continued);
  EXPECT_EQ(continued.nuclei.size(), 1u);
}
