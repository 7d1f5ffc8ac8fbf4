// SPDX-License-Identifier: GPL-2.0-or-later
// The displacement at points, against fields that the elements hold exactly.
#include "imposed_opening.h"

#include <base/errors.h>

#include <output/point_displacements.h>

#include <gtest/gtest.h>

#include "geometries.h"

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  template <int dim>
  std::vector<NamedPoint<dim>>
  points(const std::string &text)
  {
    PointDisplacementParameters<dim> parameters;
    parameters.text = text;
    return parameters.points();
  }

  // linear, or quadratic
  template <int dim>
  dealii::Tensor<1, dim>
  displacement(const dealii::Point<dim> &x, const bool quadratic)
  {
    dealii::Tensor<1, dim> u;
    for (unsigned int d = 0; d < dim; ++d)
      u[d] = 0.3 + d + (1.5 - d) * x[0] - 0.7 * x[(d + 1) % dim] +
             (quadratic ? x[0] * x[dim - 1] + 2. * x[1] * x[1] : 0.);
    return u;
  }

  // Within cells, on faces between coarse and fine ones and between ranks, at
  // vertices, at a hanging node, and on the boundary
  template <int dim>
  std::string
  everywhere()
  {
    return dim == 2 ? "a : 0.3333, -0.71 ; b : 0, 0.25 ; c : -0.5, 0.5 ; "
                      "d : 0.5, 0.1234 ; corner : 1, -1 ; side : -1, 0.07 ; "
                      "e : -0.9, 0.9"
                    : "a : 0.3333, -0.71, 0.11 ; b : 0, 0.25, 0.25 ; "
                      "c : -0.5, 0.5, 0 ; d : 0.5, 0.1234, -0.25 ; "
                      "corner : 1, -1, 1 ; side : -1, 0.07, 0.3";
  }

  template <int dim>
  void
  expect_exact(const OpenedBody<dim> &body, const bool quadratic)
  {
    const auto              at = points<dim>(everywhere<dim>());
    PointDisplacements<dim> displacements(body.fields, at);
    displacements.reinit();
    const std::vector<double> found = displacements.evaluate(body.elastic);
    ASSERT_EQ(found.size(), dim * at.size());
    for (std::size_t i = 0; i < at.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        EXPECT_NEAR(
          found[dim * i + d], displacement(at[i].position, quadratic)[d], 1e-12)
          << at[i].name << ", component " << d;
  }
} // namespace

template <typename Dimension>
class PointDisplacementsOf : public ::testing::Test
{};
TYPED_TEST_SUITE(PointDisplacementsOf, Dimensions, );



TYPED_TEST(PointDisplacementsOf, AreThoseOfTheField)
{
  constexpr int dim = TypeParam::value;
  for (const bool quadratic : {false, true})
  {
    OpenedBody<dim> body(/*mixed=*/quadratic);
    body.set_displacement([quadratic](const dealii::Point<dim> &x) {
      return displacement(x, quadratic);
    });
    expect_exact(body, quadratic);
  }
}



TYPED_TEST(PointDisplacementsOf, RefusePointsOutside)
{
  constexpr int           dim = TypeParam::value;
  OpenedBody<dim>         body(/*mixed=*/false);
  PointDisplacements<dim> displacements(
    body.fields,
    points<dim>(dim == 2 ? "in : 0, 0 ; far out : 0, 1.001"
                         : "in : 0, 0, 0 ; far out : 0, 0, 1.001"));
  try
  {
    displacements.reinit();
    FAIL() << "accepted";
  }
  catch (const InputError &error)
  {
    EXPECT_NE(std::string(error.what()).find("far out"), std::string::npos);
  }
}



// Finer cells above the slit, from x = 0 to 0.5 at y = 0.5, which has moved by
// 1: at a vertex of theirs two cells meet one below.
TEST(PointDisplacementsAtSlits, AreTheMeanOfTheFaces)
{
  dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
  GeometryTests::geometry("slit square", {{"Cell size", "0.125"}})
    ->create(mesh);
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned() && cell->center()[1] > 0.5 &&
        cell->center()[0] < 0.5)
      cell->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
  Fields<2> fields(mesh, {false, 1});
  fields.distribute();
  LinearAlgebra::Vector owned = fields.owned_vector(fields.elastic_dofs);
  for (const auto &cell : fields.elastic.active_cell_iterators())
    if (cell->is_locally_owned())
      for (const unsigned int v : cell->vertex_indices())
        if (const auto dof = cell->vertex_dof_index(v, 1);
            fields.elastic_dofs.owned.is_element(dof))
          owned(dof) =
            cell->center()[1] > 0.5 && cell->vertex(v)[0] < 0.49 ? 1. : 0.;
  owned.compress(dealii::VectorOperation::insert);
  LinearAlgebra::Vector elastic = fields.ghosted_vector(fields.elastic_dofs);
  elastic                       = owned;
  PointDisplacements<2> displacements(
    fields,
    points<2>("finer : 0.1875, 0.5 ; both : 0.25, 0.5 ; side : 0.2, 0.5 ; "
              "mouth : 0, 0.5 ; tip : 0.5, 0.5 ; above : 0.25, 0.625"));
  displacements.reinit();
  const std::vector<double> found      = displacements.evaluate(elastic);
  const double              expected[] = {0.5, 0.5, 0.5, 0.5, 0., 1.};
  for (unsigned int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(found[2 * i], 0.) << i;
    EXPECT_NEAR(found[2 * i + 1], expected[i], 1e-14) << i;
  }
}



TEST(PointDisplacementEntries, NameTheColumns)
{
  OpenedBody<3>               body(/*mixed=*/false);
  const PointDisplacements<3> displacements(
    body.fields, points<3>(" right  corner : 1,1,1 ; b-2 : 0, 0, 0"));
  EXPECT_EQ(displacements.column_names(),
            (std::vector<std::string>{"right_corner_x_mm",
                                      "right_corner_y_mm",
                                      "right_corner_z_mm",
                                      "b-2_x_mm",
                                      "b-2_y_mm",
                                      "b-2_z_mm"}));
  EXPECT_TRUE(points<2>("").empty());
}
