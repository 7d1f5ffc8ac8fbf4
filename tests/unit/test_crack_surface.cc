// SPDX-License-Identifier: GPL-2.0-or-later
// The crack surface of imposed profiles: that of a plane crack, whatever the
// toughness; and the surface phi = 0.5 as triangles, that of a ball.
#include "materials.h"

#include <assembly/assembler.h>

#include <base/errors.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <output/crack_surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

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

  constexpr double radius = 0.35;

  // phi = 0.5 at this radius in the unit cube of n^3 cells, some of them
  // refined
  struct Ball
  {
    explicit Ball(const unsigned int n_cells)
      : mesh(MPI_COMM_WORLD)
      , fields(mesh, {false, 1})
    {
      dealii::GridGenerator::subdivided_hyper_cube(mesh, n_cells, -0.5, 0.5);
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned() && cell->center()[0] > 0.4)
          cell->set_refine_flag();
      mesh.execute_coarsening_and_refinement();
      fields.distribute();
      LinearAlgebra::Vector owned =
        fields.owned_vector(fields.phase_field_dofs);
      dealii::VectorTools::interpolate(
        fields.mapping,
        fields.phase_field,
        dealii::ScalarFunctionFromFunctionObject<3>(
          [](const Point<3> &x) { return 0.5 + x.norm() - radius; }),
        owned);
      phase_field = fields.ghosted_vector(fields.phase_field_dofs);
      phase_field = owned;
    }

    dealii::parallel::distributed::Triangulation<3> mesh;
    Fields<3>                                       fields;
    LinearAlgebra::Vector                           phase_field;
  };

  double
  area(const Triangles &triangles)
  {
    double sum = 0.;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
      sum += 0.5 * dealii::cross_product_3d(triangles[i + 1] - triangles[i],
                                            triangles[i + 2] - triangles[i])
                     .norm();
    return sum;
  }

  bool
  is_first()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }

  // between the first tag that begins with @p tag and the next one
  std::string
  array_after(const std::string &text, const std::string &tag)
  {
    const std::size_t begin = text.find('>', text.find(tag)) + 1;
    return text.substr(begin, text.find('<', begin) - begin);
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



TEST(CrackSurface, OfABallConverges)
{
  const double exact = 4. * dealii::numbers::PI * radius * radius;
  double       errors[2];
  for (const unsigned int i : {0, 1})
  {
    const Ball      ball(8 << i);
    const Triangles triangles = crack_surface(ball.fields, ball.phase_field);
    EXPECT_EQ(triangles.empty(), !is_first());
    for (const Point<3> &corner : triangles)
      EXPECT_NEAR(corner.norm(), radius, 0.05 / (1 << 2 * i));
    errors[i] = std::abs(area(triangles) / exact - 1.);
  }
  if (is_first())
  {
    EXPECT_LT(errors[0], 0.05);
    EXPECT_LT(errors[1], 0.3 * errors[0]);
  }
}



TEST(CrackSurface, IsWrittenForParaView)
{
  const std::string directory = ::testing::TempDir() + "mixed_cracks_surface";
  if (is_first())
    std::filesystem::create_directories(directory + "/fields");
  MPI_Barrier(MPI_COMM_WORLD);
  const Ball        ball(6);
  const std::string name = "fields/crack_surface_00003.vtp";
  write_crack_surface(
    ball.fields, ball.phase_field, directory, name, {{0.5, name}});
  const Triangles triangles = crack_surface(ball.fields, ball.phase_field);
  if (is_first())
  {
    std::ifstream     list(directory + "/crack_surface.pvd");
    std::stringstream text;
    text << list.rdbuf();
    EXPECT_NE(text.str().find("timestep=\"0.5\""), std::string::npos);
    EXPECT_NE(text.str().find(name), std::string::npos);

    std::ifstream     file(directory + "/" + name);
    std::stringstream content;
    content << file.rdbuf();
    std::istringstream points(
      array_after(content.str(), "<DataArray type=\"Float64\""));
    Triangles read;
    for (Point<3> point; points >> point[0] >> point[1] >> point[2];)
      read.push_back(point);
    EXPECT_EQ(read.size(), triangles.size());
    EXPECT_NEAR(area(read), area(triangles), 1e-6);
    EXPECT_NE(content.str().find("NumberOfPolys=\"" +
                                 std::to_string(triangles.size() / 3) + "\""),
              std::string::npos);
  }
  // a directory that is not there
  EXPECT_THROW(write_crack_surface(ball.fields,
                                   ball.phase_field,
                                   directory + "/nowhere",
                                   name,
                                   {{0.5, name}}),
               FileError);
}
