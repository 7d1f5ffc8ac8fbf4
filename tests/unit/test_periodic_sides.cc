// SPDX-License-Identifier: GPL-2.0-or-later
// Periodic sides: faces in any orientation, finer on one side than on the
// other, corners, supports that meet them. An affine displacement E x fits any
// of them, and fits nothing else than the right partners.
#include <base/errors.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <discretization/constraints.h>
#include <discretization/free_motions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <numeric>
#include <set>

using namespace MixedCracks;
using namespace dealii;

namespace
{
  template <int dim>
  using Mesh        = parallel::distributed::Triangulation<dim>;
  using FieldVector = MixedCracks::LinearAlgebra::Vector;

  // no entry is 0, not symmetric
  template <int dim>
  Tensor<2, dim>
  strain(const double time)
  {
    Tensor<2, dim> result;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        result[i][j] = time * (0.1 + 0.3 * i - 0.2 * j * j);
    return result;
  }

  // the first @p n pairs of sides of a box with the ids of deal.II
  template <int dim>
  Periodicity<dim>
  periodicity(const unsigned int n)
  {
    Periodicity<dim> result{{}, strain<dim>};
    for (unsigned int i = 0; i < n; ++i)
      result.pairs.push_back({{{2 * i, 2 * i + 1}},
                              {{"side " + std::to_string(2 * i),
                                "side " + std::to_string(2 * i + 1)}}});
    return result;
  }

  template <int dim>
  FieldVector
  affine(const Fields<dim> &fields, const Tensor<2, dim> &gradient)
  {
    std::vector<std::function<double(const Point<dim> &)>> parts(
      fields.elastic.get_fe().n_components(),
      [](const Point<dim> &) { return 0.; });
    for (unsigned int d = 0; d < dim; ++d)
      parts[d] = [gradient, d](const Point<dim> &point) {
        return gradient[d] * Tensor<1, dim>(point);
      };
    FieldVector result = fields.owned_vector(fields.elastic_dofs);
    VectorTools::interpolate(fields.mapping,
                             fields.elastic,
                             FunctionFromFunctionObjects<dim>(parts),
                             result);
    return result;
  }

  // how far fit() moves E x
  template <int dim>
  double
  change_of_affine(const Fields<dim>      &fields,
                   const Constraints<dim> &constraints)
  {
    FieldVector state = affine(fields, strain<dim>(2.));
    FieldVector fitted(state);
    constraints.fit(2., fitted);
    fitted.add(-1., state);
    return fitted.linfty_norm();
  }

  // what a body at rest has to follow
  double
  change_by_fit_of_zero(const Fields<2>      &fields,
                        const Constraints<2> &constraints)
  {
    FieldVector state = fields.owned_vector(fields.elastic_dofs);
    constraints.fit(2., state);
    return state.linfty_norm();
  }
} // namespace



TEST(PeriodicSides, FacesInEveryOrientation)
{
  std::array<unsigned int, 8> turned;
  std::iota(turned.begin(), turned.end(), 0);
  const auto is_edge = [](const unsigned int a, const unsigned int b) {
    const unsigned int difference = a ^ b;
    return difference == 1 || difference == 2 || difference == 4;
  };
  // deal.II 9.4 makes connectivities of these three that are not valid for
  // p4est, as its Debug build says
  const std::set<std::array<unsigned int, 8>> not_for_forests = {
    {{3, 2, 1, 0, 7, 6, 5, 4}},
    {{5, 4, 7, 6, 1, 0, 3, 2}},
    {{7, 6, 3, 2, 5, 4, 1, 0}}};
  unsigned int n_turned = 0;
  do
  {
    if (not_for_forests.count(turned) > 0)
      continue;
    bool is_of_cube = true;
    for (unsigned int a = 0; a < 8; ++a)
      for (unsigned int b = 0; b < 8; ++b)
        is_of_cube &= is_edge(a, b) == is_edge(turned[a], turned[b]);
    std::vector<Point<3>> vertices;
    for (unsigned int x = 0; x < 3; ++x)
      for (unsigned int v = 0; v < 4; ++v)
        vertices.emplace_back(x, v % 2, v / 2);
    const auto vertex = [](const unsigned int x, const unsigned int v) {
      return 4 * (x + v % 2) + v / 2;
    };
    std::vector<CellData<3>> cells(2);
    for (unsigned int v = 0; v < 8; ++v)
    {
      cells[0].vertices[v] = vertex(0, v);
      cells[1].vertices[v] = vertex(1, turned[v]);
    }
    // a mirrored cell is none
    const auto at = [&](const unsigned int v) {
      return vertices[cells[1].vertices[v]];
    };
    if (!is_of_cube ||
        cross_product_3d(at(1) - at(0), at(2) - at(0)) * (at(4) - at(0)) < 0.)
      continue;
    Mesh<3> mesh(MPI_COMM_WORLD);
    mesh.create_triangulation(vertices, cells, SubCellData());
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(face->center()[0] < 0.1   ? 0
                              : face->center()[0] > 1.9 ? 1
                                                        : 2);
    const PeriodicSides<3> sides(mesh, periodicity<3>(1).pairs);
    ASSERT_LT((sides.periods()[0] - Tensor<1, 3>({2., 0., 0.})).norm(), 1e-12);
    mesh.add_periodicity(sides.faces(mesh));
    mesh.refine_global(1);
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned() && cell->center().norm() < 0.6)
        cell->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
    Fields<3>      fields(mesh, {true, 2});
    Constraints<3> constraints(fields, {}, {}, periodicity<3>(1));
    fields.distribute();
    constraints.reinit();
    EXPECT_LT(change_of_affine(fields, constraints), 1e-12);
    ++n_turned;
  } while (std::next_permutation(turned.begin(), turned.end()));
  EXPECT_EQ(n_turned, 21u);
}



// Refined at a corner and at a side, where the other side is coarser.
TEST(PeriodicSides, CornersAndFinerSides)
{
  Mesh<2> mesh(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(
    mesh, {4, 3}, Point<2>(), Point<2>(2., 1.), true);
  const PeriodicSides<2> sides(mesh, periodicity<2>(2).pairs);
  mesh.add_periodicity(sides.faces(mesh));
  for (const Point<2> &place : {Point<2>(2., 1.), Point<2>(0., 0.5)})
  {
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned() && cell->center().distance(place) < 0.3)
        cell->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
  }
  Fields<2>      fields(mesh, {false, 1});
  Constraints<2> constraints(fields, {}, {}, periodicity<2>(2));
  fields.distribute();
  constraints.reinit();
  EXPECT_LT(change_of_affine(fields, constraints), 1e-13);
  // of the rest of the body 0, of what depends on it (E L)
  EXPECT_GT(change_by_fit_of_zero(fields, constraints), 0.1);
  EXPECT_EQ(constraints.held_components(), std::vector<unsigned int>({0, 1}));
  EXPECT_DOUBLE_EQ(sides.cell_volume(mesh), 2.);
}



// Forces of both sides end up where the equations are, and nothing is lost.
TEST(PeriodicSides, ForcesAreMovedToIndependentNodes)
{
  Mesh<2> mesh(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(
    mesh, {4, 4}, Point<2>(), Point<2>(1., 1.), true);
  const PeriodicSides<2> sides(mesh, periodicity<2>(2).pairs);
  mesh.add_periodicity(sides.faces(mesh));
  Fields<2>      fields(mesh, {false, 1});
  Constraints<2> constraints(fields, {}, {}, periodicity<2>(2));
  fields.distribute();
  constraints.reinit();
  FieldVector forces  = fields.owned_vector(fields.elastic_dofs);
  forces              = 1.;
  const double before = forces.mean_value() * forces.size();
  constraints.periodic().fold(forces);
  EXPECT_NEAR(forces.mean_value() * forces.size(), before, 1e-12 * before);
  for (const auto &partner : constraints.periodic().partners())
    if (fields.elastic_dofs.owned.is_element(partner.slave))
    {
      EXPECT_EQ(forces(partner.slave), 0.);
    }
}



TEST(PeriodicSides, OnlyTranslationsAreLeftFree)
{
  using Words = std::vector<std::string>;
  Mesh<2> square(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(
    square, {2, 2}, Point<2>(), Point<2>(1., 1.), true);
  EXPECT_EQ(
    free_rigid_motions(square, {}, {}, {square, periodicity<2>(1).pairs}),
    Words({"the body can move in x and y"}));
  Mesh<3> bar(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(
    bar, {2, 2, 2}, Point<3>(), Point<3>(1., 1., 1.), true);
  EXPECT_EQ(free_rigid_motions(bar, {}, {}, {bar, periodicity<3>(1).pairs}),
            Words({"the body can move in x and y and z",
                   "the body can rotate about the axis in x through (0.5, 0.5, "
                   "0.5)"}));
  EXPECT_EQ(free_rigid_motions(bar, {}, {}, {bar, periodicity<3>(2).pairs}),
            Words({"the body can move in x and y and z"}));
}



// What is prescribed at one image holds at the other; contradictions are found.
TEST(PeriodicSides, SupportsThatMeetThem)
{
  Mesh<2> mesh(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(
    mesh, {4, 4}, Point<2>(), Point<2>(1., 1.), true);
  const PeriodicSides<2> sides(mesh, periodicity<2>(1).pairs);
  mesh.add_periodicity(sides.faces(mesh));
  Fields<2> fields(mesh, {false, 1});
  fields.distribute();
  const auto at_bottom = [&](const double slope) {
    const std::vector<std::function<double(const Point<2> &)>> parts = {
      [slope](const Point<2> &point) { return slope * point[0]; },
      [](const Point<2> &) { return 0.; }};
    return PrescribedComponent<2>{
      2, 0, std::make_shared<FunctionFromFunctionObjects<2>>(parts)};
  };
  const double jump = strain<2>(1.)[0][0];
  for (const double slope : {jump, 0.5 * jump})
  {
    Constraints<2> constraints(
      fields, {at_bottom(slope)}, {}, periodicity<2>(1));
    constraints.reinit();
    EXPECT_EQ(constraints.held_components(), std::vector<unsigned int>({1}));
    FieldVector state = fields.owned_vector(fields.elastic_dofs);
    if (slope == jump)
      EXPECT_NO_THROW(constraints.apply_prescribed(1., state));
    else
      EXPECT_THROW(constraints.apply_prescribed(1., state), InputError);
  }
}
