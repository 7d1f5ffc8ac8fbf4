// SPDX-License-Identifier: GPL-2.0-or-later
// The crack surface of imposed profiles: that of a plane crack, whatever the
// toughness.
#include "materials.h"

#include <assembly/assembler.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  using dealii::Point;

  constexpr double length = 0.3, half_height = 1.2;

  // 0.7 wide, in 3-d 0.5 deep, with the optimal profile across y = 0
  template <int dim>
  Energies
  cracked_box(const std::string &density, const unsigned int n_cells)
  {
    MaterialDescription matter = description("none", "degraded bulk", 3);
    matter.crack_density       = density;
    matter.length_scale        = length;
    const Material<dim> material(matter);

    dealii::parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
    Point<dim>                                        lower, upper;
    lower[1]                        = -half_height;
    upper[0]                        = 0.7;
    upper[1]                        = half_height;
    std::vector<unsigned int> cells = {2, n_cells};
    if (dim == 3)
    {
      upper[dim - 1] = 0.5;
      cells.push_back(1);
    }
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, cells, lower, upper);
    Fields<dim> fields(mesh, {false, 1});
    fields.distribute();
    // G_c is 2 at the left and 5 at the right
    Assembler<dim> assembler(
      fields, material, [](const Point<dim> &x, unsigned int) {
        return PointConstants{1., 1., x[0] < 0.35 ? 2. : 5.};
      });
    assembler.reinit();

    LinearAlgebra::Vector owned = fields.owned_vector(fields.phase_field_dofs);
    dealii::VectorTools::interpolate(
      fields.mapping,
      fields.phase_field,
      dealii::ScalarFunctionFromFunctionObject<dim>([&](const Point<dim> &x) {
        return material.crack_density().optimal_profile(std::abs(x[1]) /
                                                        length);
      }),
      owned);
    LinearAlgebra::Vector phase_field =
      fields.ghosted_vector(fields.phase_field_dofs);
    phase_field = owned;
    const LinearAlgebra::Vector rest =
      fields.ghosted_vector(fields.elastic_dofs);
    return assembler.energies(rest, phase_field, phase_field);
  }

  template <int dim>
  void
  expect_unit_cracks()
  {
    const double area = dim == 2 ? 0.7 : 0.7 * 0.5;
    for (const std::string &density : all_crack_densities().names())
    {
      SCOPED_TRACE(density);
      // the profile of AT2 does not end within the box
      const double exact =
        area *
        (density == "AT2" ? 1. - std::exp(-2. * half_height / length) : 1.);
      const Energies coarse = cracked_box<dim>(density, 32),
                     fine   = cracked_box<dim>(density, 64);
      EXPECT_NEAR(fine.crack_surface, exact, 5e-3 * exact);
      EXPECT_LT(std::abs(fine.crack_surface - exact),
                0.3 * std::abs(coarse.crack_surface - exact));
      // half of it with each toughness
      EXPECT_NEAR(fine.crack, 3.5 * fine.crack_surface, 1e-12);
    }
  }
} // namespace



TEST(CrackSurface, IsTheLengthOfACrackInThePlane)
{
  expect_unit_cracks<2>();
}



TEST(CrackSurface, IsTheAreaOfACrackInSpace)
{
  expect_unit_cracks<3>();
}
