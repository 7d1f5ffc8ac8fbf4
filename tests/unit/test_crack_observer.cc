// SPDX-License-Identifier: GPL-2.0-or-later
// What is traced does not depend on the order of cells, and thereby not on the
// number of ranks.
#include <cracks/crack_observer.h>

#include <deal.II/base/function.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace MixedCracks;
using dealii::Point;

namespace
{
  constexpr double l = 0.5, size = 4.;

  // squares of l/2, in the order of deal.II or the reverse one
  void
  make_square(const bool                                       reversed,
              dealii::parallel::distributed::Triangulation<2> &mesh)
  {
    dealii::Triangulation<2> serial;
    dealii::GridGenerator::subdivided_hyper_cube(
      serial, 16, 0., size, /*colorize=*/true);
    auto [vertices, cells, faces] =
      dealii::GridTools::get_coarse_mesh_description(serial);
    if (reversed)
      std::reverse(cells.begin(), cells.end());
    mesh.create_triangulation(vertices, cells, faces);
  }

  // of a crack along the diagonal, from corner to corner
  std::vector<Crack>
  diagonal_crack(const bool reversed)
  {
    dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
    make_square(reversed, mesh);
    Fields<2> fields(mesh, {false, 1});
    fields.distribute();
    LinearAlgebra::Vector owned = fields.owned_vector(fields.phase_field_dofs);
    dealii::VectorTools::interpolate(
      fields.mapping,
      fields.phase_field,
      dealii::ScalarFunctionFromFunctionObject<2>([](const Point<2> &x) {
        return std::min(1., std::abs(x[1] - x[0]) / (2. * l));
      }),
      owned);
    State state;
    state.phase_field          = fields.ghosted_vector(fields.phase_field_dofs);
    state.phase_field          = owned;
    state.damage_origins.reach = 3. * l;
    CrackObserver<2> observer(
      fields, {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}});
    observer.reinit(l);
    return observer.trace(state).paths;
  }
} // namespace



// At a corner two edges are equally near.
TEST(CrackObserver, TheOrderOfCellsDoesNotMatter)
{
  const std::vector<Crack> one   = diagonal_crack(false),
                           other = diagonal_crack(true);
  ASSERT_EQ(one.size(), other.size());
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].end.kind, CrackEnd::Kind::boundary);
  EXPECT_EQ(one[0].start.name, other[0].start.name);
  EXPECT_EQ(one[0].end.name, other[0].end.name);
  EXPECT_EQ(one[0].points, other[0].points);
}
