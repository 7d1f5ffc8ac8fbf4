// SPDX-License-Identifier: GPL-2.0-or-later
// What is traced does not depend on the order of cells, and thereby not on the
// number of ranks.
#include "slit_mesh.h"

#include <cracks/crack_observer.h>

#include <deal.II/base/function.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>
#include <deal.II/numerics/vector_tools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace MixedCracks;
using namespace MixedCracks::Testing;
using dealii::Point;

namespace
{
  constexpr double l = 0.5, size = 4.;

  constexpr dealii::types::boundary_id slit = 4, notch = 5;

  bool
  is_on_slit(const Point<2> &x)
  {
    return std::abs(x[1] - 0.5 * size) < 1e-12 &&
           std::abs(x[0] - 0.5 * size) > 1.01;
  }

  // Squares of l/2, in the order of deal.II or the reverse one, with a slit of
  // two cells length from the left side and one from the right
  void
  make_square(const bool                                       reversed,
              dealii::parallel::distributed::Triangulation<2> &mesh)
  {
    dealii::Triangulation<2> serial;
    dealii::GridGenerator::subdivided_hyper_cube(
      serial, 16, 0., size, /*colorize=*/true);
    auto [vertices, cells, faces] =
      dealii::GridTools::get_coarse_mesh_description(serial);
    open_slit<2>(0.5 * size, is_on_slit, vertices, cells);
    if (reversed)
      std::reverse(cells.begin(), cells.end());
    mesh.create_triangulation(vertices, cells, {});
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
        {
          const Point<2> x = cell->face(f)->center();
          cell->face(f)->set_boundary_id(!is_on_slit(x)      ? f
                                         : x[0] < 0.5 * size ? slit
                                                             : notch);
        }
  }

  // of a crack from tip to tip
  std::vector<Crack>
  crack_between_tips(const bool reversed)
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
        const double beyond = std::max(0., std::abs(x[0] - 0.5 * size) - 1.);
        return std::min(1., std::hypot(beyond, x[1] - 0.5 * size) / (2. * l));
      }),
      owned);
    State state;
    state.phase_field          = fields.ghosted_vector(fields.phase_field_dofs);
    state.phase_field          = owned;
    state.damage_origins.reach = 3. * l;
    CrackObserver<2> observer(fields,
                              {{0, "left"},
                               {1, "right"},
                               {2, "bottom"},
                               {3, "top"},
                               {slit, "slit"},
                               {notch, "notch"}});
    observer.reinit(l);
    return observer.trace(state).paths;
  }
} // namespace



// A crack that meets the tip of a notch has the name of the first edge of a
// notch, for one.
TEST(CrackObserver, TheOrderOfCellsDoesNotMatter)
{
  const std::vector<Crack> one   = crack_between_tips(false),
                           other = crack_between_tips(true);
  ASSERT_EQ(one.size(), other.size());
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].end.kind, CrackEnd::Kind::boundary);
  EXPECT_EQ(one[0].start.name, other[0].start.name);
  EXPECT_EQ(one[0].end.name, other[0].end.name);
  EXPECT_EQ(one[0].points, other[0].points);
}
